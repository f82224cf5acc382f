// Texture coordinates for a mesh that has none.
#pragma once

#include "mesh.hpp"

namespace render {

/// Cuts the mesh into charts, patches that face the same one of the six directions of the axes, lays
/// each flat by looking along that direction, and packs them into the unit square. No two charts share
/// a texel of an image of `size` x `size`; `gap` texels are left around each, fewer if there are too many
/// charts.
Mesh unwrapped(Mesh mesh, int size, int gap);

} // namespace render
