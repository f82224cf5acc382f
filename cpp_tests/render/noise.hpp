// Perlin's improved noise with its gradient.
#pragma once

#include "math.hpp"

namespace render {

struct Noise {
    float value;
    V3f gradient; ///< with respect to the position given
};

/// K. Perlin, "Improving Noise", SIGGRAPH 2002. Within [-1, 1], 0 at lattice points.
Noise improvedNoise(const V3f &position);

/// `octaves` of noise, each of twice the frequency and half the amplitude, mapped so that it spreads
/// over [0, 1] and clamped there.
Noise fractalNoise01(const V3f &position, int octaves);

} // namespace render
