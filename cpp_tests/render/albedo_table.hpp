// The directional albedo of a rough metal, tabulated.
#pragma once

#include "math.hpp"

#include <vector>

namespace render {

/// The second factor of B. Karis, "Real Shading in Unreal Engine 4", SIGGRAPH 2013 course: Schlick's Fresnel
/// factor is linear in f0 and f90, and so is the albedo. Made by pellicle_bsdf_albedo() for f0 = 1 and
/// f90 = 0, and the other way round.
class AlbedoTable {
public:
    /// Throws pellicle::Error. `threads` 0: one per core.
    explicit AlbedoTable(int threads = 0);

    /// The factors of f0 and of f90, bilinear, to 2e-3, and to 1.2e-2 for cosines below 0.1; `cosine` and
    /// `roughness` in [0, 1].
    V2f at(float cosine, float roughness) const;

private:
    std::vector<V2f> values_; ///< cosines within roughnesses
};

} // namespace render
