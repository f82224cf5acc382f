// What all contenders read and where they write, in both layouts.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

constexpr std::size_t element_count = std::size_t(1) << 20;
constexpr std::size_t tile_count = 4096; // 144 KB in and out: stays in the second cache

using Vec3 = std::array<float, 3>;

// `components` planes of `count` numbers each, in one piece of memory. Between them are some lines more, so
// that the same element of all planes does not fall into the same set of the cache.
class Planes {
public:
    Planes(std::size_t components, std::size_t count) : stride(count + 272), numbers(components * stride) {}

    float *operator[](std::size_t component) { return &numbers[component * stride]; }
    const float *operator[](std::size_t component) const { return &numbers[component * stride]; }

    // From one component to the next.
    std::ptrdiff_t bytes() const { return std::ptrdiff_t(stride * sizeof(float)); }

    void fill(float number) { std::fill(numbers.begin(), numbers.end(), number); }

private:
    std::size_t stride;
    std::vector<float> numbers;
};

// The same in both layouts.
struct Vectors {
    std::vector<Vec3> packed; // array of structures
    Planes planes;            // structure of arrays

    explicit Vectors(std::size_t count) : packed(count), planes(3, count) {}

    void set(std::size_t i, const Vec3 &v) {
        packed[i] = v;
        for (std::size_t c = 0; c < 3; ++c) planes[c][i] = v[c];
    }
};

// A cosine and a thickness side by side.
struct Angle {
    float cos_theta, thickness_nm;
};

// Random directions, uniform numbers, and what a texture would give.
struct Elements {
    Vectors wo, wi, u;
    std::vector<float> layer_nm, alpha, film_nm;
    std::vector<Angle> angles; // wi.z and film_nm

    // The same for the same count.
    explicit Elements(std::size_t count);
};

// Of a sampled direction, or of a value with the first three numbers alone.
struct Sampled {
    Vec3 wi;
    float pdf;
    Vec3 weight;
};

constexpr std::size_t sampled_floats = sizeof(Sampled) / sizeof(float);

struct Outputs {
    std::vector<Vec3> values;
    std::vector<Sampled> samples;
    Planes planes;

    explicit Outputs(std::size_t count) : values(count), samples(count), planes(sampled_floats, count) {}

    // So that what is not written is noticed.
    void forget() {
        constexpr float nan = std::numeric_limits<float>::quiet_NaN();
        std::fill(values.begin(), values.end(), Vec3{nan, nan, nan});
        std::fill(samples.begin(), samples.end(), Sampled{{nan, nan, nan}, nan, {nan, nan, nan}});
        planes.fill(nan);
    }
};
