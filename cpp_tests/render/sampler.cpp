#include "sampler.hpp"

namespace render {
namespace {

/// A bijection of 32 bits: C. Wellons, "Prospecting for Hash Functions", 2018, "lowbias32".
std::uint32_t mixBits(std::uint32_t v) {
    v ^= v >> 16;
    v *= 0x7feb352du;
    v ^= v >> 15;
    v *= 0x846ca68bu;
    return v ^ (v >> 16);
}

/// The hash of two numbers, in order.
std::uint32_t combine(std::uint32_t a, std::uint32_t b) { return mixBits(a ^ mixBits(b + 0x9e3779b9u)); }

std::uint32_t reverseBits(std::uint32_t v) {
    v = (v << 16) | (v >> 16);
    v = ((v & 0x00ff00ffu) << 8) | ((v & 0xff00ff00u) >> 8);
    v = ((v & 0x0f0f0f0fu) << 4) | ((v & 0xf0f0f0f0u) >> 4);
    v = ((v & 0x33333333u) << 2) | ((v & 0xccccccccu) >> 2);
    v = ((v & 0x55555555u) << 1) | ((v & 0xaaaaaaaau) >> 1);
    return v;
}

/// Burley's nested uniform scramble, with the constants of pbrt-v4's FastOwenScrambler. Of an index it is a shuffle
/// that maps aligned blocks of 2^k numbers to such blocks.
std::uint32_t owenScramble(std::uint32_t v, std::uint32_t seed) {
    v = reverseBits(v);
    v ^= v * 0x3d20adeau;
    v += seed;
    v *= (seed >> 16) | 1u;
    v ^= v * 0x05526c56u;
    v ^= v * 0x53a22864u;
    return reverseBits(v);
}

using DirectionNumbers = std::array<std::array<std::uint32_t, 32>, 4>;

/// The first four dimensions of S. Joe and F. Kuo, "Constructing Sobol Sequences with Better Two-Dimensional
/// Projections", SIAM J. Sci. Comput. 30, 2008 (table new-joe-kuo-6.21201), by their recurrence.
constexpr DirectionNumbers directionNumbers() {
    struct Row {
        std::uint32_t degree, polynomial, initial[3];
    };
    constexpr Row rows[3] = {{1, 0, {1, 0, 0}}, {2, 1, {1, 3, 0}}, {3, 1, {1, 3, 1}}};
    DirectionNumbers all{};
    for (std::uint32_t i = 0; i < 32; ++i) all[0][i] = 1u << (31 - i);
    for (int dimension = 1; dimension < 4; ++dimension) {
        const Row &row = rows[dimension - 1];
        std::array<std::uint32_t, 32> &v = all[dimension];
        for (std::uint32_t i = 0; i < 32; ++i) {
            if (i < row.degree) {
                v[i] = row.initial[i] << (31 - i);
                continue;
            }
            v[i] = v[i - row.degree] ^ (v[i - row.degree] >> row.degree);
            for (std::uint32_t k = 1; k < row.degree; ++k)
                if (row.polynomial >> (row.degree - 1 - k) & 1) v[i] ^= v[i - k];
        }
    }
    return all;
}
constexpr DirectionNumbers directions = directionNumbers();

/// A number of a scrambled dimension.
float sobol(std::uint32_t index, int dimension, std::uint32_t hash) {
    std::uint32_t v = 0;
    for (int bit = 0; index != 0; index >>= 1, ++bit) v ^= directions[dimension][bit] & (0 - (index & 1));
    return static_cast<float>(owenScramble(v, combine(hash, static_cast<std::uint32_t>(dimension) + 1)) >> 8) *
           0x1p-24f;
}

} // namespace

Sampler::Sampler(int samplesPerPixel, std::uint32_t seed)
    : seed_(seed),
      mask_(0) {
    while (mask_ + 1 < static_cast<std::uint32_t>(samplesPerPixel)) mask_ = 2 * mask_ + 1;
}

void Sampler::start(V2i pixel, int index) {
    pixel_ = combine(combine(seed_, static_cast<std::uint32_t>(pixel.x)), static_cast<std::uint32_t>(pixel.y));
    index_ = static_cast<std::uint32_t>(index);
    sequence_ = 0;
}

Sampler::Points Sampler::next(int count) {
    Points points;
    const auto n = static_cast<std::uint32_t>(count);
    points.first_ = index_ * n;
    points.mask_ = mask_ * n + (n - 1);
    points.hash_ = combine(pixel_, sequence_++);
    return points;
}

/// The bits above the mask need no shuffling: the scramble of the numbers does the same.
std::uint32_t Sampler::Points::shuffled(int i) const {
    return owenScramble(first_ + static_cast<std::uint32_t>(i), hash_) & mask_;
}

V2f Sampler::Points::at2d(int i) const {
    const std::uint32_t index = shuffled(i);
    return {sobol(index, 0, hash_), sobol(index, 1, hash_)};
}

Sampler::Numbers Sampler::Points::at(int i) const {
    const std::uint32_t index = shuffled(i);
    return {sobol(index, 0, hash_), sobol(index, 1, hash_), sobol(index, 2, hash_), sobol(index, 3, hash_)};
}

} // namespace render
