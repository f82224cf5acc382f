// Data never fails: whatever the floats are, the status is OK, the results are finite and not
// negative, and one bad element of a batch leaves its neighbours alone.
#include "support.hpp"

#include <cmath>
#include <limits>

namespace {

using support::infinity;
using support::quiet_nan;
using support::Vec3;

const std::vector<float> not_finite = {quiet_nan, -quiet_nan, infinity, -infinity};
const std::vector<float> finite_but_odd = {0.0f,
                                           -0.0f,
                                           std::numeric_limits<float>::denorm_min(),
                                           -std::numeric_limits<float>::denorm_min(),
                                           0.5f * std::numeric_limits<float>::min(),
                                           std::numeric_limits<float>::max(),
                                           std::numeric_limits<float>::lowest(),
                                           1.0f,
                                           -1.0f,
                                           2.0f};

// One valid set of inputs of single calls; any float of it may be replaced.
struct Inputs {
    Vec3 wo, wi, u;
    std::vector<float> varying;

    Inputs(const support::Varying &subject, std::mt19937 &random)
        : wo(support::random_direction(random)), wi(support::random_direction(random)),
          u(support::random_uniforms(random)), varying(subject.random_values(random)) {}
};

struct Results {
    pellicle::Evaluation evaluation;
    PellicleSample sample;

    // The wrapper throws if a status is not OK.
    Results(const pellicle::Bsdf &bsdf, const Inputs &inputs)
        : evaluation(bsdf.eval(inputs.wo, inputs.wi, inputs.varying.data())),
          sample(bsdf.sample(inputs.wo, inputs.u, inputs.varying.data())) {}

    bool eval_is_zero() const {
        return evaluation.value == Vec3{0.0f, 0.0f, 0.0f} && evaluation.pdf == 0.0f;
    }

    void check_finite() const {
        CHECK(support::finite_and_non_negative(evaluation.value.data(), 3));
        CAPTURE(evaluation.pdf);
        CHECK(support::finite_and_non_negative(&evaluation.pdf, 1));
        CHECK(support::finite_and_non_negative(sample.weight, 3));
        CHECK(support::finite_and_non_negative(&sample.pdf, 1));
        CHECK(support::finite_and_non_negative(&sample.eta, 1));
        for (const float component : sample.wi) CHECK(std::isfinite(component));
    }
};

// Calls visit(subject, inputs) for every model, a few times.
template <class Visit> void for_each_subject(Visit visit, int times = 8) {
    for (const support::Model &model : support::models_with_and_without_film()) {
        CAPTURE(std::string(model.info.name));
        const support::Varying subject(model);
        std::mt19937 random(1);
        for (int i = 0; i < times; ++i) visit(subject, Inputs(subject, random));
    }
}

} // namespace

TEST_CASE("data: NaN and infinities in a direction give 0") {
    for_each_subject([](const support::Varying &subject, const Inputs &valid) {
        for (const float bad : not_finite)
            for (int component = 0; component < 3; ++component) {
                CAPTURE(bad);
                CAPTURE(component);
                Inputs inputs = valid;
                inputs.wo[component] = bad;
                const Results without_wo(subject.bsdf(), inputs);
                CHECK(without_wo.eval_is_zero());
                CHECK(support::all_zero(without_wo.sample));

                inputs = valid;
                inputs.wi[component] = bad;
                CHECK(Results(subject.bsdf(), inputs).eval_is_zero());
            }
    });
}

TEST_CASE("data: a random number below 0 or not below 1, NaN and infinities give no sample") {
    for_each_subject([](const support::Varying &subject, const Inputs &valid) {
        for (const float bad : {quiet_nan, infinity, -infinity, 1.0f, 2.0f, -0.5f, -1e-30f})
            for (int component = 0; component < 3; ++component) {
                CAPTURE(bad);
                CAPTURE(component);
                Inputs inputs = valid;
                inputs.u[component] = bad;
                CHECK(support::all_zero(Results(subject.bsdf(), inputs).sample));
            }
    });
}

TEST_CASE("data: NaN and infinities in a varying value give 0") {
    for_each_subject([](const support::Varying &subject, const Inputs &valid) {
        for (const float bad : not_finite)
            for (std::size_t component = 0; component < valid.varying.size(); ++component) {
                CAPTURE(bad);
                CAPTURE(component);
                Inputs inputs = valid;
                inputs.varying[component] = bad;
                const Results results(subject.bsdf(), inputs);
                CHECK(results.eval_is_zero());
                CHECK(support::all_zero(results.sample));
            }
    });
}

