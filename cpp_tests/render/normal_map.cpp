#include "normal_map.hpp"

#include <algorithm>

namespace render {
namespace {

V3f reflect(const V3f &toViewer, const V3f &normal) {
    return normal * (2 * dot(toViewer, normal)) - toViewer;
}

} // namespace

Frame tangentFrame(const SurfacePoint &point) {
    const V3f &normal = point.shading.normal;
    V3f tangent = point.alongU - normal * dot(point.alongU, normal);
    // Compared with the length: the scale of the texture does not matter.
    if (!(tangent.length2() > 1e-12f * point.alongU.length2())) return point.shading;
    tangent.normalize();
    const V3f bitangent = cross(normal, tangent);
    return {tangent, dot(bitangent, point.alongV) < 0 ? -bitangent : bitangent, normal};
}

V3f mappedNormal(const SurfacePoint &point, const V3f &n) {
    return tangentFrame(point).toWorld(n.normalized());
}

V3f keepReflectionAbove(const V3f &normal, const V3f &interpolated, const V3f &geometric,
                        const V3f &toViewer) {
    constexpr float justAbove = 0.01f; // cosine
    const float least = std::min(justAbove, dot(reflect(toViewer, interpolated), geometric));
    const V3f image = reflect(toViewer, normal);
    const float cosine = dot(image, geometric);
    if (!(cosine < least)) return normal;
    const V3f raised = (image + geometric * (least - cosine)).normalized();
    return (toViewer + raised).normalized();
}

} // namespace render
