#include "noise.hpp"

#include <cstdint>

namespace render {
namespace {

/// The permutation of Perlin's reference implementation (mrl.cs.nyu.edu/~perlin/noise, 2002).
constexpr std::uint8_t permutation[256] = {
    151, 160, 137, 91,  90,  15,  131, 13,  201, 95,  96,  53,  194, 233, 7,   225, 140, 36,  103, 30,
    69,  142, 8,   99,  37,  240, 21,  10,  23,  190, 6,   148, 247, 120, 234, 75,  0,   26,  197, 62,
    94,  252, 219, 203, 117, 35,  11,  32,  57,  177, 33,  88,  237, 149, 56,  87,  174, 20,  125, 136,
    171, 168, 68,  175, 74,  165, 71,  134, 139, 48,  27,  166, 77,  146, 158, 231, 83,  111, 229, 122,
    60,  211, 133, 230, 220, 105, 92,  41,  55,  46,  245, 40,  244, 102, 143, 54,  65,  25,  63,  161,
    1,   216, 80,  73,  209, 76,  132, 187, 208, 89,  18,  169, 200, 196, 135, 130, 116, 188, 159, 86,
    164, 100, 109, 198, 173, 186, 3,   64,  52,  217, 226, 250, 124, 123, 5,   202, 38,  147, 118, 126,
    255, 82,  85,  212, 207, 206, 59,  227, 47,  16,  58,  17,  182, 189, 28,  42,  223, 183, 170, 213,
    119, 248, 152, 2,   44,  154, 163, 70,  221, 153, 101, 155, 167, 43,  172, 9,   129, 22,  39,  253,
    19,  98,  108, 110, 79,  113, 224, 232, 178, 185, 112, 104, 218, 246, 97,  228, 251, 34,  242, 193,
    238, 210, 144, 12,  191, 179, 162, 241, 81,  51,  145, 235, 249, 14,  239, 107, 49,  192, 214, 31,
    181, 199, 106, 157, 184, 84,  204, 176, 115, 121, 50,  45,  127, 4,   150, 254, 138, 236, 205, 93,
    222, 114, 67,  29,  24,  72,  243, 141, 128, 195, 78,  66,  215, 61,  156, 180};

/// The twelve edge directions of a cube, four of them twice ("Improving Noise", section 3).
constexpr float edges[16][3] = {{1, 1, 0},  {-1, 1, 0},  {1, -1, 0}, {-1, -1, 0}, {1, 0, 1},  {-1, 0, 1},
                                {1, 0, -1}, {-1, 0, -1}, {0, 1, 1},  {0, -1, 1},  {0, 1, -1}, {0, -1, -1},
                                {1, 1, 0},  {0, -1, 1},  {-1, 1, 0}, {0, -1, -1}};

int hash(int x, int y, int z) {
    return permutation[(permutation[(permutation[x & 255] + y) & 255] + z) & 255];
}

/// 6 t^5 - 15 t^4 + 10 t^3, "Improving Noise" section 2, and its derivative.
float fade(float t) { return t * t * t * (t * (t * 6 - 15) + 10); }
float fadeDerivative(float t) { return 30 * t * t * (t * (t - 2) + 1); }

} // namespace

Noise improvedNoise(const V3f &position) {
    const V3f cell(std::floor(position.x), std::floor(position.y), std::floor(position.z));
    const V3f offset = position - cell;
    Noise sum{0, V3f(0)};
    for (int corner = 0; corner < 8; ++corner) {
        const int bit[3] = {corner & 1, (corner >> 1) & 1, corner >> 2};
        V3f weight, derivative;
        for (int axis = 0; axis < 3; ++axis) {
            const float w = fade(offset[axis]), d = fadeDerivative(offset[axis]);
            weight[axis] = bit[axis] ? w : 1 - w;
            derivative[axis] = bit[axis] ? d : -d;
        }
        const auto &edge = edges[hash(static_cast<int>(cell.x) + bit[0], static_cast<int>(cell.y) + bit[1],
                                      static_cast<int>(cell.z) + bit[2]) &
                                 15];
        const V3f gradient(edge[0], edge[1], edge[2]);
        const float ramp = dot(gradient, offset - V3f(bit[0], bit[1], bit[2]));
        const float product = weight.x * weight.y * weight.z;
        sum.value += product * ramp;
        sum.gradient +=
            gradient * product + V3f(derivative.x * weight.y * weight.z, weight.x * derivative.y * weight.z,
                                     weight.x * weight.y * derivative.z) *
                                     ramp;
    }
    return sum;
}

Noise fractalNoise01(const V3f &position, int octaves) {
    // Three octaves were measured to have a standard deviation of 0.31: 0 and 1 are reached at 2.2 of
    // them, and less than 3 % of space is clamped.
    constexpr float contrast = 0.75f;
    Noise sum{0.5f, V3f(0)};
    float frequency = 1, amplitude = contrast;
    for (int octave = 0; octave < octaves; ++octave) {
        // The shift keeps the octaves' lattice points, where noise is 0, from coinciding.
        const Noise noise = improvedNoise(position * frequency + V3f(17.3f, 5.7f, 11.1f) * octave);
        sum.value += amplitude * noise.value;
        sum.gradient += noise.gradient * (amplitude * frequency);
        frequency *= 2;
        amplitude *= 0.5f;
    }
    if (sum.value < 0) return {0, V3f(0)};
    if (sum.value > 1) return {1, V3f(0)};
    return sum;
}

} // namespace render