TEST_CASE("data: zeros, denormals and the largest floats anywhere give finite results") {
    for_each_subject([](const support::Varying &subject, const Inputs &valid) {
        for (const float odd : finite_but_odd) {
            CAPTURE(odd);
            for (int component = 0; component < 3; ++component) {
                CAPTURE(component);
                for (Vec3 Inputs::*field : {&Inputs::wo, &Inputs::wi, &Inputs::u}) {
                    Inputs inputs = valid;
                    (inputs.*field)[component] = odd;
                    Results(subject.bsdf(), inputs).check_finite();
                    inputs.*field = {odd, odd, odd};
                    Results(subject.bsdf(), inputs).check_finite();
                }
            }
            for (std::size_t component = 0; component < valid.varying.size(); ++component) {
                CAPTURE(component);
                Inputs inputs = valid;
                inputs.varying[component] = odd;
                Results(subject.bsdf(), inputs).check_finite();
            }
            Inputs inputs = valid;
            inputs.varying.assign(valid.varying.size(), odd);
            Results(subject.bsdf(), inputs).check_finite();
        }
    });
}

TEST_CASE("data: a direction is normalised up to 1e-3 from unit length, and gives 0 beyond") {
    for_each_subject([](const support::Varying &subject, const Inputs &valid) {
        const auto scaled = [](Vec3 v, float length) {
            for (float &component : v) component *= length;
            return v;
        };
        for (const float length : {0.0f, 0.5f, 0.99f, 1.01f, 2.0f}) {
            CAPTURE(length);
            Inputs inputs = valid;
            inputs.wo = scaled(valid.wo, length);
            const Results results(subject.bsdf(), inputs);
            CHECK(results.eval_is_zero());
            CHECK(support::all_zero(results.sample));
            inputs = valid;
            inputs.wi = scaled(valid.wi, length);
            CHECK(Results(subject.bsdf(), inputs).eval_is_zero());
        }
        for (const float length : {0.9995f, 1.0005f}) {
            CAPTURE(length);
            Inputs inputs = valid;
            inputs.wo = scaled(valid.wo, length);
            inputs.wi = scaled(valid.wi, length);
            const Results results(subject.bsdf(), inputs);
            CHECK_FALSE((results.eval_is_zero() && support::all_zero(results.sample)));
            const float *wi = results.sample.wi;
            const double square = double{wi[0]} * wi[0] + double{wi[1]} * wi[1] + double{wi[2]} * wi[2];
            if (!support::all_zero(results.sample)) CHECK_LE(std::fabs(std::sqrt(square) - 1.0), 1e-6);
        }
    });
}

TEST_CASE("data: the albedo of whatever is not finite is 0, of anything odd it is finite") {
    // Once: it is a quadrature.
    const auto visit = [](const support::Varying &subject, const Inputs &valid) {
        const auto albedo = [&](const Inputs &inputs) {
            return subject.bsdf().albedo(inputs.wo, inputs.varying.data());
        };
        const auto check_each_float = [&](float value, auto check) {
            CAPTURE(value);
            for (int component = 0; component < 3; ++component) {
                Inputs inputs = valid;
                inputs.wo[component] = value;
                check(albedo(inputs));
            }
            for (std::size_t component = 0; component < valid.varying.size(); ++component) {
                CAPTURE(component);
                Inputs inputs = valid;
                inputs.varying[component] = value;
                check(albedo(inputs));
            }
        };
        for (const float bad : not_finite)
            check_each_float(bad, [](const Vec3 &result) { CHECK(result == Vec3{0.0f, 0.0f, 0.0f}); });
        for (const float odd : finite_but_odd)
            check_each_float(odd, [](const Vec3 &result) {
                CHECK(support::finite_and_non_negative(result.data(), 3));
            });
    };
    for_each_subject(visit, 1);
}

