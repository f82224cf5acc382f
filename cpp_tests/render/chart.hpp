// Newton's chart of a film: its colour over thickness and angle.
#pragma once

#include "stacks.hpp"

#include <OpenImageIO/imagebuf.h>

namespace render {

struct Chart {
    std::string name;    ///< of its file, and for --scene
    std::string caption; ///< lines end in \n
    Stack stack;
    float exposure;      ///< stops
};

constexpr float chartThickness = 1500; ///< nm, at the right edge

/// One for each of stacks().
const std::vector<Chart> &charts();

/// The reflectance, linear: thickness from 0 to chartThickness to the right, the angle of incidence
/// from 0 at the bottom to 90 degrees at the top. Pixels show their centres.
OIIO::ImageBuf reflectanceChart(const Stack &stack, int width, int height);

/// Times 2^`exposure`, sRGB, with axes at its edges: as wide and high as `chart` plus room for them.
/// Without the font (Debian: fonts-dejavu-core) the numbers are left out.
OIIO::ImageBuf displayChart(const OIIO::ImageBuf &chart, float exposure);

} // namespace render
