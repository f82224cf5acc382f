#include "mip_map.hpp"

#include <algorithm>
#include <stdexcept>

namespace render {
namespace {

bool isPowerOfTwo(int n) { return n > 0 && (n & (n - 1)) == 0; }

LatLongMap half(const LatLongMap &map) {
    LatLongMap result{map.width / 2, map.height / 2, {}};
    const auto cosine = [&](int row) {
        return std::cos(pi * static_cast<float>(row) / static_cast<float>(map.height));
    };
    for (int row = 0; row < result.height; ++row) {
        const float upper = cosine(2 * row) - cosine(2 * row + 1), lower = cosine(2 * row + 1) - cosine(2 * row + 2);
        const float share = upper / (upper + lower);
        const auto mean = [&](int sourceRow, int column) {
            const Rgb *texel = &map.texels[static_cast<std::size_t>(sourceRow) * map.width + 2 * column];
            return (texel[0] + texel[1]) * 0.5f;
        };
        for (int column = 0; column < result.width; ++column)
            result.texels.push_back(mean(2 * row, column) * share + mean(2 * row + 1, column) * (1 - share));
    }
    return result;
}

} // namespace

std::vector<LatLongMap> mipLevels(LatLongMap map) {
    if (!isPowerOfTwo(map.height) || map.width != 2 * map.height)
        throw std::invalid_argument("a mip map needs a height that is a power of two, and twice the width");
    std::vector<LatLongMap> levels{std::move(map)};
    while (levels.back().height > 1) levels.push_back(half(levels.back()));
    return levels;
}

MipMap::MipMap(const LatLongMap &map, const std::filesystem::path &file)
    : texture_(mipLevels(map), Layout::levels, file),
      height_(map.height) {}

/// A level's texel covers 4^level times a texel of the map (M. Colbert and J. Krivanek, "GPU-Based Importance
/// Sampling", GPU Gems 3, 2007, section 20.4), which becomes narrow towards the poles.
Rgb MipMap::radiance(const V3f &direction, float solidAngle) const {
    const float rows = static_cast<float>(height_), sine = std::sqrt(std::max(0.0f, 1 - direction.y * direction.y));
    // At the poles, that of the last row.
    const float texel = pi * pi / (rows * rows) * std::max(sine, pi / (2 * rows));
    const float level = 0.5f * std::log2(std::max(solidAngle / texel, 1.0f));
    return texture_.radiance(direction, 0, std::min(level, std::log2(rows)));
}

} // namespace render
