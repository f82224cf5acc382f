// Deterministic quasi-random numbers: a function of seed, pixel, sample and dimension, and of
// nothing else, so that a picture does not depend on the number of threads.
#pragma once

#include "math.hpp"

#include <array>
#include <cstdint>

namespace render {

/// Owen-scrambled Sobol' sequences (B. Burley, "Practical Hash-based Owen Scrambling", JCGT 9(4), 2020, section 5):
/// every pixel and every call of next() has a sequence of its own, in four dimensions that are stratified together,
/// shuffled and scrambled by a hash. Powers of two are the best numbers of samples.
class Sampler {
public:
    Sampler(int samplesPerPixel, std::uint32_t seed);

    /// Starts sample `index` of a pixel at its first sequence.
    void start(V2i pixel, int index);

    /// Four numbers in [0, 1).
    using Numbers = std::array<float, 4>;
    Numbers next() { return next(1).at(0); }

    /// `count`, a power of two, consecutive points of one sequence, as (x, y): the samples of a pixel share all of it.
    class Points {
    public:
        V2f at2d(int i) const;
        Numbers at(int i) const;

    private:
        friend class Sampler;
        std::uint32_t shuffled(int i) const;
        std::uint32_t first_, mask_, hash_;
    };
    Points next(int count);

private:
    std::uint32_t seed_, mask_; ///< the bits that the number of a sample has
    std::uint32_t pixel_ = 0, index_ = 0, sequence_ = 0;
};

} // namespace render
