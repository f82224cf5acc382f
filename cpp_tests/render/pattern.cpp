#include "pattern.hpp"

#include <algorithm>

namespace render {
namespace {

/// The place moved by up to about `distance` in every direction, by noise of twice that wave length.
V3f stir(const V3f &place, float distance) {
    const V3f at = place * (0.5f / distance);
    const auto push = [&](float offset) { return improvedNoise(at + V3f(offset, -offset, 2 * offset)).value; };
    return place + V3f(push(0.5f), push(17.3f), push(31.7f)) * distance;
}

} // namespace

Noise NoiseField::at(const SurfacePoint &point) const {
    Noise noise = fractalNoise01(point.objectPosition * frequency, octaves);
    noise.gradient *= frequency;
    return noise;
}

Pattern noiseBetween(float min, float max, NoiseField field) {
    return {1, [=](const SurfacePoint &point, float *number) {
                *number = lerp(min, max, field.at(point).value);
            }};
}

Pattern constantDeviation(float degrees) {
    const V3f deviated(std::sin(radians(degrees)), 0, std::cos(radians(degrees)));
    return {3, [=](const SurfacePoint &, float *direction) {
                for (int axis = 0; axis < 3; ++axis) direction[axis] = deviated[axis];
            }};
}

Pattern bump(float height, NoiseField field) {
    return {3, [=](const SurfacePoint &point, float *direction) {
                const V3f slope = point.shading.toLocal(field.at(point).gradient);
                direction[0] = -height * slope.x;
                direction[1] = -height * slope.y;
                direction[2] = 1;
            }};
}

Pattern steps(const V3f &axis, float from, float to, std::vector<float> values) {
    return {1, [=](const SurfacePoint &point, float *number) {
                const float t = (dot(point.objectPosition, axis) - from) / (to - from);
                const float count = static_cast<float>(values.size());
                *number = values[static_cast<std::size_t>(std::clamp(t * count, 0.0f, count - 1))];
            }};
}

Pattern draining(const V3f &axis, float from, float to, float max, float unevenness) {
    return {1, [=](const SurfacePoint &point, float *number) {
                const V3f &place = point.objectPosition;
                const float t = std::max(0.0f, (dot(place, axis) - from) / (to - from));
                const float noise = fractalNoise01(stir(place * 1.3f, 0.45f) + V3f(3.1f), 3).value;
                *number = t * max * (1 + unevenness * (noise - 0.5f));
            }};
}

Pattern stirred(float min, float max, float frequency) {
    return {1, [=](const SurfacePoint &point, float *number) {
                *number = lerp(min, max,
                               fractalNoise01(stir(point.objectPosition * frequency, 0.6f), 3).value);
            }};
}

Pattern fadingGrey(float centre, float rim, float from, float to) {
    return {3, [=](const SurfacePoint &point, float *rgb) {
                const float distance = std::hypot(point.position.x, point.position.z);
                rgb[0] = rgb[1] = rgb[2] = lerp(centre, rim, smoothstep(from, to, distance));
            }};
}

} // namespace render
