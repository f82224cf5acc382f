// An environment seen by rough mirrors that face it.
#pragma once

#include "environment.hpp"
#include "lat_long_texture.hpp"

namespace render {

/// The first factor of B. Karis, "Real Shading in Unreal Engine 4", SIGGRAPH 2013 course: the mean of the
/// radiance over the lobe that pellicle_bsdf_sample() has for wo = n, the texel's direction, weighted by <n, wi>.
/// `pairs` of such samples and of as many of the light make up a texel, as samples of the lobe alone miss the
/// sun. `roughness` is above 0; `threads` 0: one per core.
LatLongMap prefiltered(const Environment &environment, float roughness, int height, int pairs, int threads = 0);

/// Prefiltered for roughnesses at equal steps from 0 to 1, each with the texels that its lobe needs: the mip
/// map of real-time renderers, whose sizes are too coarse for some roughnesses and too fine for others.
class PrefilteredEnvironment {
public:
    static constexpr int steps = 10;

    /// Writes the maps as parts of `file`, from where they are read; the first is `map` itself. Throws
    /// std::runtime_error.
    PrefilteredEnvironment(const LatLongMap &map, const std::filesystem::path &file, int threads = 0);

    /// Linear between the roughnesses.
    Rgb radiance(const V3f &direction, float roughness) const;

private:
    LatLongTexture texture_;
};

} // namespace render
