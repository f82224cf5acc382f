// The shading frame, pellicle's local space: z is the shading normal, x the tangent.
#pragma once

#include "math.hpp"

namespace render {

struct Frame {
    V3f tangent, bitangent, normal;

    V3f toLocal(const V3f &v) const { return {dot(v, tangent), dot(v, bitangent), dot(v, normal)}; }
    V3f toWorld(const V3f &v) const { return tangent * v.x + bitangent * v.y + normal * v.z; }
};

/// The world direction whose projection into the tangent plane is every frame's tangent. Being the
/// same everywhere it leaves no seams; it is only undefined where the normal is parallel to it,
/// which for the gallery's camera is on an object's left and right outline.
inline const V3f tangentDirection{1, 0, 0};

inline Frame frameAround(const V3f &normal) {
    V3f tangent = tangentDirection - normal * dot(tangentDirection, normal);
    if (tangent.length2() < 1e-12f) tangent = cross(V3f(0, 1, 0), normal);
    tangent.normalize();
    return {tangent, cross(normal, tangent), normal};
}

} // namespace render
