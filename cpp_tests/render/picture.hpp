// A rendered picture and its files.
#pragma once

#include "math.hpp"

#include <OpenImageIO/imagebuf.h>

#include <filesystem>
#include <vector>

namespace render {

struct Pixel {
    Rgb radiance{0};
    V3f normal{0};      ///< of the first surface, world space
    float distance = 0; ///< to it; 0 where there is none
};

struct Picture {
    int width, height;
    std::vector<Pixel> pixels; ///< rows from the top
};

/// Linear radiance (R G B), normals (N.X N.Y N.Z) and distances (Z), in single precision. Throws
/// std::runtime_error, as does everything here that touches a file.
void writeExr(const Picture &picture, const std::filesystem::path &file);

/// A linear image, in single precision.
void writeExr(const OIIO::ImageBuf &image, const std::filesystem::path &file);

/// A linear image times 2^`exposure`, clipped at 1, sRGB: no tone curve, nothing automatic.
OIIO::ImageBuf displayed(OIIO::ImageBuf linear, float exposure);

/// The same of a picture's radiance.
OIIO::ImageBuf display(const Picture &picture, float exposure);

/// Compresses what is brighter than 0.76 and leaves the rest as it is, hues included: the Khronos PBR Neutral Tone
/// Mapper (Khronos Group, 2024), of a linear image times 2^`exposure`; then sRGB. For photographs of real light.
OIIO::ImageBuf photograph(const Picture &picture, float exposure);

/// 8 bits, for pages.
void writeJpeg(const OIIO::ImageBuf &image, const std::filesystem::path &file);

/// 8 bits, dithered.
void writePng(const OIIO::ImageBuf &image, const std::filesystem::path &file);

} // namespace render
