// Spectral calls through the C interface: values, the hero's direction, refusals, and batches.
#include "strided.hpp"
#include "support.hpp"

#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace {

using support::Layout;
using support::layouts;
using support::quiet_nan;
using support::Strided;
using support::Untouched;

const support::Vec3 up{0.0f, 0.0f, 1.0f};
const support::Vec3 slanted{0.0f, 0.6f, 0.8f};
const support::Vec3 halves{0.5f, 0.5f, 0.5f};
constexpr float pi = 3.14159265f;

pellicle::Bsdf colored_lambert() {
    return pellicle::BsdfBuilder("lambert").vary("reflectance", 0.0f, 1.0f).create();
}

// A direction above the surface.
support::Vec3 upper(std::mt19937 &random) {
    support::Vec3 w = support::random_direction(random);
    w[2] = std::fabs(w[2]);
    return w;
}

// A smooth surface of bare glass, which transmits.
pellicle::Bsdf glass() {
    support::FilmDescription film;
    film.layers.clear();
    film.base = support::medium("BK7");
    film.desc.transmittance = 1;
    return pellicle::BsdfBuilder("film").film(pellicle::Film(film.raw())).create();
}

} // namespace

TEST_CASE("spectral: a diffuse colour is one number for each wavelength") {
    const pellicle::Bsdf bsdf = colored_lambert();
    const float lambda_nm[5] = {400.0f, 500.0f, 550.0f, 600.0f, 700.0f};
    const float colors[5] = {0.0f, 0.25f, 0.5f, 0.75f, 1.0f};
    float value[5], pdf[5];
    bsdf.eval_spectral(up, slanted, lambda_nm, 5, value, pdf, colors);
    for (int j = 0; j < 5; ++j) {
        CHECK_EQ(value[j], doctest::Approx(colors[j] * 0.8 / pi).epsilon(1e-6));
        CHECK_EQ(pdf[j], doctest::Approx(0.8 / pi).epsilon(1e-6));
    }
    float weight[5];
    const PellicleSpectralSample sample = bsdf.sample_spectral(up, halves, lambda_nm, 5, 3, weight, nullptr, colors);
    for (int j = 0; j < 5; ++j) CHECK_EQ(weight[j], doctest::Approx(colors[j]).epsilon(1e-6).scale(1.0));
    CHECK_EQ(sample.flags, PELLICLE_REFLECTION | PELLICLE_DIFFUSE);
    CHECK_EQ(sample.hero_only, 0);
    CHECK_EQ(sample.eta, 1.0f);
}

// Indices from Schott's data sheet of N-BK7: n_C, n_d and n_F.
TEST_CASE("spectral: refraction by glass follows the hero alone") {
    const pellicle::Bsdf bsdf = glass();
    const float lambda_nm[3] = {656.27f, 587.56f, 486.13f};
    const double index[3] = {1.51432, 1.51680, 1.52238};
    for (std::size_t hero = 0; hero < 3; ++hero) {
        CAPTURE(hero);
        float weight[3], pdf[3];
        const support::Vec3 late{0.99f, 0.5f, 0.5f};
        const auto refracted = bsdf.sample_spectral(slanted, late, lambda_nm, 3, hero, weight, pdf);
        REQUIRE_EQ(refracted.flags, PELLICLE_TRANSMISSION | PELLICLE_DELTA);
        CHECK_EQ(refracted.hero_only, 1);
        CHECK_EQ(refracted.wi[1], doctest::Approx(-0.6 / index[hero]).epsilon(1e-5));
        CHECK_EQ(refracted.eta, doctest::Approx(index[hero]).epsilon(1e-5));
        for (std::size_t j = 0; j < 3; ++j) {
            CHECK_EQ(pdf[j], j == hero ? refracted.lobe_probability : 0.0f);
            // T / p is 1 as nothing absorbs, radiance falls by the square of the index, and the hero counts for all.
            const double expected = j == hero ? 3.0 / (index[hero] * index[hero]) : 0.0;
            CHECK_EQ(weight[j], doctest::Approx(expected).epsilon(1e-4).scale(1.0));
        }
        const support::Vec3 early{0.001f, 0.5f, 0.5f};
        const auto reflected = bsdf.sample_spectral(slanted, early, lambda_nm, 3, hero, weight, pdf);
        REQUIRE_EQ(reflected.flags, PELLICLE_REFLECTION | PELLICLE_DELTA);
        CHECK_EQ(reflected.hero_only, 0);
        // R_j / mean R: their mean is 1.
        CHECK_EQ(weight[0] + weight[1] + weight[2], doctest::Approx(3.0).epsilon(1e-5));
        CHECK_GT(weight[2], weight[0]);
    }
}

