// Directions that are none, or that a surface does not have, in every model.
#include "support.hpp"

#include <cmath>

namespace {

using support::infinity;
using support::quiet_nan;
using support::Vec3;

constexpr float denormal = 1e-40f;

struct Named {
    const char *name;
    Vec3 w;
};

// No results: not unit to 1e-3, or no numbers.
const std::vector<Named> invalid = {
    {"zero", {0, 0, 0}},
    {"denormal", {denormal, 0, denormal}},
    {"short", {0, 0, 0.99f}},
    {"long", {0, 0.6f, 0.82f}},
    {"twice", {0, 1.2f, 1.6f}},
    {"so long that its square is infinite", {1e30f, 0, 1e30f}},
    {"so short that its square is 0", {1e-30f, 0, 1e-30f}},
    {"NaN in x", {quiet_nan, 0, 1}},
    {"NaN in z", {0.6f, 0.8f, quiet_nan}},
    {"infinite", {0, 0, infinity}},
    {"infinite both ways", {-infinity, 0, infinity}},
};

// On and below the horizon: no results of models that do not transmit.
const std::vector<Named> low = {
    {"on the horizon", {1, 0, 0}},
    {"on the horizon, with a negative zero", {0, 1, -0.0f}},
    {"below by a denormal", {1, 0, -denormal}},
    {"below", {0.6f, 0, -0.8f}},
    {"straight down", {0, 0, -1}},
};

// Valid, and hard on who divides by a cosine or normalises h.
const std::vector<Named> high = {
    {"straight up", {0, 0, 1}},
    {"above by a denormal", {1, 0, denormal}},
    {"above by 1e-20", {-1, 0, 1e-20f}},
    {"above by 1e-6", {0, 1, 1e-6f}},
    {"a little too long", {0.6003f, 0, 0.8003f}},
};

void check_nothing(const pellicle::Bsdf &bsdf, const Vec3 &wo, const Vec3 &wi, const float *varying) {
    const pellicle::Evaluation found = bsdf.eval(wo, wi, varying);
    CHECK_EQ(found.value, Vec3{});
    CHECK_EQ(found.pdf, 0.0f);
}

void check_finite(const pellicle::Bsdf &bsdf, const Vec3 &wo, const Vec3 &wi, const float *varying) {
    const pellicle::Evaluation found = bsdf.eval(wo, wi, varying);
    CHECK(support::finite_and_non_negative(found.value.data(), 3));
    CHECK(support::finite_and_non_negative(&found.pdf, 1));
    const PellicleSample sample = bsdf.sample(wo, Vec3{0.3f, 0.999f, 0.7f}, varying);
    CHECK(support::finite_and_non_negative(sample.weight, 3));
    CHECK(support::finite_and_non_negative(&sample.pdf, 1));
    for (const float component : sample.wi) CHECK(std::isfinite(component));
}

} // namespace

