#include "noise.hpp"

#include <doctest/doctest.h>

using namespace render;

TEST_SUITE_BEGIN("noise");

TEST_CASE("Perlin's reference implementation gives the same number") {
    // ImprovedNoise.noise(3.14, 42, 7) of mrl.cs.nyu.edu/~perlin/noise, in double precision.
    CHECK(improvedNoise(V3f(3.14f, 42, 7)).value == doctest::Approx(0.13691995878400012).epsilon(1e-5));
    CHECK(improvedNoise(V3f(5, -3, 200)).value == 0);
}

TEST_CASE("the gradient is the derivative") {
    constexpr float h = 0.01f;
    for (int i = 0; i < 1000; ++i) {
        const V3f p(0.37f * i, 9.1f - 0.11f * i, 0.23f * i);
        const Noise noise = improvedNoise(p);
        for (int axis = 0; axis < 3; ++axis) {
            V3f step(0);
            step[axis] = h;
            const float difference =
                (improvedNoise(p + step).value - improvedNoise(p - step).value) / (2 * h);
            CHECK(std::fabs(difference - noise.gradient[axis]) < 5e-3f);
        }
    }
}

TEST_CASE("fractal noise stays within [0, 1] and nearly fills it") {
    float least = 1, greatest = 0;
    for (int i = 0; i < 10000; ++i) {
        const float value = fractalNoise01(V3f(0.217f * i, 0.131f * i, -0.071f * i), 3).value;
        least = std::min(least, value);
        greatest = std::max(greatest, value);
    }
    CHECK(least >= 0);
    CHECK(least < 0.05f);
    CHECK(greatest <= 1);
    CHECK(greatest > 0.95f);
}

TEST_SUITE_END();
