#include "pattern.hpp"

namespace render {

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

Pattern fadingGrey(float centre, float rim, float from, float to) {
    return {3, [=](const SurfacePoint &point, float *rgb) {
                const float distance = std::hypot(point.position.x, point.position.z);
                rgb[0] = rgb[1] = rgb[2] = lerp(centre, rim, smoothstep(from, to, distance));
            }};
}

} // namespace render
