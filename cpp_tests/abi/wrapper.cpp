// pellicle.hpp: ownership, errors and the builder.
#include "support.hpp"

#include <utility>

namespace {

using support::Vec3;

const Vec3 up = {0.0f, 0.0f, 1.0f};
const Vec3 slanted = {0.0f, 0.6f, 0.8f};

} // namespace

TEST_CASE("wrapper: a copy shares the handle and outlives the original") {
    pellicle::Bsdf copy;
    {
        const auto original = pellicle::BsdfBuilder("lambert").create();
        copy = original;
        CHECK_EQ(copy.raw(), original.raw());
    }
    CHECK_EQ(copy.value(up, up)[0], doctest::Approx(0.5 / 3.14159265));
}

TEST_CASE("wrapper: a move leaves an empty handle, whose calls throw") {
    auto first = pellicle::BsdfBuilder("lambert").create();
    PellicleBsdf *const raw = first.raw();
    const pellicle::Bsdf second = std::move(first);
    CHECK_EQ(second.raw(), raw);
    CHECK_EQ(first.raw(), nullptr);
    CHECK_THROWS_AS(first.eval(up, up), pellicle::Error);
    CHECK_THROWS_AS(pellicle::Bsdf().info(), pellicle::Error);
}

TEST_CASE("wrapper: assignment to itself keeps the handle") {
    auto bsdf = pellicle::BsdfBuilder("lambert").create();
    const auto &same = bsdf;
    bsdf = same;
    CHECK_EQ(std::string(bsdf.info().model), "lambert");
}

TEST_CASE("wrapper: an error carries status and message, and outlives the next failure") {
    try {
        pellicle::BsdfBuilder("lambert").set("reflectance", 1.5f).create();
        FAIL("not refused");
    } catch (const pellicle::Error &error) {
        CHECK_EQ(error.status(), PELLICLE_OUT_OF_RANGE);
        const std::string message = error.what();
        CHECK_EQ(message, pellicle_last_error());
        CHECK_NE(message.find("reflectance"), std::string::npos);
        CHECK_EQ(pellicle_bsdf_info(nullptr, nullptr, 0), PELLICLE_INVALID_ARGUMENT);
        CHECK_EQ(message, error.what());
    }
}

TEST_CASE("wrapper: the builder describes what the C structs do") {
    const float eta[3] = {1.4f, 1.45f, 1.6f};
    const float exponent = 90.0f, thickness = 70.0f;
    const PellicleParam params[] = {{"eta", eta, 3, nullptr},
                                    {"exponent_reflection", &exponent, 1, nullptr},
                                    {"variant", nullptr, 0, "paper"},
                                    {"thickness_nm", &thickness, 1, nullptr}};
    const PellicleRange varying[] = {{"thickness_nm", 66.0f, 76.0f}};
    PellicleBsdfDesc desc{};
    desc.model = "layered";
    desc.params = params;
    desc.param_count = 4;
    desc.varying = varying;
    desc.varying_count = 1;
    const pellicle::Bsdf by_structs(desc);

    const auto builder = pellicle::BsdfBuilder("layered")
                             .set("eta", {1.4f, 1.45f, 1.6f})
                             .set("exponent_reflection", 90)
                             .choose("variant", "paper")
                             .set("thickness_nm", 70.0f)
                             .vary("thickness_nm", 66, 76);
    const pellicle::Bsdf by_names = builder.create();
    const auto a = by_structs.eval(up, slanted, &thickness), b = by_names.eval(up, slanted, &thickness);
    CHECK(support::same_bits(a.value.data(), b.value.data(), 3));
    CHECK_EQ(a.pdf, b.pdf);
    CHECK_EQ(by_names.info().varying_floats, 1);

    // A builder may be used again.
    CHECK_NE(builder.create().raw(), by_names.raw());
    CHECK_THROWS_AS(pellicle::BsdfBuilder("layered").choose("variant", "").create(), pellicle::Error);
}

