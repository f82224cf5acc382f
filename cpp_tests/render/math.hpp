// Vectors and colours: Imath's. World space has +y up; the camera looks towards -z.
#pragma once

#include <Imath/ImathColor.h>
#include <Imath/ImathVec.h>

#include <cmath>

namespace render {

using Imath::V2f;
using Imath::V2i;
using Imath::V3f;
/// Linear Rec.709.
using Rgb = Imath::C3f;

constexpr float pi = 3.14159265358979f;

inline float radians(float degrees) { return degrees * (pi / 180); }

inline float dot(const V3f &a, const V3f &b) { return a.dot(b); }
inline V3f cross(const V3f &a, const V3f &b) { return a.cross(b); }

inline float lerp(float a, float b, float t) { return a + (b - a) * t; }
inline float maxComponent(const Rgb &c) { return std::fmax(c.x, std::fmax(c.y, c.z)); }

/// Rec.709 luminance (ITU-R BT.709-6, item 3.2).
inline float luminance(const Rgb &c) { return 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z; }

/// 0 up to `from`, 1 after `to`, a cubic between.
inline float smoothstep(float from, float to, float x) {
    const float t = std::fmin(std::fmax((x - from) / (to - from), 0.0f), 1.0f);
    return t * t * (3 - 2 * t);
}

} // namespace render
