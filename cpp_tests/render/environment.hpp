// Light from infinitely far away.
#pragma once

#include "cube_map.hpp"
#include "lat_long.hpp"

#include <variant>

namespace render {

/// Given by a map of either kind, each sampled in its own right: nothing is resampled.
class Environment {
public:
    explicit Environment(LatLongMap map)
        : light_(LatLongLight(std::move(map))) {}
    explicit Environment(const CubeMap &map)
        : light_(CubeLight(map)) {}

    /// The same radiance from everywhere.
    static Environment constant(const Rgb &radiance) { return Environment(LatLongMap{1, 1, {radiance}}); }

    Rgb radiance(const V3f &direction) const;

    using Sample = LightSample;
    /// Importance sampling: the density is nearly proportional to the luminance.
    Sample sample(const V2f &u) const;
    float pdf(const V3f &direction) const;

private:
    std::variant<LatLongLight, CubeLight> light_;
};

} // namespace render
