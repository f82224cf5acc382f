// Images on surfaces, read by OpenImageIO's texture system.
#pragma once

#include "pattern.hpp"

#include <OpenImageIO/texture.h>

#include <filesystem>
#include <memory>

namespace render {

/// OpenImageIO's, with its cache. One for the whole program, which never ends it.
std::shared_ptr<OIIO::TextureSystem> sharedTextureSystem();

/// What an image's numbers mean.
enum class Encoding {
    sRgb,   ///< colours, decoded before anything is averaged
    linear, ///< everything else: roughness, metallic, normals
};

/// An image that repeats itself. u runs along its rows from the left, v upwards from its lower edge, as
/// in Wavefront OBJ files.
class Texture {
public:
    /// Reads any image that OpenImageIO reads and writes it beside itself, as FILE.tx: tiled, with all
    /// its smaller sizes, linear, in half precision. That is what look-ups read, through OpenImageIO's
    /// cache. Throws std::runtime_error.
    Texture(const std::filesystem::path &file, Encoding encoding);

    /// The first `channels` channels; an image with fewer repeats its last. The footprint is filtered
    /// (anisotropic, between sizes); without one the look-up is bilinear in the full size. The texture
    /// is seen `repetitions` times along u and v. From any thread.
    void lookUp(const SurfacePoint &point, float repetitions, int channels, float *result) const;

private:
    std::shared_ptr<OIIO::TextureSystem> system_;
    OIIO::TextureSystem::TextureHandle *handle_;
    int channels_;
};

/// A parameter of 1 or 3 components from an image.
Pattern imagePattern(std::shared_ptr<const Texture> texture, int components, float repetitions = 1);

/// A normal map's direction: numbers 0 to 1 mean -1 to 1, x along u, y along v, z outwards (glTF 2.0,
/// section 3.9.3). Lying directions, z <= 0, are raised.
Pattern normalPattern(std::shared_ptr<const Texture> texture, float repetitions = 1);

} // namespace render
