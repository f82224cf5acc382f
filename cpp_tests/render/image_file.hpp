// Images of light, from files.
#pragma once

#include "math.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace render {

/// Linear radiance, rows from the top; never negative nor infinite.
struct RadianceImage {
    int width, height;
    std::vector<Rgb> texels;
};

/// Any image that OpenImageIO reads: those it knows to be sRGB are decoded, grey ones get three equal
/// channels. `what` begins the error. Throws std::runtime_error.
RadianceImage readRadiance(const std::filesystem::path &file, const std::string &what);

/// Linear, in the precision that the format has: for EXR and HDR. Throws
/// std::runtime_error.
void writeRadiance(const RadianceImage &image, const std::filesystem::path &file);

/// With those above it, if missing. Throws std::runtime_error.
void makeDirectory(const std::filesystem::path &directory);

} // namespace render
