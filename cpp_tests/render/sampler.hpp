// Deterministic quasi-random numbers: a function of seed, pixel, sample and dimension, and of
// nothing else, so that a picture does not depend on the number of threads.
#pragma once

#include "math.hpp"

#include <cstdint>

namespace render {

/// The Z sampler (A. Ahmed and P. Wonka, "Screen-Space Blue-Noise Diffusion of Monte Carlo Sampling
/// Error via Hierarchical Ordering of Pixels", SIGGRAPH Asia 2020) as in pbrt-v4's ZSobolSampler:
/// pixels in Morton order share one Owen-scrambled Sobol' sequence, so that each pixel is well
/// stratified and the error that remains looks like blue noise.
class Sampler {
public:
    Sampler(V2i resolution, int samplesPerPixel, std::uint32_t seed);

    /// Starts sample `index` of a pixel at its first dimension.
    void start(V2i pixel, int index);

    float next1d();
    V2f next2d();

private:
    std::uint64_t nextSobolIndex();

    std::uint64_t seed_;
    int log2SamplesPerPixel_;
    int digits_; ///< base-4 digits of a Morton index
    std::uint64_t morton_ = 0;
    std::uint32_t dimension_ = 0;
};

} // namespace render
