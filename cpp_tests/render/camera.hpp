// A camera with a thin lens.
#pragma once

#include "math.hpp"
#include "ray.hpp"

#include <algorithm>

namespace render {

class Camera {
public:
    /// `fieldOfView`: degrees, of the shorter side of the picture. `lensRadius` 0 is a pinhole, which shows
    /// everything sharply; otherwise what is `focus` away, measured along the axis, is sharp.
    Camera(const V3f &eye, const V3f &target, float fieldOfView, float lensRadius = 0, float focus = 1)
        : eye_(eye),
          forward_((target - eye).normalized()),
          lensRadius_(lensRadius),
          focus_(focus) {
        const float half = std::tan(radians(fieldOfView) / 2);
        right_ = cross(forward_, V3f(0, 1, 0)).normalized() * half;
        up_ = cross(right_, forward_);
    }

    /// `raster`: pixels, from the upper left corner. `lens`: two uniform numbers that choose a point of the
    /// lens (M. Pharr, W. Jakob and G. Humphreys, "Physically Based Rendering", 4th edition, section 5.2.3);
    /// the centre is (0, 0).
    Ray ray(const V2f &raster, V2i resolution, const V2f &lens = V2f(0)) const {
        const float side = static_cast<float>(std::min(resolution.x, resolution.y));
        const float x = (2 * raster.x - static_cast<float>(resolution.x)) / side;
        const float y = (static_cast<float>(resolution.y) - 2 * raster.y) / side;
        const V3f through = forward_ + right_ * x + up_ * y;
        const float spread = 2 * right_.length() / side;
        const float radius = lensRadius_ * std::sqrt(lens.x), angle = 2 * pi * lens.y;
        const V3f offset = (right_.normalized() * std::cos(angle) + up_.normalized() * std::sin(angle)) * radius;
        return {eye_ + offset, (through * focus_ - offset).normalized(), spread};
    }

private:
    V3f eye_, forward_, right_, up_;
    float lensRadius_, focus_;
};

} // namespace render
