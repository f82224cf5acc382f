// Light from infinitely far away, given by a latitude-longitude map.
#pragma once

#include "distribution.hpp"
#include "math.hpp"

#include <filesystem>
#include <vector>

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

class Environment {
public:
    explicit Environment(LatLongMap map);

    /// The same radiance from everywhere.
    static Environment constant(const Rgb &radiance) { return Environment({1, 1, {radiance}}); }

    /// Bilinear between the centres of the texels.
    Rgb radiance(const V3f &direction) const;

    struct Sample {
        V3f direction;
        Rgb radiance;
        float pdf; ///< per solid angle; 0: no sample
    };
    Sample sample(const V2f &u) const;
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