TEST_CASE("spectral: a mirror of gold has gold's spectrum") {
    support::FilmDescription film;
    film.layers.clear();
    film.base = support::medium("Au");
    const pellicle::Film gold(film.raw());
    const pellicle::Bsdf mirror = pellicle::BsdfBuilder("microfacet")
                                      .set("alpha", {0.0f})
                                      .choose("fresnel", "conductor")
                                      .choose("metal", "Au")
                                      .create();
    float lambda_nm[16], weight[16], spectrum[16];
    for (int j = 0; j < 16; ++j) lambda_nm[j] = 400.0f + 20.0f * static_cast<float>(j);
    mirror.sample_spectral(slanted, halves, lambda_nm, 16, 7, weight, nullptr);
    gold.spectrum(0.8f, 0.0f, lambda_nm, 16, spectrum);
    for (int j = 0; j < 16; ++j) CHECK_EQ(weight[j], doctest::Approx(spectrum[j]).epsilon(1e-5));
    CHECK_GT(weight[15], 2.0f * weight[0]);
}

TEST_CASE("spectral: counts, heroes and wavelengths that do not exist are refused by name") {
    const pellicle::Bsdf bsdf = colored_lambert();
    std::vector<float> lambda_nm(20, 550.0f), colors(20, 0.5f);
    Untouched<float[20]> value, pdf;
    Untouched<PellicleSpectralSample> sample;
    const auto eval = [&](std::size_t count) {
        return pellicle_bsdf_eval_spectral(bsdf.raw(), up.data(), up.data(), colors.data(), nullptr, lambda_nm.data(), count,
                                           value.output, pdf.output);
    };
    const auto draw = [&](std::size_t count, std::size_t hero) {
        return pellicle_bsdf_sample_spectral(bsdf.raw(), up.data(), halves.data(), colors.data(), nullptr, lambda_nm.data(),
                                             count, hero, value.output, pdf.output, &sample.output, sizeof sample.output);
    };
    for (const std::size_t count : {std::size_t{0}, std::size_t{17}, SIZE_MAX}) {
        CAPTURE(count);
        CHECK_REFUSED(eval(count), PELLICLE_OUT_OF_RANGE, "wavelengths");
        CHECK_REFUSED(draw(count, 0), PELLICLE_OUT_OF_RANGE, "wavelengths");
    }
    CHECK_REFUSED(draw(4, 4), PELLICLE_OUT_OF_RANGE, "hero = 4");
    for (const float bad : {0.0f, -1.0f, quiet_nan, support::infinity}) {
        lambda_nm[2] = bad;
        CHECK_REFUSED(eval(4), PELLICLE_OUT_OF_RANGE, "lambda_nm[2]");
        CHECK_REFUSED(draw(4, 0), PELLICLE_OUT_OF_RANGE, "lambda_nm[2]");
    }
    // Beyond the data of a medium.
    const pellicle::Bsdf silicon = pellicle::BsdfBuilder("microfacet").choose("fresnel", "conductor").choose("metal", "Au").create();
    const float far_nm = 1e6f;
    CHECK_REFUSED(pellicle_bsdf_eval_spectral(silicon.raw(), up.data(), up.data(), nullptr, nullptr, &far_nm, 1, value.output,
                                              nullptr),
                  PELLICLE_OUT_OF_RANGE, "lambda_nm[0]");
}

TEST_CASE("spectral: what three numbers do not determine is refused with the parameter's name") {
    const float nm = 550.0f;
    Untouched<float> value;
    const auto refuse = [&](const pellicle::Bsdf &bsdf, PellicleStatus status, const char *words) {
        CHECK_REFUSED(pellicle_bsdf_eval_spectral(bsdf.raw(), up.data(), up.data(), nullptr, nullptr, &nm, 1, &value.output,
                                                  nullptr),
                      status, words);
    };
    refuse(pellicle::BsdfBuilder("lambert").set("reflectance", {0.9f, 0.5f, 0.1f}).create(), PELLICLE_UNSUPPORTED,
           "'reflectance'");
    refuse(pellicle::BsdfBuilder("microfacet").set("f90", {0.9f, 0.5f, 1.0f}).create(), PELLICLE_UNSUPPORTED, "'f90'");
    refuse(pellicle::BsdfBuilder("lambert").set("reflectance", {0.9f, 0.5f, 0.1f}).vary("reflectance", 0, 1).create(),
           PELLICLE_INVALID_ARGUMENT, "'reflectance'");
    // Indices at three wavelengths are a spectrum.
    const pellicle::Bsdf dispersing = pellicle::BsdfBuilder("microfacet")
                                          .choose("fresnel", "dielectric")
                                          .set("eta", {1.5f, 1.6f, 1.7f})
                                          .create();
    float value_at[1];
    dispersing.eval_spectral(up, up, &nm, 1, value_at, nullptr);
    CHECK_GT(value_at[0], 0.0f);
}

