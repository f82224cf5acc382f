// Latitude-longitude maps in a file, looked up by OpenImageIO's texture system.
#pragma once

#include "lat_long.hpp"

#include <OpenImageIO/texture.h>

#include <filesystem>
#include <memory>
#include <vector>

namespace render {

/// How the maps of a file belong together.
enum class Layout {
    levels, ///< of one mip map: each half as wide and high as the one before
    parts,  ///< of any size, each for itself
};

class LatLongTexture {
public:
    /// Writes the maps into one tiled file, in single precision, which look-ups then read through
    /// OpenImageIO's cache: EXR for levels, TIFF for parts, as those of an EXR file share one size. Throws
    /// std::runtime_error.
    LatLongTexture(const std::vector<LatLongMap> &maps, Layout layout, const std::filesystem::path &file);

    /// Bilinear between the centres of the texels, and with Layout::levels linear between levels; a
    /// whole `level` is that level alone. From any thread.
    Rgb radiance(const V3f &direction, int part, float level) const;

private:
    std::shared_ptr<OIIO::TextureSystem> system_;
    OIIO::TextureSystem::TextureHandle *handle_;
    float height_; ///< of the first map
};

} // namespace render
