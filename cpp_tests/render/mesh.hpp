// A triangle mesh, from a Wavefront OBJ file.
#pragma once

#include "math.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace render {

struct Mesh {
    using Triangle = std::array<std::uint32_t, 3>;

    std::vector<V3f> positions;
    std::vector<Triangle> triangles;         ///< indices of positions
    std::vector<std::array<V3f, 3>> normals; ///< of each triangle's corners, unit length
    std::vector<std::array<V2f, 3>> uvs;     ///< of each triangle's corners, 0 where the file has none
};

/// Polygons are cut into triangles; corners without a normal get a smooth one. Throws
/// std::runtime_error with the file's name, and the line where one is known.
Mesh readObj(const std::filesystem::path &file);

/// Gives every corner the smooth normal of its vertex.
void smooth(Mesh &mesh);

/// Scales and moves a mesh so that it stands on y = 0 and fits between x, z = +-1 and y = 2.
void standOnFloor(Mesh &mesh);

} // namespace render
