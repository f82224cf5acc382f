// A point of a surface, as materials see it.
#pragma once

#include "frame.hpp"

namespace render {

struct SurfacePoint {
    V3f position;        ///< world space
    V3f geometricNormal; ///< unit; towards the outside
    Frame shading;       ///< its normal interpolated; towards the outside
    V2f uv;
    /// Where procedural patterns live: a mesh's own coordinates, a sphere's made to have radius 1.
    V3f objectPosition;
};

} // namespace render
