// Maps for a mesh from patterns in space: what texture-painting programs call baking.
#pragma once

#include "maps.hpp"
#include "mesh.hpp"

namespace render {

/// A place of a mesh, as a finish sees it.
struct BakePoint {
    V3f position, normal;
    /// How far the neighbourhood bends towards the normal's side: positive in hollows, negative on
    /// ridges, about 1 in size where that is strong.
    float hollowness;
};

using SolidFinish = std::function<Finish(const BakePoint &point)>;

/// The finish of every texel that the mesh's texture coordinates cover, and the normals of its relief in
/// the mesh's tangent frames. Texels up to `gap` beside them repeat the nearest, the others are the mean.
struct BakedMaps {
    FinishImage image;
    std::vector<V3f> normals;
    int overlaps; ///< texels that two distant places of the mesh claim
};
BakedMaps bake(const Mesh &mesh, int size, int gap, const SolidFinish &finish);

/// Bronze as statues have it: polished where it sticks out, brown, and green in its hollows.
Finish patinatedBronze(const BakePoint &point);

} // namespace render
