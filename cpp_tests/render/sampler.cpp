#include "sampler.hpp"

#include <algorithm>
#include <array>

namespace render {
namespace {

/// D. Stafford's "Mix13" finaliser of MurmurHash3.
std::uint64_t mixBits(std::uint64_t v) {
    v ^= v >> 31;
    v *= 0x7fb5d329728ea185u;
    v ^= v >> 27;
    v *= 0x81dadef4bc2dd44du;
    v ^= v >> 33;
    return v;
}

std::uint32_t reverseBits(std::uint32_t v) {
    v = (v << 16) | (v >> 16);
    v = ((v & 0x00ff00ffu) << 8) | ((v & 0xff00ff00u) >> 8);
    v = ((v & 0x0f0f0f0fu) << 4) | ((v & 0xf0f0f0f0u) >> 4);
    v = ((v & 0x33333333u) << 2) | ((v & 0xccccccccu) >> 2);
    v = ((v & 0x55555555u) << 1) | ((v & 0xaaaaaaaau) >> 1);
    return v;
}

/// Hash-based Owen scrambling (B. Burley, "Practical Hash-based Owen Scrambling", JCGT 9(4), 2020)
/// with the constants of pbrt-v4's FastOwenScrambler.
std::uint32_t owenScramble(std::uint32_t v, std::uint32_t seed) {
    v = reverseBits(v);
    v ^= v * 0x3d20adeau;
    v += seed;
    v *= (seed >> 16) | 1u;
    v ^= v * 0x05526c56u;
    v ^= v * 0x53a22864u;
    return reverseBits(v);
}

/// First Sobol' dimension: van der Corput's sequence. Indices beyond 2^32 wrap.
std::uint32_t sobol0(std::uint64_t index) { return reverseBits(static_cast<std::uint32_t>(index)); }

/// Second Sobol' dimension: its generator is Pascal's triangle modulo 2, built column by column.
std::uint32_t sobol1(std::uint64_t index) {
    std::uint32_t v = 0;
    for (std::uint32_t column = 1u << 31; index != 0; index >>= 1, column ^= column >> 1)
        if (index & 1) v ^= column;
    return v;
}

float toUnitInterval(std::uint32_t v) { return static_cast<float>(v >> 8) * 0x1p-24f; }

std::uint64_t spreadBits(std::uint64_t v) {
    v = (v | (v << 16)) & 0x0000ffff0000ffffu;
    v = (v | (v << 8)) & 0x00ff00ff00ff00ffu;
    v = (v | (v << 4)) & 0x0f0f0f0f0f0f0f0fu;
    v = (v | (v << 2)) & 0x3333333333333333u;
    v = (v | (v << 1)) & 0x5555555555555555u;
    return v;
}

int ceilLog2(std::uint32_t v) {
    int log2 = 0;
    while ((std::uint64_t{1} << log2) < v) ++log2;
    return log2;
}

/// All orders of four digits.
std::array<std::array<std::uint8_t, 4>, 24> allPermutations() {
    std::array<std::array<std::uint8_t, 4>, 24> all;
    std::array<std::uint8_t, 4> order{0, 1, 2, 3};
    for (auto &permutation : all) {
        permutation = order;
        std::next_permutation(order.begin(), order.end());
    }
    return all;
}
const auto permutations = allPermutations();

} // namespace

Sampler::Sampler(V2i resolution, int samplesPerPixel, std::uint32_t seed)
    : seed_(mixBits(std::uint64_t{seed} + 1)),
      log2SamplesPerPixel_(ceilLog2(static_cast<std::uint32_t>(samplesPerPixel))),
      digits_(ceilLog2(static_cast<std::uint32_t>(std::max(resolution.x, resolution.y))) +
              (log2SamplesPerPixel_ + 1) / 2) {}

void Sampler::start(V2i pixel, int index) {
    const std::uint64_t pixelMorton = spreadBits(static_cast<std::uint32_t>(pixel.x)) |
                                      spreadBits(static_cast<std::uint32_t>(pixel.y)) << 1;
    morton_ = (pixelMorton << log2SamplesPerPixel_) | static_cast<std::uint64_t>(index);
    dimension_ = 0;
}

float Sampler::next1d() {
    const std::uint64_t index = nextSobolIndex();
    const std::uint64_t hash = mixBits(seed_ ^ dimension_++);
    return toUnitInterval(owenScramble(sobol0(index), static_cast<std::uint32_t>(hash)));
}

V2f Sampler::next2d() {
    const std::uint64_t index = nextSobolIndex();
    const std::uint64_t hash = mixBits(seed_ ^ dimension_);
    dimension_ += 2;
    return {toUnitInterval(owenScramble(sobol0(index), static_cast<std::uint32_t>(hash))),
            toUnitInterval(owenScramble(sobol1(index), static_cast<std::uint32_t>(hash >> 32)))};
}

/// Permutes the Morton index's base-4 digits, each depending on the digits above it, and the last
/// bit where the number of samples is not a power of 4 (Ahmed and Wonka, section 4).
std::uint64_t Sampler::nextSobolIndex() {
    const auto hash = [&](std::uint64_t higherDigits) {
        return mixBits(seed_ ^ higherDigits ^ (std::uint64_t{0x55555555} * dimension_));
    };
    const int oddBit = log2SamplesPerPixel_ & 1;
    std::uint64_t index = 0;
    for (int digit = digits_ - 1; digit >= oddBit; --digit) {
        const int shift = 2 * digit - oddBit;
        const auto &permutation = permutations[(hash(morton_ >> (shift + 2)) >> 24) % 24];
        index |= std::uint64_t{permutation[(morton_ >> shift) & 3]} << shift;
    }
    if (oddBit) index |= (morton_ & 1) ^ (hash(morton_ >> 1) & 1);
    return index;
}

} // namespace render
