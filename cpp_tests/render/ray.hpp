// A half-line.
#pragma once

#include "math.hpp"

namespace render {

struct Ray {
    V3f origin, direction; ///< direction has unit length
    /// Radians: the cone that stands for the ray's pixel. 0 after scattering: textures are then read
    /// in full detail and the samples average them.
    float spread = 0;
};

/// The ray from a surface into `direction`, its origin moved along the geometric normal by a few
/// units in the last place, which is just enough not to hit the same surface again.
Ray leaveSurface(const V3f &position, const V3f &geometricNormal, const V3f &direction);

} // namespace render