TEST_CASE("data: directions at the horizon, along the axes and equal to one another give finite results") {
    const std::vector<Vec3> edges = {{0.0f, 0.0f, 1.0f}, {1.0f, 0.0f, 0.0f},        {0.0f, -1.0f, 0.0f},
                                     {0.0f, 0.0f, -1.0f}, {1.0f, 0.0f, 1e-20f},     {0.0f, 1.0f, 1e-6f},
                                     {0.6f, 0.0f, -0.8f}, {0.99999994f, 0.0f, 3e-4f}};
    for_each_subject([&](const support::Varying &subject, const Inputs &valid) {
        for (const Vec3 &wo : edges)
            for (const Vec3 &wi : edges) {
                Inputs inputs = valid;
                inputs.wo = wo;
                inputs.wi = wi;
                const Results results(subject.bsdf(), inputs);
                results.check_finite();
                const bool one_sided = !(subject.bsdf().info().flags & PELLICLE_TRANSMISSION);
                if (one_sided && (wo[2] <= 0.0f || wi[2] <= 0.0f)) CHECK(results.eval_is_zero());
            }
    });
}

TEST_CASE("data: a bad element of a batch does not disturb its neighbours") {
    // More than one tile of any vector width, and an odd rest.
    constexpr std::size_t count = 67;
    struct Output {
        float value[3], pdf;
        PellicleSample sample;
    };
    for (const support::Model &model : support::models_with_and_without_film()) {
        CAPTURE(std::string(model.info.name));
        const support::Varying subject(model);
        std::mt19937 random(2);
        std::vector<Vec3> wo, wi, u;
        std::vector<float> varying;
        for (std::size_t i = 0; i < count; ++i) {
            const Inputs inputs(subject, random);
            wo.push_back(inputs.wo);
            wi.push_back(inputs.wi);
            u.push_back(inputs.u);
            varying.insert(varying.end(), inputs.varying.begin(), inputs.varying.end());
        }

        const auto run = [&] {
            std::vector<Output> outputs(count);
            std::vector<PellicleConstView> views;
            const auto element = static_cast<std::ptrdiff_t>(subject.floats() * sizeof(float));
            std::size_t offset = 0;
            for (const std::size_t components : subject.components()) {
                views.push_back({varying.data() + offset, element, 4});
                offset += components;
            }
            PellicleEvalBatchArgs eval{};
            eval.count = count;
            eval.wo = {wo[0].data(), 12, 4};
            eval.wi = {wi[0].data(), 12, 4};
            eval.varying = views.data();
            eval.varying_count = views.size();
            eval.value = {outputs[0].value, sizeof(Output), 4};
            eval.pdf = {&outputs[0].pdf, sizeof(Output), 4};
            subject.bsdf().eval_batch(eval);
            PellicleSampleBatchArgs sample{};
            sample.count = count;
            sample.wo = eval.wo;
            sample.u = {u[0].data(), 12, 4};
            sample.varying = eval.varying;
            sample.varying_count = eval.varying_count;
            sample.wi = {outputs[0].sample.wi, sizeof(Output), 4};
            sample.pdf = {&outputs[0].sample.pdf, sizeof(Output), 4};
            sample.weight = {outputs[0].sample.weight, sizeof(Output), 4};
            sample.eta = {&outputs[0].sample.eta, sizeof(Output), 4};
            sample.flags = {&outputs[0].sample.flags, sizeof(Output)};
            sample.lobe = {&outputs[0].sample.lobe, sizeof(Output)};
            subject.bsdf().sample_batch(sample);
            return outputs;
        };

        const std::vector<Output> clean = run();
        const auto only_changed = [&](const std::vector<Output> &outputs, std::size_t changed) {
            for (std::size_t i = 0; i < count; ++i)
                if (i != changed && (!support::same_bits(outputs[i].value, clean[i].value, 3) ||
                                     !support::same_bits(&outputs[i].pdf, &clean[i].pdf, 1) ||
                                     !support::same_bits(outputs[i].sample, clean[i].sample)))
                    return false;
            return true;
        };
        for (const std::size_t bad : {std::size_t{0}, std::size_t{5}, std::size_t{63}, count - 1})
            for (const float value : {quiet_nan, infinity, -infinity, 0.0f}) {
                CAPTURE(bad);
                CAPTURE(value);
                std::vector<float *> places = {&wo[bad][2], &wi[bad][0], &u[bad][1]};
                if (!varying.empty()) places.push_back(&varying[bad * subject.floats()]);
                for (float *place : places) {
                    const float kept = *place;
                    *place = value;
                    const std::vector<Output> outputs = run();
                    CHECK(only_changed(outputs, bad));
                    CHECK(support::finite_and_non_negative(outputs[bad].value, 3));
                    CHECK(support::finite_and_non_negative(outputs[bad].sample.weight, 3));
                    *place = kept;
                }
            }
    }
}
