// A pinhole camera.
#pragma once

#include "math.hpp"
#include "ray.hpp"

#include <algorithm>

namespace render {

class Camera {
public:
    /// `fieldOfView`: degrees, of the shorter side of the picture.
    Camera(const V3f &eye, const V3f &target, float fieldOfView)
        : eye_(eye),
          forward_((target - eye).normalized()) {
        const float half = std::tan(radians(fieldOfView) / 2);
        right_ = cross(forward_, V3f(0, 1, 0)).normalized() * half;
        up_ = cross(right_, forward_);
    }

    /// `raster`: pixels, from the upper left corner.
    Ray ray(const V2f &raster, V2i resolution) const {
        const float side = static_cast<float>(std::min(resolution.x, resolution.y));
        const float x = (2 * raster.x - static_cast<float>(resolution.x)) / side;
        const float y = (static_cast<float>(resolution.y) - 2 * raster.y) / side;
        return {eye_, (forward_ + right_ * x + up_ * y).normalized(), 2 * right_.length() / side};
    }

private:
    V3f eye_, forward_, right_, up_;
};

} // namespace render
