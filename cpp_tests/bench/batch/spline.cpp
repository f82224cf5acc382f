#include "spline.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#if defined(__AVX512F__) && defined(__AVX512VL__) && defined(__AVX512DQ__)
#include <immintrin.h>
#define SPLINE_HAS_INTRINSICS 1
#endif

namespace {

constexpr float root = 0.70710678f;

// Of the three control points around a value, a distance in [-1/2, 1/2] from it.
struct Weights {
    float before, middle, after;
    explicit Weights(float distance) {
        const float low = distance * root - 0.5f * root, high = distance * root + 0.5f * root;
        before = low * low;
        middle = 0.75f - distance * distance;
        after = high * high;
    }
};

} // namespace

Spline::Spline() {
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i) {
            float rgb[3];
            for (int c = 0; c < 3; ++c)
                rgb[c] = 0.5f + 0.4f * std::sin(0.3f * float(j) * (1 + 0.2f * float(c)) + 0.1f * float(i));
            for (const float channel : {rgb[0], rgb[1], rgb[2], rgb[2]}) points.push_back(channel);
        }

    constexpr float range_nm = 1000, scale = 0.3f, least = 1, half = 150, fade = 1, stretch = 2;
    constexpr float across = width - 3, along = height - 3;
    x = {{across * (1 + scale), across * (half + scale * least)}, {1, half}, {scale, scale * least}, {0, 1, 0, 0}};
    y = {{fade / range_nm * stretch * along, 0}, {fade / range_nm, 0}, {0, 1}, {0.7f, 0, 0.35f, -0.05f}};
}

float Spline::position(const Coordinate &axis, float cos_theta, float d) {
    const float square = cos_theta * cos_theta;
    const float f = (axis.cosine[3] * square + axis.cosine[2]) * square + (axis.cosine[0] + axis.cosine[1] * cos_theta);
    const float numerator = axis.numerator[0] * d + axis.numerator[1];
    const float denominator = axis.denominator[0] * d + axis.denominator[1];
    return numerator * f / (denominator * f + (axis.rest[0] * d + axis.rest[1]));
}

void Spline::at(float cos_theta, float thickness_nm, float rgb[3]) const {
    const float px = position(x, cos_theta, thickness_nm), py = position(y, cos_theta, thickness_nm);
    const float i = std::nearbyint(px), j = std::nearbyint(py);
    const Weights across(px - i), along(py - j);
    const float *corner = &points[4 * (std::size_t(j) * width + std::size_t(i))];
    const float u[3] = {across.before, across.middle, across.after}, v[3] = {along.before, along.middle, along.after};
    for (int c = 0; c < 3; ++c) {
        rgb[c] = 0;
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 3; ++column)
                rgb[c] += v[row] * u[column] * corner[4 * (row * width + column) + c];
    }
}

#ifdef SPLINE_HAS_INTRINSICS

namespace {

struct Axis {
    __m512 numerator[2], denominator[2], rest[2], cosine[4];

    template <class Coordinate> explicit Axis(const Coordinate &from) {
        for (int i = 0; i < 2; ++i) {
            numerator[i] = _mm512_set1_ps(from.numerator[i]);
            denominator[i] = _mm512_set1_ps(from.denominator[i]);
            rest[i] = _mm512_set1_ps(from.rest[i]);
        }
        for (int i = 0; i < 4; ++i) cosine[i] = _mm512_set1_ps(from.cosine[i]);
    }

