// Light from infinitely far away, given by a latitude-longitude map.
#pragma once

#include "distribution.hpp"
#include "image_file.hpp"

namespace render {

/// Rows run from the zenith (+y) to the nadir, columns once around; the middle column is at -z,
/// where the camera looks, and columns to its right are towards +x.
struct LatLongMap {
    int width, height;
    std::vector<Rgb> texels;
};

/// Any image that OpenImageIO reads, converted to linear colours. Throws std::runtime_error.
LatLongMap readLatLongMap(const std::filesystem::path &file);

/// The direction of a point of the map: `u` in [0, 1] from its left edge, and the cosine of the
/// angle to the zenith.
V3f latLongDirection(float u, float cosTheta);

/// Its inverse: where a direction is, in [0, 1] from the map's left and upper edges.
V2f latLongPoint(const V3f &direction);

/// A map with the radiance's value at each texel's centre; twice as wide as high.
template <typename Radiance>
LatLongMap drawLatLong(int height, const Radiance &radiance) {
    LatLongMap map{2 * height, height, {}};
    map.texels.reserve(static_cast<std::size_t>(map.width) * map.height);
    for (int row = 0; row < map.height; ++row) {
        const float cosTheta =
            std::cos(pi * (static_cast<float>(row) + 0.5f) / static_cast<float>(map.height));
        for (int column = 0; column < map.width; ++column)
            map.texels.push_back(radiance(latLongDirection(
                (static_cast<float>(column) + 0.5f) / static_cast<float>(map.width), cosTheta)));
    }
    return map;
}

/// A direction chosen by an environment's importance.
struct LightSample {
    V3f direction; ///< unit, towards the light
    Rgb radiance;
    float pdf; ///< per solid angle; 0: no sample
};

class LatLongLight {
public:
    explicit LatLongLight(LatLongMap map);

    /// The same radiance from everywhere.
    static LatLongLight constant(const Rgb &radiance) { return LatLongLight(LatLongMap{1, 1, {radiance}}); }

    /// Bilinear between the centres of the texels.
    Rgb radiance(const V3f &direction) const;

    /// Importance sampling: the density is nearly proportional to the luminance.
    using Sample = LightSample;
    LightSample sample(const V2f &u) const;
    float pdf(const V3f &direction) const;

private:
    Rgb texel(int column, int row) const;
    Rgb radianceAt(const V2f &uv) const;
    float texelPdf(int column, int row) const;

    LatLongMap map_;
    std::vector<Distribution> columns_; ///< within each row
    Distribution rows_{{}};
    std::vector<float> rowCosine_;     ///< of the angle to the zenith, at the rows' edges: height + 1
    std::vector<float> rowSolidAngle_; ///< of one texel
};

} // namespace render
