#include "bsdfs.hpp"

namespace bsdfs {

std::string simd_level;

pellicle::BsdfBuilder of(const char *model) {
    pellicle::BsdfBuilder builder(model);
    return simd_level.empty() ? builder : builder.simd_level(simd_level);
}

pellicle::FilmBuilder on(pellicle::Medium base) {
    pellicle::FilmBuilder builder(std::move(base));
    return simd_level.empty() ? builder : builder.simd_level(simd_level);
}

pellicle::BsdfBuilder layered() {
    return of("layered")
        .set("eta", material::layer_eta, 3)
        .set("exponent_reflection", material::exponent_reflection)
        .set("exponent_transmission", material::exponent_transmission)
        .set("thickness_nm", material::layer_nm)
        .set("base_normal", material::deviation, 3)
        .set("specular_weight", 1.0f)
        .set("diffuse_weight", 0.0f)
        .choose("variant", "paper");
}

pellicle::BsdfBuilder ggx(const char *fresnel, float alpha) {
    return of("microfacet").set("alpha", alpha).choose("fresnel", fresnel);
}

pellicle::Bsdf conductor() {
    return ggx("conductor").set("eta", material::metal_eta, 3).set("k", material::metal_k, 3).create();
}

pellicle::Film coating() {
    return on(pellicle::Medium::constant(material::film_base_eta, material::film_base_k))
        .layer(pellicle::Medium::constant(material::film_eta), 0.0f, material::greatest_nm)
        .create();
}

pellicle::Film soap() {
    return on(pellicle::Medium::constant(1.0f))
        .layer(pellicle::Medium::constant(material::film_eta), 0.0f, material::greatest_nm)
        .create();
}

pellicle::Film fixed_soap() {
    return on(pellicle::Medium::constant(1.0f))
        .layer(pellicle::Medium::constant(material::film_eta), material::fixed_nm)
        .create();
}

} // namespace bsdfs
