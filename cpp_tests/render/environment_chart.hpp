// The comparison of three ways to the reflection of an environment, as a picture.
#pragma once

#include "environment_ways.hpp"

#include <OpenImageIO/imagebuf.h>

namespace render {

struct EnvironmentChart {
    std::string name;        ///< of its files, and for --scene
    std::string caption;     ///< lines end in \n
    std::string environment; ///< for comparedMap()
    float exposure;          ///< stops
};

/// One for each environment that is compared.
const std::vector<EnvironmentChart> &environmentCharts();

/// Spheres of gold, linear: importance sampling, filtered sampling and the split sum below one another, their
/// roughness 0, 0.1 and so on to 1 from left to right.
struct EnvironmentSpheres {
    OIIO::ImageBuf radiance;
    std::vector<Deviation> filtered, splitSum; ///< of each column
};
/// Writes maps into `directory`, which is made if missing. Throws std::runtime_error.
EnvironmentSpheres environmentSpheres(const EnvironmentChart &chart, const AlbedoTable &albedo, int size,
                                      const std::filesystem::path &directory, int threads = 0);

/// As a page, for display: the three rows, then the differences from the first, with grey for none and the relative
/// errors below. Without the font (Debian: fonts-dejavu-core) without text.
OIIO::ImageBuf displaySpheres(const EnvironmentSpheres &spheres, float exposure);

} // namespace render