TEST_CASE("wrapper: the calls return what the C functions write") {
    const auto bsdf = pellicle::BsdfBuilder("phong").create();
    const Vec3 u = {0.3f, 0.6f, 0.9f};
    float value[3], pdf, reverse, albedo[3];
    PellicleSample sample;
    REQUIRE_EQ(pellicle_bsdf_eval(bsdf.raw(), up.data(), slanted.data(), nullptr, nullptr, value, &pdf, &reverse), PELLICLE_OK);
    REQUIRE_EQ(pellicle_bsdf_sample(bsdf.raw(), up.data(), u.data(), nullptr, nullptr, &sample, sizeof sample), PELLICLE_OK);
    REQUIRE_EQ(pellicle_bsdf_albedo(bsdf.raw(), up.data(), nullptr, nullptr, albedo), PELLICLE_OK);
    CHECK(support::same_bits(bsdf.eval(up, slanted).value.data(), value, 3));
    CHECK_EQ(bsdf.eval(up, slanted).pdf, pdf);
    CHECK_EQ(bsdf.eval_both_ways(up, slanted).pdf_reverse, reverse);
    CHECK_EQ(bsdf.eval_both_ways(up, slanted).pdf, pdf);
    CHECK(support::same_bits(bsdf.value(up, slanted).data(), value, 3));
    CHECK_EQ(bsdf.pdf(up, slanted), pdf);
    CHECK(support::same_bits(bsdf.sample(up, u), sample));
    CHECK(support::same_bits(bsdf.albedo(up).data(), albedo, 3));
}

TEST_CASE("wrapper: a copy of a film shares the handle, a move leaves an empty one") {
    pellicle::Film copy;
    {
        const pellicle::Film original = pellicle::FilmBuilder("BK7").create();
        copy = original;
        CHECK_EQ(copy.raw(), original.raw());
    }
    CHECK_GT(copy.reflectance(1.0f)[0], 0.0f);
    PellicleFilm *const raw = copy.raw();
    const pellicle::Film moved = std::move(copy);
    CHECK_EQ(moved.raw(), raw);
    CHECK_EQ(copy.raw(), nullptr);
    CHECK_THROWS_AS(copy.reflectance(1.0f), pellicle::Error);
    CHECK_THROWS_AS(pellicle::Film().plan(), pellicle::Error);
}

TEST_CASE("wrapper: the film builder describes what the C structs do") {
    const float nm[] = {400.0f, 700.0f}, eta[] = {1.5f, 1.4f}, k[] = {0.1f, 0.0f};
    support::FilmDescription description;
    description.layers = {{support::medium("MgF2"), 80.0f, 80.0f}, {{}, 0.0f, 400.0f}, {support::medium(2.0f, 0.1f), 50.0f, 50.0f}};
    PellicleMedium &measured = description.layers[1].medium;
    measured.table_nm = nm;
    measured.table_eta = eta;
    measured.table_k = k;
    measured.table_count = 2;
    description.ambient = support::medium("water");
    for (int channel = 0; channel < 3; ++channel) {
        description.base.eta[channel] = 1.5f + 0.1f * float(channel);
        description.base.k[channel] = 0.2f * float(channel);
    }
    description.desc.tolerance = 1e-3f;
    description.desc.white = "D65";
    description.desc.color_space = "acescg";
    description.desc.method = "reference";
    description.desc.unclipped = description.desc.transmittance = 1;
    description.desc.base_opaque = PELLICLE_BASE_TRANSPARENT;
    description.desc.extrapolate = 1;
    const pellicle::Film by_structs(description.raw());

    using pellicle::Medium;
    const auto builder = pellicle::FilmBuilder(Medium::rgb({1.5f, 1.6f, 1.7f}, {0.0f, 0.2f, 0.4f}))
                             .ambient("water")
                             .layer(std::string("MgF2"), 80)
                             .layer(Medium::table({{400, 1.5f, 0.1f}, {700, 1.4f, 0.0f}}), 0, 400)
                             .layer(Medium::constant(2.0f, 0.1f), 50)
                             .tolerance(1e-3f)
                             .white("D65")
                             .color_space("acescg")
                             .method("reference")
                             .unclipped()
                             .transmittance()
                             .base_opaque(PELLICLE_BASE_TRANSPARENT)
                             .extrapolate();
    const pellicle::Film by_names = builder.create();
    const pellicle::FilmColors a = by_structs.eval(0.7f, 222.0f), b = by_names.eval(0.7f, 222.0f);
    CHECK(support::same_bits(a.reflectance.data(), b.reflectance.data(), 3));
    CHECK(support::same_bits(a.transmittance.data(), b.transmittance.data(), 3));
    CHECK_EQ(by_names.plan().tolerance, 1e-3f);
    CHECK_EQ(std::string(by_names.plan().method), "reference");
    CHECK_EQ(by_names.info().base_opaque, 0);
    const float infrared_nm = 1550.0f;
    float found = -1.0f;
    by_names.spectrum(0.7f, 222.0f, &infrared_nm, 1, &found);
    CHECK_GT(found, 0.0f);

    // A builder may be used again.
    CHECK_NE(builder.create().raw(), by_names.raw());
    CHECK_THROWS_AS(pellicle::FilmBuilder(Medium()).create(), pellicle::Error);
    CHECK_THROWS_AS(pellicle::FilmBuilder("BK7").layer(Medium::table({}), 10).create(), pellicle::Error);
}

