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
        CHECK_EQ(pellicle_bsdf_retain(nullptr), PELLICLE_INVALID_ARGUMENT);
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
    float value[3], pdf, albedo[3];
    PellicleSample sample;
    REQUIRE_EQ(pellicle_bsdf_eval(bsdf.raw(), up.data(), slanted.data(), nullptr, value, &pdf), PELLICLE_OK);
    REQUIRE_EQ(pellicle_bsdf_sample(bsdf.raw(), up.data(), u.data(), nullptr, &sample, sizeof sample), PELLICLE_OK);
    REQUIRE_EQ(pellicle_bsdf_albedo(bsdf.raw(), up.data(), nullptr, albedo), PELLICLE_OK);
    CHECK(support::same_bits(bsdf.eval(up, slanted).value.data(), value, 3));
    CHECK_EQ(bsdf.eval(up, slanted).pdf, pdf);
    CHECK(support::same_bits(bsdf.value(up, slanted).data(), value, 3));
    CHECK_EQ(bsdf.pdf(up, slanted), pdf);
    CHECK(support::same_bits(bsdf.sample(up, u), sample));
    CHECK(support::same_bits(bsdf.albedo(up).data(), albedo, 3));
}