TEST_CASE("spectral: bad directions and values give 0 and do not disturb other wavelengths") {
    const pellicle::Bsdf bsdf = colored_lambert();
    const float lambda_nm[3] = {450.0f, 550.0f, 650.0f};
    const float colors[3] = {0.5f, quiet_nan, 0.5f};
    float value[3], pdf[3];
    bsdf.eval_spectral(up, slanted, lambda_nm, 3, value, pdf, colors);
    CHECK_GT(value[0], 0.0f);
    CHECK_EQ(value[1], 0.0f);
    CHECK_EQ(pdf[1], 0.0f);
    CHECK_EQ(value[0], value[2]);
    const support::Vec3 below{0.0f, 0.6f, -0.8f}, nothing{0.0f, quiet_nan, 0.0f};
    for (const support::Vec3 &bad : {below, nothing}) {
        bsdf.eval_spectral(bad, slanted, lambda_nm, 3, value, pdf);
        for (int j = 0; j < 3; ++j) CHECK_EQ(value[j] + pdf[j], 0.0f);
        const auto sample = bsdf.sample_spectral(bad, halves, lambda_nm, 3, 0, value, pdf);
        CHECK_EQ(sample.lobe_probability, 0.0f);
        CHECK_EQ(sample.flags, 0);
        for (int j = 0; j < 3; ++j) CHECK_EQ(value[j] + pdf[j], 0.0f);
    }
}

TEST_CASE("spectral: batches equal single calls in every layout") {
    const pellicle::Bsdf bsdf = pellicle::BsdfBuilder("metallic_roughness")
                                    .vary("base_color", 0.0f, 1.0f)
                                    .vary("roughness", 0.1f, 1.0f)
                                    .create();
    constexpr std::size_t count = 9, lambdas = 5, hero = 2;
    for (const Layout &in : layouts)
        for (const Layout &out : layouts) {
            CAPTURE(std::string(in.name));
            CAPTURE(std::string(out.name));
            Strided wo(in, count, 3), wi(in, count, 3), u(in, count, 3), lambda_nm(in, count, lambdas),
                color(in, count, lambdas), roughness(in, count, 1);
            std::mt19937 random(19);
            const auto fill = [&](Strided &target, std::size_t i, const float *numbers, std::size_t components) {
                for (std::size_t c = 0; c < components; ++c) target.set(i, c, numbers[c]);
            };
            for (std::size_t i = 0; i < count; ++i) {
                const support::Vec3 view = upper(random), light = upper(random);
                fill(wo, i, view.data(), 3);
                fill(wi, i, light.data(), 3);
                const support::Vec3 uniforms = support::random_uniforms(random);
                fill(u, i, uniforms.data(), 3);
                roughness.set(i, 0, 0.1f + 0.9f * uniforms[1]);
                for (std::size_t c = 0; c < lambdas; ++c) {
                    lambda_nm.set(i, c, 400.0f + 70.0f * static_cast<float>(c) + uniforms[0]);
                    color.set(i, c, uniforms[c % 3]);
                }
            }
            const PellicleConstView varying[2] = {color.const_view(), roughness.const_view()};
            Strided value(out, count, lambdas), pdf(out, count, lambdas), weight(out, count, lambdas),
                density(out, count, lambdas), directions(out, count, 3), probability(out, count, 1);
            PellicleEvalSpectralBatchArgs eval{};
            eval.count = count;
            eval.lambda_count = lambdas;
            eval.lambda_nm = lambda_nm.const_view();
            eval.wo = wo.const_view();
            eval.wi = wi.const_view();
            eval.varying = varying;
            eval.varying_count = 2;
            eval.value = value.view();
            eval.pdf = pdf.view();
            bsdf.eval_spectral_batch(eval);
            PellicleSampleSpectralBatchArgs draw{};
            draw.count = count;
            draw.lambda_count = lambdas;
            draw.hero = hero;
            draw.lambda_nm = lambda_nm.const_view();
            draw.wo = wo.const_view();
            draw.u = u.const_view();
            draw.varying = varying;
            draw.varying_count = 2;
            draw.wi = directions.view();
            draw.weight = weight.view();
            draw.pdf = density.view();
            draw.lobe_probability = probability.view();
            bsdf.sample_spectral_batch(draw);
            bool equal = true;
            for (std::size_t i = 0; i < count; ++i) {
                const auto vector = [&](const Strided &from) {
                    return support::Vec3{from.get(i, 0), from.get(i, 1), from.get(i, 2)};
                };
                float nm[lambdas], numbers[lambdas + 1], single[4][lambdas];
                for (std::size_t c = 0; c < lambdas; ++c) nm[c] = lambda_nm.get(i, c), numbers[c] = color.get(i, c);
                numbers[lambdas] = roughness.get(i, 0);
                bsdf.eval_spectral(vector(wo), vector(wi), nm, lambdas, single[0], single[1], numbers);
                const auto sample =
                    bsdf.sample_spectral(vector(wo), vector(u), nm, lambdas, hero, single[2], single[3], numbers);
                const Strided *outputs[] = {&value, &pdf, &weight, &density};
                for (int row = 0; row < 4; ++row)
                    for (std::size_t c = 0; c < lambdas; ++c) {
                        const float found = outputs[row]->get(i, c);
                        equal = equal && support::same_bits(&found, &single[row][c], 1);
                    }
                const float found[4] = {directions.get(i, 0), directions.get(i, 1), directions.get(i, 2),
                                        probability.get(i, 0)};
                const float expected[4] = {sample.wi[0], sample.wi[1], sample.wi[2], sample.lobe_probability};
                equal = equal && support::same_bits(found, expected, 4);
            }
            CHECK(equal);
            for (const Strided *output : {&value, &pdf, &weight, &density, &directions, &probability})
                CHECK(output->rest_untouched());
        }
}

