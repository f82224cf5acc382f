#include "glossy_metal.hpp"

namespace render {

pellicle::Bsdf glossyMetal(float roughness, const Rgb &f0, const Rgb &f90) {
    return pellicle::BsdfBuilder("microfacet")
        .set("alpha", roughness * roughness)
        .set("f0", &f0.x, 3)
        .set("f90", &f90.x, 3)
        .create();
}

} // namespace render