    __m512 position(__m512 cos_theta, __m512 d) const {
        const __m512 square = _mm512_mul_ps(cos_theta, cos_theta);
        const __m512 f = _mm512_fmadd_ps(_mm512_fmadd_ps(cosine[3], square, cosine[2]), square,
                                         _mm512_fmadd_ps(cosine[1], cos_theta, cosine[0]));
        const __m512 above = _mm512_mul_ps(_mm512_fmadd_ps(numerator[0], d, numerator[1]), f);
        const __m512 below = _mm512_fmadd_ps(_mm512_fmadd_ps(denominator[0], d, denominator[1]), f,
                                             _mm512_fmadd_ps(rest[0], d, rest[1]));
        return _mm512_div_ps(above, below);
    }
};

// Sixteen times the three weights.
struct Sixteen {
    __m512 before, middle, after;
    explicit Sixteen(__m512 distance) {
        const __m512 low = _mm512_fmsub_ps(distance, _mm512_set1_ps(root), _mm512_set1_ps(0.5f * root));
        const __m512 high = _mm512_fmadd_ps(distance, _mm512_set1_ps(root), _mm512_set1_ps(0.5f * root));
        before = _mm512_mul_ps(low, low);
        middle = _mm512_fnmadd_ps(distance, distance, _mm512_set1_ps(0.75f));
        after = _mm512_mul_ps(high, high);
    }
};

} // namespace

bool Spline::is_available() {
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
           __builtin_cpu_supports("avx512dq");
}