TEST_CASE("spectral: batches refuse what is missing, and write nothing") {
    const pellicle::Bsdf bsdf = colored_lambert();
    const float numbers[3] = {0.0f, 0.0f, 1.0f};
    const float nm[2] = {550.0f, -1.0f};
    Untouched<float[3]> output;
    PellicleEvalSpectralBatchArgs valid{};
    valid.count = 2;
    valid.lambda_count = 1;
    valid.lambda_nm = {nm, 0, 4};
    valid.wo = valid.wi = {numbers, 0, 4};
    valid.value = {output.output, 4, 4};
    const auto refuse = [&](PellicleStatus status, const char *words, auto change) {
        PellicleEvalSpectralBatchArgs args = valid;
        change(args);
        CHECK_REFUSED(pellicle_bsdf_eval_spectral_batch(bsdf.raw(), &args, sizeof args), status, words);
    };
    refuse(PELLICLE_INVALID_ARGUMENT, "wo", [](auto &args) { args.wo.data = nullptr; });
    refuse(PELLICLE_INVALID_ARGUMENT, "wi", [](auto &args) { args.wi.data = nullptr; });
    refuse(PELLICLE_INVALID_ARGUMENT, "lambda_nm", [](auto &args) { args.lambda_nm.data = nullptr; });
    refuse(PELLICLE_INVALID_ARGUMENT, "value", [](auto &args) { args.value.data = nullptr; });
    refuse(PELLICLE_INVALID_ARGUMENT, "varying", [](auto &args) { args.varying_count = 1; });
    refuse(PELLICLE_OUT_OF_RANGE, "wavelengths", [](auto &args) { args.lambda_count = 17; });
    refuse(PELLICLE_OUT_OF_RANGE, "wavelengths", [](auto &args) { args.lambda_count = SIZE_MAX; });
    refuse(PELLICLE_OUT_OF_RANGE, "lambda_nm[0] of element 1", [](auto &args) { args.lambda_nm.element_stride = 4; });
    refuse(PELLICLE_INVALID_ARGUMENT, "overflow", [](auto &args) {
        args.count = SIZE_MAX / 8;
        args.wo.element_stride = PTRDIFF_MAX;
    });
    PellicleSampleSpectralBatchArgs draw{};
    draw.count = draw.lambda_count = 1;
    draw.hero = 1;
    draw.lambda_nm = {nm, 0, 4};
    draw.wo = draw.u = {numbers, 0, 4};
    draw.pdf = {output.output, 4, 4};
    CHECK_REFUSED(pellicle_bsdf_sample_spectral_batch(bsdf.raw(), &draw, sizeof draw), PELLICLE_OUT_OF_RANGE, "hero");
    draw.hero = 0;
    draw.u.data = nullptr;
    CHECK_REFUSED(pellicle_bsdf_sample_spectral_batch(bsdf.raw(), &draw, sizeof draw), PELLICLE_INVALID_ARGUMENT, "u");
    draw.pdf.data = nullptr;
    CHECK_REFUSED(pellicle_bsdf_sample_spectral_batch(bsdf.raw(), &draw, sizeof draw), PELLICLE_INVALID_ARGUMENT, "output");
}
