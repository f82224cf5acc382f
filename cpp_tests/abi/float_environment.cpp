// Hosts set flush-to-zero and denormals-are-zero (Embree asks for both), some set other rounding
// modes. The library is right under the former and leaves every control bit as it was.
#include "support.hpp"

#include <cfloat>
#include <cmath>

#include <pmmintrin.h>
#include <xmmintrin.h>

namespace {

using support::Vec3;

// The six lowest bits are exception flags, which calls may raise.
constexpr unsigned control_bits = ~0x3Fu;

// Sets control bits of MXCSR for as long as it lives.
class FloatControl {
public:
    explicit FloatControl(unsigned bits) : saved_(_mm_getcsr()) { _mm_setcsr(saved_ | bits); }
    ~FloatControl() { _mm_setcsr(saved_); }
    FloatControl(const FloatControl &) = delete;
    FloatControl &operator=(const FloatControl &) = delete;

private:
    unsigned saved_;
};

struct Inputs {
    Vec3 wo, wi, u;
    std::vector<float> varying;
};

std::vector<Inputs> random_inputs(const support::Varying &subject, int count) {
    std::mt19937 random(5);
    std::vector<Inputs> inputs;
    for (int i = 0; i < count; ++i)
        inputs.push_back({support::random_direction(random), support::random_direction(random),
                          support::random_uniforms(random), subject.random_values(random)});
    // Denormal components (but for z, where denormals-are-zero makes a horizon of it), and an angle
    // between directions so wide that powers underflow.
    inputs.push_back({{1e-40f, 0.0f, 1.0f}, {0.0f, -1e-41f, 1.0f}, {1e-42f, 1e-42f, 0.5f}, inputs[0].varying});
    inputs.push_back({{1.0f, 0.0f, 1e-37f}, {-1.0f, 1e-39f, 1e-37f}, {0.5f, 0.5f, 1e-44f}, inputs[0].varying});
    inputs.push_back({{0.8f, 0.0f, 0.6f}, {0.8f, 0.0f, 0.6f}, {0.5f, 1e-40f, 0.5f}, inputs[0].varying});
    return inputs;
}

std::vector<float> results(const pellicle::Bsdf &bsdf, const Inputs &inputs) {
    const auto evaluation = bsdf.eval(inputs.wo, inputs.wi, inputs.varying.data());
    const auto sample = bsdf.sample(inputs.wo, inputs.u, inputs.varying.data());
    std::vector<float> all(evaluation.value.begin(), evaluation.value.end());
    all.insert(all.end(), {evaluation.pdf, sample.pdf, sample.eta});
    all.insert(all.end(), sample.weight, sample.weight + 3);
    return all;
}

} // namespace

TEST_CASE("float environment: flush-to-zero and denormals-are-zero change nothing that matters") {
    for (const support::Model &model : support::models()) {
        CAPTURE(std::string(model.info.name));
        const support::Varying subject(model);
        for (const Inputs &inputs : random_inputs(subject, 5000)) {
            const std::vector<float> expected = results(subject.bsdf(), inputs);
            std::vector<float> flushed;
            {
                const FloatControl control(_MM_FLUSH_ZERO_ON | _MM_DENORMALS_ZERO_ON);
                flushed = results(subject.bsdf(), inputs);
            }
            bool equal = true;
            for (std::size_t i = 0; i < expected.size(); ++i) {
                // What is denormal without the modes is 0 with them: hence the absolute part.
                const float tolerance = 1e-6f * std::fabs(expected[i]) + FLT_MIN;
                equal = equal && std::isfinite(flushed[i]) && std::fabs(flushed[i] - expected[i]) <= tolerance;
            }
            CHECK(equal);
        }
    }
}

TEST_CASE("float environment: flush-to-zero and denormals-are-zero do not change the albedo") {
    for (const support::Model &model : support::models()) {
        CAPTURE(std::string(model.info.name));
        const support::Varying subject(model);
        for (const Inputs &inputs : random_inputs(subject, 8)) {
            const Vec3 expected = subject.bsdf().albedo(inputs.wo, inputs.varying.data());
            const FloatControl control(_MM_FLUSH_ZERO_ON | _MM_DENORMALS_ZERO_ON);
            const Vec3 flushed = subject.bsdf().albedo(inputs.wo, inputs.varying.data());
            for (int channel = 0; channel < 3; ++channel)
                CHECK_LE(std::fabs(flushed[channel] - expected[channel]), 1e-6f * expected[channel] + FLT_MIN);
        }
    }
}

TEST_CASE("float environment: a BSDF created under flush-to-zero is the same") {
    for (const support::Model &model : support::models()) {
        CAPTURE(std::string(model.info.name));
        const support::Varying plain(model);
        const FloatControl control(_MM_FLUSH_ZERO_ON | _MM_DENORMALS_ZERO_ON);
        const support::Varying flushed(model);
        for (const Inputs &inputs : random_inputs(plain, 200))
            CHECK(results(plain.bsdf(), inputs) == results(flushed.bsdf(), inputs));
    }
}

TEST_CASE("float environment: no call changes a control bit of MXCSR") {
    const unsigned rounding_modes[] = {_MM_ROUND_NEAREST, _MM_ROUND_DOWN, _MM_ROUND_UP, _MM_ROUND_TOWARD_ZERO};
    for (const unsigned rounding : rounding_modes)
        for (const unsigned flush : {0u, unsigned{_MM_FLUSH_ZERO_ON} | unsigned{_MM_DENORMALS_ZERO_ON}})
            for (const support::Model &model : support::models()) {
                CAPTURE(std::string(model.info.name));
                const FloatControl control(rounding | flush);
                const unsigned before = _mm_getcsr() & control_bits;
                const auto unchanged = [&] { return (_mm_getcsr() & control_bits) == before; };

                const auto bsdf = pellicle::BsdfBuilder(model.info.name).create();
                CHECK(unchanged());
                const Vec3 wo = {0.6f, 0.0f, 0.8f}, wi = {0.0f, 0.6f, 0.8f}, u = {0.3f, 0.6f, 0.9f};
                bsdf.eval(wo, wi);
                CHECK(unchanged());
                bsdf.sample(wo, u);
                CHECK(unchanged());
                bsdf.albedo(wo);
                CHECK(unchanged());
                std::vector<Vec3> outputs(65);
                PellicleEvalBatchArgs eval{};
                eval.count = outputs.size();
                eval.wo = {wo.data(), 0, 4};
                eval.wi = {wi.data(), 0, 4};
                eval.value = {outputs[0].data(), 12, 4};
                bsdf.eval_batch(eval);
                CHECK(unchanged());
                PellicleSampleBatchArgs sample{};
                sample.count = outputs.size();
                sample.wo = eval.wo;
                sample.u = {u.data(), 0, 4};
                sample.wi = eval.value;
                bsdf.sample_batch(sample);
                CHECK(unchanged());
                CHECK_THROWS_AS(pellicle::BsdfBuilder("no such model").create(), pellicle::Error);
                CHECK(unchanged());
            }
}
