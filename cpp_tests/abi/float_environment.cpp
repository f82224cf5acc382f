// Hosts set flush-to-zero and denormals-are-zero (Embree asks for both), some set other rounding
// modes. The library is right under the former and leaves every control bit as it was.
#include "support.hpp"

#include <cfloat>
#include <cmath>
#include <optional>

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
    // between directions so wide that powers underflow; there z is far above the denormals, which would
    // otherwise be a part of the half vector.
    inputs.push_back({{1e-40f, 0.0f, 1.0f}, {0.0f, -1e-41f, 1.0f}, {1e-42f, 1e-42f, 0.5f}, inputs[0].varying});
    inputs.push_back({{1.0f, 0.0f, 1e-30f}, {-1.0f, 1e-39f, 1e-30f}, {0.5f, 0.5f, 1e-44f}, inputs[0].varying});
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
    for (const support::Model &model : support::models_with_and_without_film()) {
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
    for (const support::Model &model : support::models_with_and_without_film()) {
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
    for (const support::Model &model : support::models_with_and_without_film()) {
        CAPTURE(std::string(model.info.name));
        const support::Varying plain(model);
        const FloatControl control(_MM_FLUSH_ZERO_ON | _MM_DENORMALS_ZERO_ON);
        const support::Varying flushed(model);
        for (const Inputs &inputs : random_inputs(plain, 200))
            CHECK(results(plain.bsdf(), inputs) == results(flushed.bsdf(), inputs));
    }
}

TEST_CASE("float environment: flush-to-zero and denormals-are-zero do not change a film, made or called under them") {
    const auto all = [](const pellicle::Film &film, float cos_theta, float thickness_nm) {
        std::vector<float> numbers;
        const auto append = [&](const Vec3 &rgb) { numbers.insert(numbers.end(), rgb.begin(), rgb.end()); };
        append(film.reflectance(cos_theta, thickness_nm));
        append(film.reference(cos_theta, thickness_nm));
        const pellicle::FilmColors colors = film.eval(cos_theta, thickness_nm, PELLICLE_SIDE_BASE);
        append(colors.reflectance);
        append(colors.transmittance);
        const float lambda_nm = 550.0f;
        float reflectance;
        film.spectrum(cos_theta, thickness_nm, &lambda_nm, 1, &reflectance);
        numbers.push_back(reflectance);
        return numbers;
    };
    const auto builder = pellicle::FilmBuilder(pellicle::Medium::constant(1.5f))
                             .layer(pellicle::Medium::constant(1.9f, 0.01f), 0, 400)
                             .transmittance();
    const pellicle::Film plain = builder.create();
    std::optional<pellicle::Film> flushed;
    {
        const FloatControl control(_MM_FLUSH_ZERO_ON | _MM_DENORMALS_ZERO_ON);
        flushed = builder.create();
    }
    for (const float cos_theta : {0.0f, 1e-40f, 1e-20f, 0.1f, 0.7f, 1.0f})
        for (const float thickness_nm : {0.0f, 1e-40f, 1e-3f, 250.0f, 400.0f}) {
            CAPTURE(cos_theta);
            CAPTURE(thickness_nm);
            const std::vector<float> expected = all(plain, cos_theta, thickness_nm);
            CHECK(all(*flushed, cos_theta, thickness_nm) == expected);
            std::vector<float> called;
            {
                const FloatControl control(_MM_FLUSH_ZERO_ON | _MM_DENORMALS_ZERO_ON);
                called = all(plain, cos_theta, thickness_nm);
            }
            for (std::size_t i = 0; i < expected.size(); ++i)
                CHECK_LE(std::fabs(called[i] - expected[i]), 1e-6f);
        }
}

TEST_CASE("float environment: no call changes a control bit of MXCSR") {
    const unsigned rounding_modes[] = {_MM_ROUND_NEAREST, _MM_ROUND_DOWN, _MM_ROUND_UP, _MM_ROUND_TOWARD_ZERO};
    for (const unsigned rounding : rounding_modes)
        for (const unsigned flush : {0u, unsigned{_MM_FLUSH_ZERO_ON} | unsigned{_MM_DENORMALS_ZERO_ON}})
            for (const support::Model &model : support::models_with_and_without_film()) {
                CAPTURE(std::string(model.info.name));
                const FloatControl control(rounding | flush);
                const unsigned before = _mm_getcsr() & control_bits;
                const auto unchanged = [&] { return (_mm_getcsr() & control_bits) == before; };

                const auto bsdf = support::builder(model).create();
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

TEST_CASE("float environment: no call of a film changes a control bit of MXCSR") {
    const unsigned rounding_modes[] = {_MM_ROUND_NEAREST, _MM_ROUND_DOWN, _MM_ROUND_UP, _MM_ROUND_TOWARD_ZERO};
    for (const unsigned rounding : rounding_modes)
        for (const unsigned flush : {0u, unsigned{_MM_FLUSH_ZERO_ON} | unsigned{_MM_DENORMALS_ZERO_ON}}) {
            const FloatControl control(rounding | flush);
            const unsigned before = _mm_getcsr() & control_bits;
            const auto unchanged = [&] { return (_mm_getcsr() & control_bits) == before; };

            const auto film = pellicle::FilmBuilder("BK7").layer("TiO2", 0, 400).transmittance().create();
            CHECK(unchanged());
            film.reflectance(0.5f, 200.0f);
            CHECK(unchanged());
            film.eval(0.5f, 200.0f, PELLICLE_SIDE_BASE);
            CHECK(unchanged());
            film.reference(0.5f, 200.0f);
            CHECK(unchanged());
            const float lambda_nm = 550.0f, number = 0.5f;
            float reflectance[3];
            film.spectrum(0.5f, 200.0f, &lambda_nm, 1, reflectance);
            CHECK(unchanged());
            PellicleFilmBatchArgs args{};
            args.count = 1;
            args.cos_theta = args.thickness_nm = {&number, 4, 4};
            args.reflectance = {reflectance, 12, 4};
            film.reflectance_batch(args);
            CHECK(unchanged());
            CHECK_THROWS_AS(pellicle::FilmBuilder("no such medium").create(), pellicle::Error);
            CHECK(unchanged());
        }
}
