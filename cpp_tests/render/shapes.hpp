// Meshes made by formula.
#pragma once

#include "mesh.hpp"

namespace render {

/// The horizontal square with corners +-half at y = 0, facing up.
Mesh square(float half);

/// A flat disc.
Mesh disc(const V3f &centre, const V3f &normal, float radius);

/// A torus around that disc: a wire of `thickness`, twice its radius.
Mesh ring(const V3f &centre, const V3f &normal, float radius, float thickness);

} // namespace render
