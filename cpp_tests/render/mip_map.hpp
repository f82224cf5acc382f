// An environment with all its smaller sizes: the mean radiance of any solid angle, nearly.
#pragma once

#include "lat_long_texture.hpp"

namespace render {

/// The map and its halvings, down to a height of one. Texels are averaged by their solid angles. Throws
/// std::invalid_argument if a side is not a power of two, or the width not twice the height.
std::vector<LatLongMap> mipLevels(LatLongMap map);

class MipMap {
public:
    /// Writes the levels into `file`, from where they are read. Throws std::runtime_error and as
    /// mipLevels().
    MipMap(const LatLongMap &map, const std::filesystem::path &file);

    /// The mean over about `solidAngle`, sr, around a direction; 0 is the map itself.
    Rgb radiance(const V3f &direction, float solidAngle) const;

private:
    LatLongTexture texture_;
    int height_;
};

} // namespace render