TEST_CASE("wrapper: the calls of a film return what the C functions write") {
    const pellicle::Film &film = support::varying_film();
    float rgb[3], transmittance[3];
    REQUIRE_EQ(pellicle_film_reflectance(film.raw(), 0.7f, 123.0f, rgb), PELLICLE_OK);
    CHECK(support::same_bits(film.reflectance(0.7f, 123.0f).data(), rgb, 3));
    REQUIRE_EQ(pellicle_film_reference(film.raw(), 0.7f, 123.0f, rgb), PELLICLE_OK);
    CHECK(support::same_bits(film.reference(0.7f, 123.0f).data(), rgb, 3));
    REQUIRE_EQ(pellicle_film_eval(film.raw(), 0.7f, 123.0f, PELLICLE_SIDE_BASE, rgb, transmittance), PELLICLE_OK);
    const pellicle::FilmColors colors = film.eval(0.7f, 123.0f, PELLICLE_SIDE_BASE);
    CHECK(support::same_bits(colors.reflectance.data(), rgb, 3));
    CHECK(support::same_bits(colors.transmittance.data(), transmittance, 3));
    CHECK_FALSE(support::same_bits(film.eval(0.7f, 123.0f).transmittance.data(), transmittance, 3));
}

TEST_CASE("wrapper: create() into a handle returns the status, and keeps what was there on failure") {
    pellicle::Bsdf bsdf = pellicle::BsdfBuilder("phong").create();
    const PellicleBsdf *const phong = bsdf.raw();
    CHECK_EQ(pellicle::BsdfBuilder("no such model").create(bsdf), PELLICLE_UNKNOWN_NAME);
    CHECK_EQ(bsdf.raw(), phong);
    CHECK_EQ(pellicle::BsdfBuilder("lambert").create(bsdf), PELLICLE_OK);
    CHECK_EQ(std::string(bsdf.info().model), "lambert");
    pellicle::Film film;
    CHECK_EQ(pellicle::FilmBuilder("no such medium").create(film), PELLICLE_UNKNOWN_NAME);
    CHECK_EQ(film.raw(), nullptr);
    CHECK_EQ(pellicle::FilmBuilder("BK7").create(film), PELLICLE_OK);
    CHECK_GT(film.reflectance(1.0f)[0], 0.0f);
}

TEST_CASE("wrapper: a builder's BSDF has the film that it was given") {
    const pellicle::Film &film = support::fixed_film();
    const pellicle::Bsdf bsdf = pellicle::BsdfBuilder("film").film(film).create();
    const Vec3 reflected = bsdf.sample(up, Vec3{0.0f, 0.5f, 0.5f}).weight[0] > 0.0f ? bsdf.albedo(up) : Vec3{};
    const pellicle::FilmColors colors = film.eval(1.0f);
    // From outside, what is transmitted counts as radiance: the power over the square of the index.
    for (int channel = 0; channel < 3; ++channel) {
        const float expected = colors.reflectance[channel] + colors.transmittance[channel] / (1.5f * 1.5f);
        CHECK_EQ(reflected[channel], doctest::Approx(expected).epsilon(1e-4));
    }
}
