// A film's table as the library has it, a quadratic spline over cosine and thickness, once plain and once
// with intrinsics of AVX-512: how fast such a look-up can be. The contents are made up.
#pragma once

#include <cstddef>
#include <vector>

class Spline {
public:
    // Control points along the cosine and the thickness: the size of the library's tables of one layer.
    static constexpr int width = 40, height = 60;

    Spline();

    // Whether this processor and this build have what at_each() needs.
    static bool is_available();

    // One element.
    void at(float cos_theta, float thickness_nm, float rgb[3]) const;

    // Many, all arrays `count` long.
    void at_each(const float *cos_theta, const float *thickness_nm, float *r, float *g, float *b,
                 std::size_t count) const;

private:
    std::vector<float> points; // r, g, b, b

    // numerator(d) f / (denominator(d) f + rest(d)), each linear in the thickness d, f a parabola in cos^2 or
    // the cosine itself; the numbers are those of a film whose fringes are taken upright.
    struct Coordinate {
        float numerator[2], denominator[2], rest[2]; // slope, constant
        float cosine[4];                             // coefficients of 1, cos, cos^2 and cos^4
    };
    Coordinate x, y;

    static float position(const Coordinate &axis, float cos_theta, float thickness_nm);
};
