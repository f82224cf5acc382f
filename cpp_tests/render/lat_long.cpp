#include "lat_long.hpp"

#include <algorithm>
#include <numeric>

namespace render {
namespace {

int clampIndex(float x, int count) { return std::clamp(static_cast<int>(std::floor(x)), 0, count - 1); }

} // namespace

LatLongMap readLatLongMap(const std::filesystem::path &file) {
    RadianceImage image = readRadiance(file, "environment");
    return {image.width, image.height, std::move(image.texels)};
}

V3f latLongDirection(float u, float cosTheta) {
    const float sinTheta = std::sqrt(std::max(0.0f, 1 - cosTheta * cosTheta)), phi = (u - 0.5f) * 2 * pi;
    return {sinTheta * std::sin(phi), cosTheta, -sinTheta * std::cos(phi)};
}

V2f latLongPoint(const V3f &direction) {
    return {0.5f + std::atan2(direction.x, -direction.z) / (2 * pi),
            std::acos(std::clamp(direction.y, -1.0f, 1.0f)) / pi};
}

LatLongLight::LatLongLight(LatLongMap map)
    : map_(std::move(map)) {
    const int width = map_.width, height = map_.height;
    // The importance of a texel is the luminance of the bilinear interpolant, integrated over it,
    // which weighs neighbours 1/8, 6/8, 1/8 along each axis: never 0 where there is light.
    const auto along = [](float before, float here, float after) { return (before + 6 * here + after) / 8; };
    const auto across = [&](int column, int row) {
        return along(luminance(texel(column - 1, row)), luminance(texel(column, row)),
                     luminance(texel(column + 1, row)));
    };
    const auto rowCosine = [&](int row) { return std::cos(static_cast<double>(pi) * row / height); };

    std::vector<double> rowWeights;
    rowCosine_.push_back(1);
    for (int row = 0; row < height; ++row) {
        const double solidAngle = 2 * pi * (rowCosine(row) - rowCosine(row + 1)) / width;
        rowCosine_.push_back(static_cast<float>(rowCosine(row + 1)));
        rowSolidAngle_.push_back(static_cast<float>(solidAngle));

        std::vector<double> weights;
        for (int column = 0; column < width; ++column)
            weights.push_back(along(across(column, row - 1), across(column, row), across(column, row + 1)));
        columns_.emplace_back(weights);
        rowWeights.push_back(std::accumulate(weights.begin(), weights.end(), 0.0) * solidAngle);
    }
    rows_ = Distribution(rowWeights);
}

Rgb LatLongLight::radiance(const V3f &direction) const { return radianceAt(latLongPoint(direction)); }

// Inverts the marginal distribution of the rows, then the row's own (M. Pharr, W. Jakob and
// G. Humphreys, "Physically Based Rendering", 4th edition, section 12.5.2), and is uniform
// in solid angle within a texel.
LightSample LatLongLight::sample(const V2f &u) const {
    const Distribution::Point row = rows_.invert(u.y);
    const Distribution::Point column = columns_[row.cell].invert(u.x);
    const float cosTheta = lerp(rowCosine_[row.cell], rowCosine_[row.cell + 1], row.offset);
    const V2f uv((static_cast<float>(column.cell) + column.offset) / static_cast<float>(map_.width),
                 std::acos(cosTheta) / pi);
    return {latLongDirection(uv.x, cosTheta), radianceAt(uv), texelPdf(column.cell, row.cell)};
}

float LatLongLight::pdf(const V3f &direction) const {
    const V2f uv = latLongPoint(direction);
    return texelPdf(clampIndex(uv.x * static_cast<float>(map_.width), map_.width),
                    clampIndex(uv.y * static_cast<float>(map_.height), map_.height));
}

/// Columns wrap, rows end at the poles.
Rgb LatLongLight::texel(int column, int row) const {
    if (column < 0) column += map_.width;
    if (column >= map_.width) column -= map_.width;
    row = std::clamp(row, 0, map_.height - 1);
    return map_.texels[static_cast<std::size_t>(row) * map_.width + column];
}

Rgb LatLongLight::radianceAt(const V2f &uv) const {
    const float x = uv.x * static_cast<float>(map_.width) - 0.5f;
    const float y = uv.y * static_cast<float>(map_.height) - 0.5f;
    const int column = static_cast<int>(std::floor(x)), row = static_cast<int>(std::floor(y));
    const float s = x - std::floor(x), t = y - std::floor(y);
    return (texel(column, row) * (1 - s) + texel(column + 1, row) * s) * (1 - t) +
           (texel(column, row + 1) * (1 - s) + texel(column + 1, row + 1) * s) * t;
}

/// 0 everywhere if the map is black.
float LatLongLight::texelPdf(int column, int row) const {
    return rows_.probability(row) * columns_[row].probability(column) / rowSolidAngle_[row];
}

} // namespace render
