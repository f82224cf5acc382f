// A box with round edges, made by formula.
#pragma once

#include "mesh.hpp"

namespace render {

/// Axis-aligned around the origin with corners +-half, its edges rounded by `radius`. Each face has
/// texture coordinates from 0 to 1, upright and unmirrored from outside, that meet in the middle of the
/// rounding.
Mesh roundedBox(float half, float radius);

/// The mesh turned about the vertical axis, counter-clockwise from above, then moved.
Mesh placed(Mesh mesh, float degrees, const V3f &offset);

} // namespace render
