#include "footprint.hpp"

#include <algorithm>

namespace render {

TextureTangents textureTangents(const std::array<V3f, 3> &positions, const std::array<V2f, 3> &uvs) {
    const V2f a = uvs[1] - uvs[0], b = uvs[2] - uvs[0];
    const float area = a.x * b.y - a.y * b.x;
    if (area == 0) return {V3f(0), V3f(0)};
    const V3f p = positions[1] - positions[0], q = positions[2] - positions[0];
    return {(p * b.y - q * a.y) / area, (q * a.x - p * b.x) / area};
}

std::array<V2f, 2> footprintOf(const SurfacePoint &point, const Ray &ray, float distance) {
    const V3f perpendicular = cross(point.alongU, point.alongV);
    const float squaredArea = perpendicular.length2();
    if (ray.spread == 0 || squaredArea == 0) return {V2f(0), V2f(0)};

    const V3f normal = perpendicular / std::sqrt(squaredArea);
    // At grazing angles the cone's outline is endless; what is beyond the most anisotropic look-up
    // would only be blurred.
    constexpr float leastCosine = 1.0f / 32;
    const float cosine = std::max(std::fabs(dot(normal, ray.direction)), leastCosine);
    V3f minor = cross(normal, ray.direction);
    if (minor.length2() < 1e-12f) minor = point.alongU;
    minor.normalize();
    const float width = ray.spread * distance;
    const V3f major = cross(normal, minor) * (width / cosine);
    // The rows of the pseudo-inverse of (alongU, alongV).
    const V3f towardsU = cross(point.alongV, perpendicular) / squaredArea;
    const V3f towardsV = cross(perpendicular, point.alongU) / squaredArea;
    const auto inUv = [&](const V3f &v) { return V2f(dot(towardsU, v), dot(towardsV, v)); };
    return {inUv(minor * width), inUv(major)};
}

} // namespace render
