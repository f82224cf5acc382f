#include "ray.hpp"

#include <cstdint>
#include <cstring>

namespace render {
namespace {

/// `x` moved by `steps` floating-point numbers towards larger x.
float advance(float x, int steps) {
    std::int32_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    bits += x < 0 ? -steps : steps;
    std::memcpy(&x, &bits, sizeof bits);
    return x;
}

} // namespace

// C. Waechter and N. Binder, "A Fast and Robust Method for Avoiding Self-Intersection", Ray Tracing
// Gems, 2019, chapter 6, with its constants: relative far from the origin, absolute near it.
Ray leaveSurface(const V3f &position, const V3f &geometricNormal, const V3f &direction) {
    constexpr float origin = 1.0f / 32, floatScale = 1.0f / 65536, integerScale = 256;
    const V3f normal = dot(direction, geometricNormal) < 0 ? -geometricNormal : geometricNormal;
    V3f moved;
    for (int axis = 0; axis < 3; ++axis) {
        moved[axis] = std::fabs(position[axis]) < origin
                          ? position[axis] + floatScale * normal[axis]
                          : advance(position[axis], static_cast<int>(integerScale * normal[axis]));
    }
    return {moved, direction};
}

} // namespace render
