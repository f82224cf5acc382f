// Data never fails: cosines, thicknesses and wavelengths of any value, in every call of a film.
#include "support.hpp"

#include <cmath>
#include <functional>

namespace {

using support::infinity;
using support::quiet_nan;
using support::Vec3;

constexpr float max_float = std::numeric_limits<float>::max();
constexpr float denormal = std::numeric_limits<float>::denorm_min();

constexpr float min_nm = 100.0f, max_nm = 300.0f;

// A call of a film with its six or fewer numbers.
struct Call {
    const char *name;
    std::function<std::vector<float>(const pellicle::Film &, float cos_theta, float thickness_nm)> numbers;
};

std::vector<float> eval(const pellicle::Film &film, float cos_theta, float thickness_nm, std::uint32_t side) {
    const pellicle::FilmColors colors = film.eval(cos_theta, thickness_nm, side);
    std::vector<float> numbers(colors.reflectance.begin(), colors.reflectance.end());
    numbers.insert(numbers.end(), colors.transmittance.begin(), colors.transmittance.end());
    return numbers;
}

std::vector<float> as_vector(const Vec3 &rgb) {
    return {rgb.begin(), rgb.end()};
}

const std::vector<Call> calls = {
    {"reflectance", [](const pellicle::Film &film, float cos_theta, float thickness_nm) {
         return as_vector(film.reflectance(cos_theta, thickness_nm));
     }},
    {"eval from the ambient", [](const pellicle::Film &film, float cos_theta, float thickness_nm) {
         return eval(film, cos_theta, thickness_nm, PELLICLE_SIDE_AMBIENT);
     }},
    {"eval from the base", [](const pellicle::Film &film, float cos_theta, float thickness_nm) {
         return eval(film, cos_theta, thickness_nm, PELLICLE_SIDE_BASE);
     }},
    {"reflectance_batch", [](const pellicle::Film &film, float cos_theta, float thickness_nm) {
         std::vector<float> numbers(3, -1.0f);
         PellicleFilmBatchArgs args{};
         args.count = 1;
         args.cos_theta = {&cos_theta, 4, 4};
         args.thickness_nm = {&thickness_nm, 4, 4};
         args.reflectance = {numbers.data(), 12, 4};
         film.reflectance_batch(args);
         return numbers;
     }},
    {"reference", [](const pellicle::Film &film, float cos_theta, float thickness_nm) {
         return as_vector(film.reference(cos_theta, thickness_nm));
     }},
    {"spectrum", [](const pellicle::Film &film, float cos_theta, float thickness_nm) {
         const float lambda_nm[2] = {450.0f, 650.0f};
         std::vector<float> numbers(2, -1.0f);
         film.spectrum(cos_theta, thickness_nm, lambda_nm, 2, numbers.data());
         return numbers;
     }},
    {"spectrum_eval", [](const pellicle::Film &film, float cos_theta, float thickness_nm) {
         const float lambda_nm[2] = {450.0f, 650.0f};
         std::vector<float> numbers(4, -1.0f);
         film.spectrum_eval(cos_theta, thickness_nm, PELLICLE_SIDE_BASE, lambda_nm, 2, numbers.data(), numbers.data() + 2);
         return numbers;
     }},
    {"amplitudes, |r|^2", [](const pellicle::Film &film, float cos_theta, float thickness_nm) {
         const float lambda_nm[2] = {450.0f, 650.0f};
         PellicleAmplitudes found[2];
         film.amplitudes(cos_theta, thickness_nm, PELLICLE_SIDE_AMBIENT, lambda_nm, 2, found);
         std::vector<float> numbers;
         for (const PellicleAmplitudes &at : found)
             for (const auto &r : {at.r_s, at.r_p}) numbers.push_back(r[0] * r[0] + r[1] * r[1]);
         return numbers;
     }},
};

bool same(const std::vector<float> &a, const std::vector<float> &b) {
    return a.size() == b.size() && support::same_bits(a.data(), b.data(), a.size());
}

const pellicle::Film &film() {
    static const pellicle::Film film =
        pellicle::FilmBuilder("BK7").layer("water", min_nm, max_nm).transmittance().extrapolate().create();
    return film;
}

} // namespace

