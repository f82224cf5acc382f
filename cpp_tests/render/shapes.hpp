// Meshes made by formula.
#pragma once

#include "mesh.hpp"

#include <functional>

namespace render {

/// The horizontal square with corners +-half at y = 0, facing up.
Mesh square(float half);

/// A flat disc.
Mesh disc(const V3f &centre, const V3f &normal, float radius);

/// A torus around that disc: a wire of `thickness`, twice its radius.
Mesh ring(const V3f &centre, const V3f &normal, float radius, float thickness);

/// The surface (u, v) -> `at`, u and v from 0 to 1 in `columns` and `rows` steps, with smooth normals. Where it is
/// closed, 1 is the same vertex as 0. Normals point along the cross product of the derivatives by u and v.
struct Grid {
    std::uint32_t columns, rows;
    bool closedInU = false, closedInV = false;
};
Mesh gridMesh(const Grid &grid, const std::function<V3f(float u, float v)> &at);

/// A surface of revolution about the vertical axis: its outline is a Catmull-Rom spline (E. Catmull and R. Rom,
/// "A Class of Local Interpolating Splines", 1974) through `outline`, radius and height, from the lower end.
Mesh turned(const std::vector<V2f> &outline);

/// A lens between two spheres of that radius around the vertical axis: `aperture` is its own radius, `edge` the height
/// of its cylindrical rim. Normals are those of the spheres.
Mesh lens(float aperture, float sphere, float edge);

/// Turned so that the vertical axis becomes the horizontal one that points `degrees` from +z towards +x, then moved.
Mesh facing(Mesh mesh, float degrees, const V3f &offset);

} // namespace render
