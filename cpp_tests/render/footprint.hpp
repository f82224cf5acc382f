// How much of a texture a pixel sees.
#pragma once

#include "ray.hpp"
#include "surface.hpp"

#include <array>

namespace render {

/// The derivatives of a triangle's positions by its texture coordinates; 0 if these do not span a plane.
struct TextureTangents {
    V3f alongU, alongV;
};
TextureTangents textureTangents(const std::array<V3f, 3> &positions, const std::array<V2f, 3> &uvs);

/// The ray's cone, one pixel wide, cut by the surface's tangent plane `distance` along the ray: its two
/// axes in texture coordinates (T. Akenine-Moeller, C. Crassin, J. Boksansky, L. Belcour, A. Panteleev
/// and O. Wright, "Improved Shader and Texture Level of Detail Using Ray Cones", JCGT 10(1), 2021,
/// section 4). 0 where there are no texture coordinates or the ray has no spread.
std::array<V2f, 2> footprintOf(const SurfacePoint &point, const Ray &ray, float distance);

} // namespace render
