// A sphere seen from far away, without a renderer: a normal for every pixel.
#pragma once

#include "frame.hpp"

#include <vector>

namespace render {

struct SpherePixel {
    V2i at;
    Frame frame;
};

/// From where the sphere is seen; the same for all its points.
inline const V3f sphereToViewer(0, 0, 1);

/// Those of a picture of `size` x `size` pixels whose centres are on the sphere, which fills it; rows from
/// the top.
std::vector<SpherePixel> spherePixels(int size);

} // namespace render
