// Shading normals from a normal map.
#pragma once

#include "surface.hpp"

namespace render {

/// The frame that a normal map's three numbers refer to: x along u and y along v as far as the
/// interpolated normal, z, lets them, orthonormal, left-handed where the texture is mirrored. The
/// shading frame where there are no texture coordinates.
Frame tangentFrame(const SurfacePoint &point);

/// The normal, in world space, that a map's direction `n` stands for, z > 0; unit length. (0, 0, 1)
/// gives exactly the interpolated one.
V3f mappedNormal(const SurfacePoint &point, const V3f &n);

/// A mapped normal may turn the mirror image of the viewer below the surface, where nothing is seen:
/// black rims. It is then turned back until the image lies just above (A. Keller et al., "The Iray
/// Light Transport Simulation and Rendering System", 2017), or where the interpolated normal has it if
/// that is lower, so that a flat map changes nothing. Light from below the surface is the caller's to
/// refuse. All unit length, `geometric` towards the viewer.
V3f keepReflectionAbove(const V3f &normal, const V3f &interpolated, const V3f &geometric,
                        const V3f &toViewer);

} // namespace render
