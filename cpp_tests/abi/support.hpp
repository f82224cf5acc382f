// What the ABI tests share: the catalogue of models, handles with everything varying, films, random
// inputs, and memory whose end is guarded.
#pragma once

#include "pages.hpp"

#include <pellicle.hpp>

#include <doctest/doctest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace support {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float quiet_nan = std::numeric_limits<float>::quiet_NaN();

using Vec3 = std::array<float, 3>;

// A medium in the C structs, by its name or with an index that is the same at every wavelength.
PellicleMedium medium(const char *name);
PellicleMedium medium(float eta, float k = 0.0f);

// A film's description with all that it points to, for a test to spoil. The pointers and sizes of `desc` are
// set by raw().
struct FilmDescription {
    struct Layer {
        PellicleMedium medium;
        float thickness_min_nm, thickness_max_nm;
    };
    PellicleMedium base = medium(1.5f), ambient{};
    std::vector<Layer> layers;
    PellicleFilmDesc desc{};

    const PellicleFilmDesc &raw();
    // The status of its creation. What it makes is released at once; a failure must make nothing.
    PellicleStatus create();

private:
    std::vector<PellicleMedium> media_;
    std::vector<PellicleLayer> raw_layers_;
};

// The SIMD level that all BSDFs and films of support are made with: that of the environment variable
// ABI_TEST_SIMD_LEVEL, by default the widest.
const char *simd_level();

// Transparent films of one layer that keep their transmittance. The layer's thickness varies within
// [0, 400] nm.
const pellicle::Film &varying_film();
constexpr float varying_film_max_nm = 400.0f;
const pellicle::Film &fixed_film();

// A model as introspection describes it. Tests iterate over all of them, so that a new model cannot
// be forgotten.
struct Model {
    PellicleModelInfo info;
    // The range of a film's thickness is narrowed to that of varying_film(), that of alpha to what may
    // vary; where a film is not a must, there is none and its thickness is left out.
    std::vector<PellicleModelParam> params;
    // The parameter whose choice "film" makes the model take a film; NULL: it is left at its default.
    const char *film_param = nullptr;

    bool takes_film() const { return info.needs_film || film_param; }
};
std::vector<Model> models();

// The same, and those that can take a film without needing one a second time, with their film.
std::vector<Model> models_with_and_without_film();

// Whether a parameter has an effect with these choices; the library refuses one that has none.
bool has_effect(const Model &model, const PellicleModelParam &param, std::vector<PellicleParam> choices = {});

// The film for a BSDF, if its model takes one: that with a varying thickness if one is stated.
pellicle::Film film_for(const Model &model, bool has_thickness);

// The model with every parameter at its default, but for that which makes it take a film.
pellicle::BsdfBuilder builder(const Model &model);

// A BSDF in which every parameter that can vary does, in the order of introspection.
class Varying {
public:
    using Create = std::function<pellicle::Bsdf(const pellicle::BsdfBuilder &)>;
    explicit Varying(const Model &model, const Create &create = {});

    const pellicle::Bsdf &bsdf() const { return bsdf_; }
    std::size_t floats() const { return lows_.size(); }
    // How many components each varying parameter has.
    const std::vector<std::size_t> &components() const { return components_; }
    // Valid values of all components, one after another.
    std::vector<float> random_values(std::mt19937 &random) const;

private:
    pellicle::Bsdf bsdf_;
    std::vector<std::size_t> components_;
    std::vector<float> lows_, highs_;
};

// Unit, z > 0, uniform over the hemisphere.
Vec3 random_direction(std::mt19937 &random);
// Each in [0, 1).
Vec3 random_uniforms(std::mt19937 &random);

// Equality of representation: NaN equals itself and -0 is not 0.
bool same_bits(const float *a, const float *b, std::size_t count);
bool same_bits(const PellicleSample &a, const PellicleSample &b);

// The result of any finite input.
bool finite_and_non_negative(const float *values, std::size_t count);
bool all_zero(const PellicleSample &sample);

// The text of the latest failure of this thread contains these words.
bool message_has(const std::string &words);

// The status of a description as it is. What it makes is released at once; a failure must make nothing.
PellicleStatus create_film(const PellicleFilmDesc &desc);

/// Runs something again and again: it must leave nothing behind. The allocator gives 16 bytes at least, so that a
/// leak in every round is more than 8 for each; its caches, which the first rounds fill, change by less.
template <class Round> void check_no_growth(int first_rounds, int rounds, Round round) {
    for (int i = 0; i < first_rounds; ++i) round();
    const std::size_t before = pages::bytes_in_use();
    for (int i = 0; i < rounds; ++i) round();
    CHECK_LT(pages::bytes_in_use(), before + 8 * static_cast<std::size_t>(rounds));
}

// An output full of a pattern that no call writes, and that a failing call must leave.
template <class Output> struct Untouched {
    Output output;
    Untouched() { restore(); }
    void restore() { std::memset(&output, 0x5A, sizeof output); }
    ~Untouched() {
        unsigned char pattern[sizeof output];
        std::memset(pattern, 0x5A, sizeof pattern);
        CHECK_EQ(std::memcmp(&output, pattern, sizeof output), 0);
    }
};

// The type that a function returns, for decltype.
template <class Result, class... Parameters> Result result_of(Result (*)(Parameters...));

// `size` bytes that end where an inaccessible page begins: an access past them stops the program.
// Aligned for any type if `size` is a multiple of 16, of 8 if it is a multiple of 8.
class GuardedBytes {
public:
    explicit GuardedBytes(std::size_t size);
    ~GuardedBytes();
    GuardedBytes(const GuardedBytes &) = delete;
    GuardedBytes &operator=(const GuardedBytes &) = delete;

    template <class T> T *as() { return reinterpret_cast<T *>(data_); }

private:
    unsigned char *mapping_;
    std::size_t mapped_;
    unsigned char *data_;
};

} // namespace support

// A call refused as INVALID_ARGUMENT (and so on), with a message that contains `words`.
#define CHECK_REFUSED(call, expected_status, words)                                                          \
    do {                                                                                                     \
        CHECK_EQ((call), (expected_status));                                                                 \
        CAPTURE(std::string(pellicle_last_error()));                                                                      \
        CHECK(support::message_has(words));                                                                  \
    } while (false)