// 1 / 0 at the horizon and 0 / 0 where h is no direction, as wo = -wi, gave NaN pixels that a filter spreads; a
// direction of length 2 is 4 to 16 times too bright where nobody looks.
TEST_CASE("failures: directions that are not unit, below or on the horizon, opposite, denormal, NaN or infinite") {
    std::mt19937 random(7);
    for (const support::Model &model : support::models_with_and_without_film()) {
        CAPTURE(std::string(model.info.name));
        const support::Varying varied(model);
        const pellicle::Bsdf plain = support::builder(model).create();
        const std::vector<float> values = varied.random_values(random);
        const bool is_one_sided = !(plain.info().flags & PELLICLE_TRANSMISSION);
        for (int i = 0; i < 5; ++i) {
            const Vec3 good = support::random_direction(random), u = support::random_uniforms(random);
            for (const auto &[bsdf, varying] : {std::pair(plain, static_cast<const float *>(nullptr)),
                                                std::pair(varied.bsdf(), values.data())}) {
                for (const Named &bad : invalid) {
                    CAPTURE(std::string(bad.name));
                    check_nothing(bsdf, good, bad.w, varying);
                    check_nothing(bsdf, bad.w, good, varying);
                    CHECK(support::all_zero(bsdf.sample(bad.w, u, varying)));
                    CHECK_EQ(bsdf.albedo(bad.w, varying), Vec3{});
                }
                for (const Named &below : low) {
                    CAPTURE(std::string(below.name));
                    check_finite(bsdf, good, below.w, varying);
                    check_finite(bsdf, below.w, good, varying);
                    if (!is_one_sided && below.w[2] != 0) continue;
                    check_nothing(bsdf, good, below.w, varying);
                    check_nothing(bsdf, below.w, good, varying);
                    CHECK(support::all_zero(bsdf.sample(below.w, u, varying)));
                }
                for (const Named &above : high) {
                    CAPTURE(std::string(above.name));
                    check_finite(bsdf, good, above.w, varying);
                    check_finite(bsdf, above.w, good, varying);
                    check_finite(bsdf, above.w, above.w, varying);
                    // Opposite: h is the null vector.
                    const Vec3 opposite = {-above.w[0], -above.w[1], -above.w[2]};
                    check_finite(bsdf, above.w, opposite, varying);
                    if (is_one_sided) check_nothing(bsdf, above.w, opposite, varying);
                    // Opposite but for the side.
                    check_finite(bsdf, above.w, {-above.w[0], -above.w[1], above.w[2]}, varying);
                }
            }
        }
    }
}

// A normal n1 that points sideways or down mirrors the refracted lobe below the surface: black, or bright from below.
TEST_CASE("failures: a lower boundary's normal that points sideways or down, or nowhere") {
    for (const Vec3 &normal : {Vec3{1, 0, 0}, Vec3{0, 0, -1}, Vec3{0.6f, 0, -0.8f}, Vec3{1, 0, 0.01f}, Vec3{0, 0, 0},
                               Vec3{denormal, 0, 0}, Vec3{quiet_nan, 0, 1}, Vec3{0, 0, infinity}}) {
        CAPTURE(normal[0]);
        CAPTURE(normal[2]);
        PellicleParam param{};
        param.name = "base_normal";
        param.values = normal.data();
        param.count = 3;
        PellicleBsdfDesc desc{};
        desc.model = "layered";
        desc.params = &param;
        desc.param_count = 1;
        support::Untouched<PellicleBsdf *> bsdf;
        CHECK_REFUSED(pellicle_bsdf_create(&desc, sizeof desc, &bsdf.output), PELLICLE_OUT_OF_RANGE, "base_normal");
    }
    // From a texture such normals come without warning, and give 0.
    const auto bsdf = pellicle::BsdfBuilder("layered").vary("base_normal", 0.0f, 0.0f).create();
    const Vec3 wo = {0.6f, 0, 0.8f}, wi = {-0.6f, 0, 0.8f};
    for (const Vec3 &normal : {Vec3{1, 0, 0}, Vec3{0, 0, -1}, Vec3{0.6f, 0, -0.8f}, Vec3{0, 0, 0}, Vec3{quiet_nan, 0, 1},
                               Vec3{0, 0, infinity}, Vec3{0, -infinity, 1}}) {
        check_nothing(bsdf, wo, wi, normal.data());
        CHECK(support::all_zero(bsdf.sample(wo, Vec3{0.5f, 0.5f, 0.5f}, normal.data())));
    }
    // Any length will do, and a normal that leans far gives numbers.
    const Vec3 expected = bsdf.value(wo, wi, Vec3{0.3f, 0, 0.9f}.data());
    for (const float length : {1e-30f, 1e-3f, 7.0f, 1e30f}) {
        const Vec3 found = bsdf.value(wo, wi, Vec3{0.3f * length, 0, 0.9f * length}.data());
        for (int c = 0; c < 3; ++c) CHECK(found[c] == doctest::Approx(expected[c]).epsilon(1e-4));
    }
    for (const Vec3 &normal : {Vec3{1, 0, 1e-6f}, Vec3{0, -1, 0.05f}, Vec3{1, 0, denormal}})
        check_finite(bsdf, wo, wi, normal.data());
}
