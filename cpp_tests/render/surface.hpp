// A point of a surface, as materials see it.
#pragma once

#include "frame.hpp"

#include <array>

namespace render {

struct SurfacePoint {
    V3f position;        ///< world space
    V3f geometricNormal; ///< unit; towards the outside
    Frame shading;       ///< its normal interpolated; towards the outside
    V2f uv{0};
    /// How the position changes with u and with v; 0 where a mesh has no texture coordinates.
    V3f alongU{0}, alongV{0};
    /// The pixel's outline on the surface, as two directions of one pixel's length in texture
    /// coordinates; 0 for rays that were scattered.
    std::array<V2f, 2> footprint{V2f(0), V2f(0)};
    /// Where procedural patterns live: a mesh's own coordinates, a sphere's made to have radius 1.
    V3f objectPosition;
};

} // namespace render