namespace {

constexpr std::size_t block_size = 256; // elements between which a stage's results wait in the first cache

// What the look-up of each element of a block needs, and what it finds.
struct Block {
    alignas(64) std::uint32_t offset[block_size]; // of the first control point's first number
    alignas(64) float along[3][block_size];       // weights of the rows
    alignas(64) float across[4 * block_size];     // and of an element's columns: before, middle, after, 0
    alignas(64) float color[4 * block_size];      // r, g, b, b
};

// Rows of four numbers to columns, in every quarter.
struct Transposed {
    __m512 first, second, third, fourth;
    Transposed(__m512 a, __m512 b, __m512 c, __m512 d) {
        const __m512 low_ab = _mm512_unpacklo_ps(a, b), low_cd = _mm512_unpacklo_ps(c, d);
        const __m512 high_ab = _mm512_unpackhi_ps(a, b), high_cd = _mm512_unpackhi_ps(c, d);
        first = _mm512_shuffle_ps(low_ab, low_cd, 0x44);
        second = _mm512_shuffle_ps(low_ab, low_cd, 0xee);
        third = _mm512_shuffle_ps(high_ab, high_cd, 0x44);
        fourth = _mm512_shuffle_ps(high_ab, high_cd, 0xee);
    }
};

__mmask16 mask_of(std::size_t rest) {
    return rest >= 16 ? __mmask16(0xffff) : __mmask16((1u << rest) - 1);
}

// Quarter q of vector e belongs to element 4 q + e of sixteen.
void store_quarters(float *into, const Transposed &rows) {
    const __m512 of[4] = {rows.first, rows.second, rows.third, rows.fourth};
    for (int e = 0; e < 4; ++e) {
        _mm_store_ps(into + 4 * e, _mm512_castps512_ps128(of[e]));
        _mm_store_ps(into + 4 * (4 + e), _mm512_extractf32x4_ps(of[e], 1));
        _mm_store_ps(into + 4 * (8 + e), _mm512_extractf32x4_ps(of[e], 2));
        _mm_store_ps(into + 4 * (12 + e), _mm512_extractf32x4_ps(of[e], 3));
    }
}

void find_coordinates(Block &block, const Axis &x, const Axis &y, const float *cos_theta, const float *thickness_nm,
                      std::size_t count) {
    constexpr int nearest = _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC;
    for (std::size_t i = 0; i < count; i += 16) {
        const __mmask16 mask = mask_of(count - i);
        const __m512 cosine = _mm512_maskz_loadu_ps(mask, cos_theta + i);
        const __m512 d = _mm512_maskz_loadu_ps(mask, thickness_nm + i);
        const __m512 px = x.position(cosine, d), py = y.position(cosine, d);
        const __m512 column = _mm512_roundscale_ps(px, nearest), row = _mm512_roundscale_ps(py, nearest);
        const Sixteen u(_mm512_sub_ps(px, column)), v(_mm512_sub_ps(py, row));
        const __m512 point = _mm512_fmadd_ps(row, _mm512_set1_ps(Spline::width), column);
        _mm512_store_si512(block.offset + i, _mm512_slli_epi32(_mm512_cvtps_epi32(point), 2));
        _mm512_store_ps(block.along[0] + i, v.before);
        _mm512_store_ps(block.along[1] + i, v.middle);
        _mm512_store_ps(block.along[2] + i, v.after);
        store_quarters(block.across + 4 * i, {u.before, u.middle, u.after, _mm512_setzero_ps()});
    }
}

// An element's three rows of three control points: two columns in one register, the third in another.
void look_up(Block &block, const float *table, std::size_t count) {
    constexpr int row = 4 * Spline::width;
    const __m256i by_column = _mm256_setr_epi32(0, 0, 0, 0, 1, 1, 1, 1);
    for (std::size_t i = 0; i < count; ++i) {
        const float *corner = table + block.offset[i];
        const __m256 v0 = _mm256_set1_ps(block.along[0][i]);
        const __m256 v1 = _mm256_set1_ps(block.along[1][i]), v2 = _mm256_set1_ps(block.along[2][i]);
        __m256 two = _mm256_mul_ps(_mm256_loadu_ps(corner), v0);
        __m128 third = _mm_mul_ps(_mm_loadu_ps(corner + 8), _mm256_castps256_ps128(v0));
        two = _mm256_fmadd_ps(_mm256_loadu_ps(corner + row), v1, two);
        third = _mm_fmadd_ps(_mm_loadu_ps(corner + row + 8), _mm256_castps256_ps128(v1), third);
        two = _mm256_fmadd_ps(_mm256_loadu_ps(corner + 2 * row), v2, two);
        third = _mm_fmadd_ps(_mm_loadu_ps(corner + 2 * row + 8), _mm256_castps256_ps128(v2), third);
        const __m128 columns = _mm_load_ps(block.across + 4 * i);
        two = _mm256_mul_ps(two, _mm256_permutevar_ps(_mm256_set_m128(columns, columns), by_column));
        const __m128 sum = _mm_fmadd_ps(third, _mm_permute_ps(columns, 0xaa), _mm256_castps256_ps128(two));
        _mm_store_ps(block.color + 4 * i, _mm_add_ps(sum, _mm256_extractf128_ps(two, 1)));
    }
}

void store_channels(const Block &block, float *r, float *g, float *b, std::size_t count) {
    // Element 4 e + q into place 4 q + e, after the transposition back into its own.
    const __m512i order = _mm512_setr_epi32(0, 4, 8, 12, 1, 5, 9, 13, 2, 6, 10, 14, 3, 7, 11, 15);
    for (std::size_t i = 0; i < count; i += 16) {
        const float *color = block.color + 4 * i;
        const Transposed channels(_mm512_load_ps(color), _mm512_load_ps(color + 16), _mm512_load_ps(color + 32),
                                  _mm512_load_ps(color + 48));
        const __mmask16 mask = mask_of(count - i);
        _mm512_mask_storeu_ps(r + i, mask, _mm512_permutexvar_ps(order, channels.first));
        _mm512_mask_storeu_ps(g + i, mask, _mm512_permutexvar_ps(order, channels.second));
        _mm512_mask_storeu_ps(b + i, mask, _mm512_permutexvar_ps(order, channels.third));
    }
}

} // namespace

// In three stages, so that nothing is loaded before it has left the store buffer: a wide load of what narrow
// stores wrote would have to wait.
void Spline::at_each(const float *cos_theta, const float *thickness_nm, float *r, float *g, float *b,
                     std::size_t count) const {
    const Axis across(x), along(y);
    Block results;
    for (std::size_t i = 0; i < count; i += block_size) {
        const std::size_t rest = std::min(block_size, count - i);
        find_coordinates(results, across, along, cos_theta + i, thickness_nm + i, rest);
        look_up(results, points.data(), rest);
        store_channels(results, r + i, g + i, b + i, rest);
    }
}

#else

bool Spline::is_available() {
    return false;
}

void Spline::at_each(const float *cos_theta, const float *thickness_nm, float *r, float *g, float *b,
                     std::size_t count) const {
    for (std::size_t i = 0; i < count; ++i) {
        float rgb[3];
        at(cos_theta[i], thickness_nm[i], rgb);
        r[i] = rgb[0];
        g[i] = rgb[1];
        b[i] = rgb[2];
    }
}

#endif
