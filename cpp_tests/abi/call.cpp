// The options of a call: what is refused, and what they change.
#include "support.hpp"

#include <cmath>
#include <functional>

namespace {

using support::Untouched;
using support::Vec3;

const Vec3 wo = {0.0f, 0.6f, 0.8f}, wi = {0.48f, -0.6f, 0.64f}, u = {0.3f, 0.6f, 0.9f};

constexpr std::uint32_t all_flags = PELLICLE_REFLECTION | PELLICLE_TRANSMISSION | PELLICLE_DIFFUSE |
                                    PELLICLE_GLOSSY | PELLICLE_DELTA;

// Every function that takes options, with an output that a refusal must leave.
const std::vector<std::pair<const char *, std::function<PellicleStatus(const PellicleBsdf *, const PellicleCall *)>>>
    functions = {
        {"eval",
         [](const PellicleBsdf *bsdf, const PellicleCall *call) {
             float value[3];
             return pellicle_bsdf_eval(bsdf, wo.data(), wi.data(), nullptr, call, value, nullptr, nullptr);
         }},
        {"sample",
         [](const PellicleBsdf *bsdf, const PellicleCall *call) {
             PellicleSample sample;
             return pellicle_bsdf_sample(bsdf, wo.data(), u.data(), nullptr, call, &sample, sizeof sample);
         }},
        {"albedo",
         [](const PellicleBsdf *bsdf, const PellicleCall *call) {
             float albedo[3];
             return pellicle_bsdf_albedo(bsdf, wo.data(), nullptr, call, albedo);
         }},
        {"eval_batch",
         [](const PellicleBsdf *bsdf, const PellicleCall *call) {
             float value[3];
             PellicleEvalBatchArgs args{};
             args.count = 1;
             args.wo = {wo.data(), 12, 4};
             args.wi = {wi.data(), 12, 4};
             args.call = call;
             args.value = {value, 12, 4};
             return pellicle_bsdf_eval_batch(bsdf, &args, sizeof args);
         }},
        {"sample_batch",
         [](const PellicleBsdf *bsdf, const PellicleCall *call) {
             float weight[3];
             PellicleSampleBatchArgs args{};
             args.count = 1;
             args.wo = {wo.data(), 12, 4};
             args.u = {u.data(), 12, 4};
             args.call = call;
             args.weight = {weight, 12, 4};
             return pellicle_bsdf_sample_batch(bsdf, &args, sizeof args);
         }},
};

// Calls visit(status of a call with these options) for every function.
void for_each_function(const PellicleCall *call, const std::function<void(PellicleStatus)> &visit) {
    const auto bsdf = pellicle::BsdfBuilder("phong").create();
    for (const auto &[name, function] : functions) {
        CAPTURE(std::string(name));
        visit(function(bsdf.raw(), call));
    }
}

void check_refused(const PellicleCall *call, PellicleStatus status, const std::string &words) {
    for_each_function(call, [&](PellicleStatus found) { CHECK_REFUSED(found, status, words); });
}

Vec3 sum(const Vec3 &a, const Vec3 &b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

void check_close(const Vec3 &found, const Vec3 &expected) {
    for (int c = 0; c < 3; ++c) CHECK(found[c] == doctest::Approx(expected[c]).epsilon(1e-5));
}

} // namespace

TEST_CASE("call: an unknown transport is refused with its value and what is allowed") {
    for (const std::uint32_t transport : {2u, 77u, UINT32_MAX}) {
        const PellicleCall call = pellicle::call_options(transport);
        check_refused(&call, PELLICLE_OUT_OF_RANGE, "transport = " + std::to_string(transport));
        CHECK(support::message_has("radiance"));
        CHECK(support::message_has("importance"));
    }
}

TEST_CASE("call: a mask with unknown flags is refused with its value and what is allowed") {
    for (const std::uint32_t lobes : {all_flags + 1, all_flags | 0x40u, UINT32_MAX}) {
        const PellicleCall call = pellicle::call_options(PELLICLE_TRANSPORT_RADIANCE, lobes);
        check_refused(&call, PELLICLE_OUT_OF_RANGE, "lobes");
        CHECK(support::message_has("0x1f"));
    }
}

TEST_CASE("call: a size that no version has is refused") {
    PellicleCall call = pellicle::call_options(PELLICLE_TRANSPORT_RADIANCE);
    for (const std::size_t size : {std::size_t{0}, sizeof call - 1, SIZE_MAX, std::size_t{1} << 20}) {
        CAPTURE(size);
        call.size = size;
        check_refused(&call, PELLICLE_INVALID_ARGUMENT, "call");
        CHECK(support::message_has("size"));
    }
}

TEST_CASE("call: an older one is its size alone, a newer one may have zeros that this build does not know") {
    struct Longer {
        PellicleCall call;
        std::uint64_t tail;
    } longer = {pellicle::call_options(PELLICLE_TRANSPORT_RADIANCE), 0};
    longer.call.size = sizeof longer;
    for_each_function(&longer.call, [](PellicleStatus status) { CHECK_EQ(status, PELLICLE_OK); });
    longer.tail = 1;
    check_refused(&longer.call, PELLICLE_UNSUPPORTED, "call");

    support::GuardedBytes bytes(sizeof(std::size_t));
    *bytes.as<std::size_t>() = sizeof(std::size_t);
    for_each_function(bytes.as<const PellicleCall>(), [](PellicleStatus status) { CHECK_EQ(status, PELLICLE_OK); });
}

TEST_CASE("call: NULL, zeros and every flag are the same") {
    PellicleCall zeros{};
    zeros.size = sizeof zeros;
    const PellicleCall every = pellicle::call_options(PELLICLE_TRANSPORT_RADIANCE, all_flags);
    for (const support::Model &model : support::models_with_and_without_film()) {
        CAPTURE(std::string(model.info.name));
        const pellicle::Bsdf bsdf = support::builder(model).create();
        const Vec3 value = bsdf.value(wo, wi);
        const PellicleSample sample = bsdf.sample(wo, u);
        for (const PellicleCall *call : {static_cast<const PellicleCall *>(&zeros), &every}) {
            CHECK(support::same_bits(bsdf.value(wo, wi, nullptr, call).data(), value.data(), 3));
            CHECK(support::same_bits(bsdf.sample(wo, u, nullptr, call), sample));
        }
    }
}

TEST_CASE("call: the reverse density is the density of the reverse call") {
    for (const support::Model &model : support::models_with_and_without_film()) {
        CAPTURE(std::string(model.info.name));
        const pellicle::Bsdf bsdf = support::builder(model).create();
        std::mt19937 random(9);
        for (int i = 0; i < 100; ++i) {
            const Vec3 a = support::random_direction(random), b = support::random_direction(random);
            const pellicle::TwoWayEvaluation both = bsdf.eval_both_ways(a, b);
            CHECK_EQ(both.pdf, bsdf.pdf(a, b));
            CHECK(both.pdf_reverse == doctest::Approx(bsdf.pdf(b, a)).epsilon(1e-5));
            CHECK(support::same_bits(both.value.data(), bsdf.value(a, b).data(), 3));
        }
    }
}

// Frequencies against the probability that samples state: 4 standard deviations of the count.
TEST_CASE("call: a lobe is chosen as often as its samples say") {
    constexpr int draws = 20000;
    for (const support::Model &model : support::models_with_and_without_film()) {
        CAPTURE(std::string(model.info.name));
        const pellicle::Bsdf bsdf = support::builder(model).create();
        std::vector<int> count(bsdf.info().lobe_count);
        std::vector<float> probability(bsdf.info().lobe_count);
        std::mt19937 random(10);
        int valid = 0;
        for (int i = 0; i < draws; ++i) {
            const PellicleSample sample = bsdf.sample(wo, support::random_uniforms(random));
            if (sample.flags == 0) continue;
            ++valid;
            ++count[sample.lobe];
            probability[sample.lobe] = sample.lobe_probability;
            CHECK_GT(sample.lobe_probability, 0.0f);
            CHECK_LE(sample.lobe_probability, 1.0f);
        }
        CHECK_GT(valid, draws / 2);
        // A direction that falls below the horizon is no valid sample: a count may be short of it, never above.
        const double lost = double(draws - valid) / draws;
        for (std::size_t lobe = 0; lobe < count.size(); ++lobe) {
            const double p = probability[lobe], spread = 4 * std::sqrt(p * (1 - p) / draws) + 1e-3;
            CHECK_LE(count[lobe] / double(draws), p + spread);
            CHECK_GE(count[lobe] / double(draws), p - spread - lost);
        }
    }
}

TEST_CASE("call: the lobes of two masks add up to all of them") {
    const auto bsdf = pellicle::BsdfBuilder("phong").create();
    const PellicleCall diffuse = pellicle::call_options(0, PELLICLE_REFLECTION | PELLICLE_DIFFUSE),
                       glossy = pellicle::call_options(0, PELLICLE_REFLECTION | PELLICLE_GLOSSY);
    check_close(sum(bsdf.value(wo, wi, nullptr, &diffuse), bsdf.value(wo, wi, nullptr, &glossy)), bsdf.value(wo, wi));
    check_close(sum(bsdf.albedo(wo, nullptr, &diffuse), bsdf.albedo(wo, nullptr, &glossy)), bsdf.albedo(wo));
    // A lobe whose flags are not all in the mask is not of the call.
    const PellicleCall none = pellicle::call_options(0, PELLICLE_DIFFUSE);
    CHECK_EQ(bsdf.value(wo, wi, nullptr, &none), Vec3{});
    CHECK(support::all_zero(bsdf.sample(wo, u, nullptr, &none)));
}

TEST_CASE("call: samples are of the mask's lobes alone, with their density") {
    const auto bsdf = pellicle::BsdfBuilder("phong").create();
    std::mt19937 random(12);
    for (const std::uint32_t kind : {PELLICLE_DIFFUSE, PELLICLE_GLOSSY}) {
        const PellicleCall call = pellicle::call_options(0, PELLICLE_REFLECTION | kind);
        for (int i = 0; i < 100; ++i) {
            const PellicleSample sample = bsdf.sample(wo, support::random_uniforms(random), nullptr, &call);
            if (sample.flags == 0) continue;
            CHECK_EQ(sample.flags, PELLICLE_REFLECTION | kind);
            CHECK_EQ(sample.lobe_probability, 1.0f);
            CHECK(sample.pdf == doctest::Approx(bsdf.pdf(wo, sample.wi, nullptr, &call)).epsilon(1e-4));
        }
    }
}

// A smooth transparent base of index 1.5 under vacuum: refraction carries 1 / 1.5^2 as radiance, 1 as importance.
TEST_CASE("call: importance leaves out the square of the indices' ratio") {
    const auto bsdf = pellicle::BsdfBuilder("film").film(support::fixed_film()).create();
    const PellicleCall importance = pellicle::call_options(PELLICLE_TRANSPORT_IMPORTANCE);
    int transmitted = 0;
    std::mt19937 random(13);
    for (int i = 0; i < 100; ++i) {
        const Vec3 numbers = support::random_uniforms(random);
        const PellicleSample radiance = bsdf.sample(wo, numbers), as_importance = bsdf.sample(wo, numbers, nullptr, &importance);
        REQUIRE_EQ(radiance.flags, as_importance.flags);
        const bool is_refraction = radiance.flags & PELLICLE_TRANSMISSION;
        transmitted += is_refraction;
        const float factor = is_refraction ? radiance.eta * radiance.eta : 1.0f;
        for (int c = 0; c < 3; ++c)
            CHECK(as_importance.weight[c] == doctest::Approx(radiance.weight[c] * factor).epsilon(1e-5));
    }
    CHECK_GT(transmitted, 0);
}