TEST_CASE("film data: cosines are clamped to [0, 1]") {
    for (const Call &call : calls) {
        CAPTURE(std::string(call.name));
        const auto at = [&](float cos_theta) { return call.numbers(film(), cos_theta, 200.0f); };
        for (const float above : {1.0000001f, 2.0f, max_float, infinity}) CHECK(same(at(above), at(1.0f)));
        for (const float below : {-0.0f, -1e-30f, -1.0f, -max_float, -infinity}) CHECK(same(at(below), at(0.0f)));
        CHECK_FALSE(same(at(0.0f), at(1.0f)));
    }
}

TEST_CASE("film data: thicknesses are clamped to the layer's range") {
    for (const Call &call : calls) {
        CAPTURE(std::string(call.name));
        const auto at = [&](float thickness_nm) { return call.numbers(film(), 0.8f, thickness_nm); };
        for (const float above : {301.0f, 1e8f, max_float, infinity}) CHECK(same(at(above), at(max_nm)));
        for (const float below : {99.0f, 0.0f, -1.0f, -max_float, -infinity}) CHECK(same(at(below), at(min_nm)));
        CHECK_FALSE(same(at(min_nm), at(max_nm)));
    }
}

TEST_CASE("film data: where no layer varies, every thickness is alike") {
    for (const Call &call : calls) {
        CAPTURE(std::string(call.name));
        const auto at = [&](float thickness_nm) { return call.numbers(support::fixed_film(), 0.8f, thickness_nm); };
        for (const float any : {-1.0f, 1e8f, infinity, -infinity}) CHECK(same(at(any), at(0.0f)));
    }
}

TEST_CASE("film data: NaN as cosine or thickness gives 0") {
    for (const Call &call : calls) {
        CAPTURE(std::string(call.name));
        for (const float nan : {quiet_nan, -quiet_nan})
            for (const pellicle::Film &subject : {film(), support::fixed_film()}) {
                for (const float number : call.numbers(subject, nan, 200.0f)) CHECK_EQ(number, 0.0f);
                for (const float number : call.numbers(subject, 0.8f, nan)) CHECK_EQ(number, 0.0f);
                for (const float number : call.numbers(subject, nan, nan)) CHECK_EQ(number, 0.0f);
            }
    }
}

TEST_CASE("film data: odd numbers give results within [0, 1]") {
    for (const Call &call : calls) {
        CAPTURE(std::string(call.name));
        for (const float cos_theta : {0.0f, denormal, 1e-20f, 1e-6f, 0.5f, 0.99999994f, 1.0f})
            for (const float thickness_nm : {0.0f, denormal, min_nm, 150.0f, max_nm})
                for (const float number : call.numbers(film(), cos_theta, thickness_nm)) {
                    CAPTURE(cos_theta);
                    CAPTURE(thickness_nm);
                    CHECK_GE(number, -1e-4f); // the reference is not clipped
                    CHECK_LE(number, 1.0f + 1e-4f);
                }
    }
}

TEST_CASE("film data: wavelengths of any positive length give a reflectance within [0, 1]") {
    const std::vector<float> lambda_nm = {denormal, 1e-30f, 1e-3f, 1.0f, 379.0f, 380.0f, 550.0f, 780.0f, 1e4f, max_float};
    std::vector<float> reflectance(lambda_nm.size(), -1.0f);
    for (const float cos_theta : {0.0f, 0.5f, 1.0f}) {
        film().spectrum(cos_theta, 200.0f, lambda_nm.data(), lambda_nm.size(), reflectance.data());
        std::vector<float> again(lambda_nm.size()), transmittance(lambda_nm.size());
        film().spectrum_eval(cos_theta, 200.0f, PELLICLE_SIDE_AMBIENT, lambda_nm.data(), lambda_nm.size(), again.data(),
                             transmittance.data());
        for (std::size_t i = 0; i < reflectance.size(); ++i) {
            CHECK_GE(reflectance[i], 0.0f);
            CHECK_LE(reflectance[i], 1.000001f);
            CHECK_EQ(again[i] + transmittance[i], doctest::Approx(1.0).epsilon(1e-6));
        }
    }
}

TEST_CASE("film data: the spectrum may be written over its wavelengths") {
    std::vector<float> lambda_nm = {400.0f, 500.0f, 600.0f, 700.0f};
    std::vector<float> reflectance(4);
    film().spectrum(0.7f, 200.0f, lambda_nm.data(), 4, reflectance.data());
    film().spectrum(0.7f, 200.0f, lambda_nm.data(), 4, lambda_nm.data());
    CHECK(same(lambda_nm, reflectance));
    for (std::size_t i = 1; i < 4; ++i) CHECK_NE(reflectance[i], reflectance[0]);
}
