// Hosts set flush-to-zero and denormals-are-zero (Embree asks for both); some set another rounding, or unmask
// traps to find their own errors. The library gives the same results under the latter, is right under the
// former, and leaves the register as it was.
#include "float_control.hpp"
#include "support.hpp"

#include <cfloat>
#include <cmath>

namespace {

using float_control::Bits;
using float_control::Scope;
using support::Vec3;

struct Inputs {
    Vec3 wo, wi, u;
    std::vector<float> varying;
};

// What raises exceptions: no numbers, numbers that vanish or overflow when squared, grazing angles, lengths that
// are normalised first.
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

void add_hard_inputs(std::vector<Inputs> &inputs) {
    const Inputs valid = inputs[0];
    const float infinity = support::infinity, nan = support::quiet_nan;
    for (const Vec3 &w : {Vec3{0, 0, 0}, Vec3{nan, 0, 1}, Vec3{0, infinity, 0}, Vec3{3e38f, 3e38f, 3e38f},
                          Vec3{1e-30f, 0, 1e-30f}, Vec3{1, 0, 1e-45f}, Vec3{1, 0, 1e-7f}, Vec3{0.6f, 0, -0.8f},
                          Vec3{0.6005f, 0, 0.8005f}, Vec3{1, 0, 0}}) {
        inputs.push_back({w, valid.wi, valid.u, valid.varying});
        inputs.push_back({valid.wo, w, valid.u, valid.varying});
        inputs.push_back({valid.wo, valid.wi, w, valid.varying});
        inputs.push_back({w, w, valid.u, valid.varying});
    }
    for (const float number : {nan, infinity, -infinity, 1e-40f, 0.0f, 3e38f})
        inputs.push_back({valid.wo, valid.wi, valid.u, std::vector<float>(valid.varying.size(), number)});
}

constexpr std::size_t numbers_each = 16, albedos = 3;

// The numbers of single calls, of batches and of some albedos. Nothing but calls happens here, because the host's
// own arithmetic would depend on the register, too. Failures are counted.
int call_all(const pellicle::Bsdf &bsdf, const std::vector<Inputs> &inputs, std::vector<float> &all) {
    const PellicleBsdf *raw = bsdf.raw();
    int failures = 0;
    float *next = all.data();
    for (const Inputs &input : inputs) {
        failures += pellicle_bsdf_eval(raw, input.wo.data(), input.wi.data(), input.varying.data(), nullptr, next,
                                       next + 3, next + 4) != PELLICLE_OK;
        PellicleSample sample;
        failures += pellicle_bsdf_sample(raw, input.wo.data(), input.u.data(), input.varying.data(), nullptr, &sample,
                                         sizeof sample) != PELLICLE_OK;
        std::memcpy(next + 5, &sample, sizeof sample);
        next += numbers_each;
    }
    for (std::size_t i = 0; i < albedos; ++i, next += 3)
        failures += pellicle_bsdf_albedo(raw, inputs[i].wo.data(), inputs[i].varying.data(), nullptr, next) != PELLICLE_OK;
    return failures;
}

std::vector<float> room_for(const std::vector<Inputs> &inputs) {
    return std::vector<float>(numbers_each * inputs.size() + 3 * albedos);
}

// The same inputs as arrays for a batch, and what it returns.
struct Batch {
    explicit Batch(const support::Varying &subject, const std::vector<Inputs> &inputs)
        : count(inputs.size()), value(count), wi(count), weight(count), pdf(count), reverse(count), density(count) {
        std::size_t first = 0;
        for (const std::size_t components : subject.components()) {
            firsts.push_back(first);
            first += components;
        }
        for (const Inputs &input : inputs) {
            wo_in.push_back(input.wo);
            wi_in.push_back(input.wi);
            u_in.push_back(input.u);
            varying.insert(varying.end(), input.varying.begin(), input.varying.end());
        }
        const auto stride = static_cast<std::ptrdiff_t>(sizeof(float) * first);
        for (const std::size_t at : firsts) views.push_back({varying.data() + at, stride, 4});
    }

    int call(const PellicleBsdf *bsdf) {
        PellicleEvalBatchArgs eval{};
        eval.count = count;
        eval.wo = {wo_in[0].data(), 12, 4};
        eval.wi = {wi_in[0].data(), 12, 4};
        eval.varying = views.data();
        eval.varying_count = views.size();
        eval.value = {value[0].data(), 12, 4};
        eval.pdf = {pdf.data(), 4, 4};
        eval.pdf_reverse = {reverse.data(), 4, 4};
        PellicleSampleBatchArgs sample{};
        sample.count = count;
        sample.wo = eval.wo;
        sample.u = {u_in[0].data(), 12, 4};
        sample.varying = eval.varying;
        sample.varying_count = eval.varying_count;
        sample.wi = {wi[0].data(), 12, 4};
        sample.weight = {weight[0].data(), 12, 4};
        sample.pdf = {density.data(), 4, 4};
        return (pellicle_bsdf_eval_batch(bsdf, &eval, sizeof eval) != PELLICLE_OK) +
               (pellicle_bsdf_sample_batch(bsdf, &sample, sizeof sample) != PELLICLE_OK);
    }

    bool operator==(const Batch &other) const {
        const auto same = [&](const float *a, const float *b, std::size_t each) {
            return support::same_bits(a, b, each * count);
        };
        return same(value[0].data(), other.value[0].data(), 3) && same(wi[0].data(), other.wi[0].data(), 3) &&
               same(weight[0].data(), other.weight[0].data(), 3) && same(pdf.data(), other.pdf.data(), 1) &&
               same(reverse.data(), other.reverse.data(), 1) && same(density.data(), other.density.data(), 1);
    }

    std::size_t count;
    std::vector<Vec3> wo_in, wi_in, u_in;
    std::vector<float> varying;
    std::vector<std::size_t> firsts;
    std::vector<PellicleConstView> views;
    std::vector<Vec3> value, wi, weight;
    std::vector<float> pdf, reverse, density;
};

struct Mode {
    std::string name;
    Bits bits;
};

// What a host may set, beside flush-to-zero in `beside`. No flag is raised.
std::vector<Mode> modes(Bits beside = 0) {
    using namespace float_control;
    const Bits plain = (read() & ~flags) | beside;
    return {{"to nearest, no traps", plain},
            {"down", plain | rounding_down},
            {"up", plain | rounding_up},
            {"to zero", plain | rounding_to_zero},
            {"to nearest, all traps", trapping(plain)},
            {"up, all traps", trapping(plain) | rounding_up}};
}

// Films of every kind of evaluator, with the colours of both sides.
std::vector<pellicle::FilmBuilder> film_builders() {
    using pellicle::FilmBuilder;
    using pellicle::Medium;
    const auto glass = [] { return FilmBuilder(Medium::constant(1.5f)); };
    const auto coated = [&] { return glass().layer(Medium::constant(1.38f), 0, 400); };
    return {FilmBuilder("Au").tolerance(0.01f),
            glass().layer(Medium::constant(1.9f, 0.01f), 0, 100).tolerance(0.01f).transmittance(),
            coated().method("harmonics").tolerance(0.3f),
            coated().method("bands").tolerance(0.05f),
            coated().transmittance().method("series"),
            coated().transmittance().method("reference")};
}

const float cosines[] = {0.0f, 1e-45f, 1e-40f, 1e-20f, 0.1f, 0.7f, 1.0f, 1.5f, -1.0f, support::infinity,
                         support::quiet_nan};
const float thicknesses[] = {0.0f, 1e-40f, 1e-3f, 250.0f, 400.0f, 1e30f, support::infinity, support::quiet_nan};
constexpr std::size_t film_calls = std::size(cosines) * std::size(thicknesses);
constexpr std::size_t film_numbers = 3 * 6;

int call_all(const PellicleFilm *film, std::vector<float> &all) {
    int failures = 0;
    float *next = all.data();
    const float lambda_nm[3] = {450.0f, 550.0f, 650.0f};
    for (const float c : cosines)
        for (const float d : thicknesses) {
            failures += pellicle_film_reflectance(film, c, d, next) != PELLICLE_OK;
            failures += pellicle_film_eval(film, c, d, PELLICLE_SIDE_BASE, next + 3, next + 6) != PELLICLE_OK;
            failures += pellicle_film_reference(film, c, d, next + 9) != PELLICLE_OK;
            failures += pellicle_film_spectrum(film, c, d, lambda_nm, 3, next + 12) != PELLICLE_OK;
            PellicleFilmBatchArgs args{};
            args.count = 1;
            args.cos_theta = {&c, 4, 4};
            args.thickness_nm = {&d, 4, 4};
            args.reflectance = {next + 15, 12, 4};
            failures += pellicle_film_reflectance_batch(film, &args, sizeof args) != PELLICLE_OK;
            next += film_numbers;
        }
    return failures;
}

std::size_t differences(const std::vector<float> &a, const std::vector<float> &b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.size(); ++i) count += !support::same_bits(&a[i], &b[i], 1);
    return count;
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

TEST_CASE("float environment: results are the same under every rounding and with every trap, and the register stays") {
    for (const support::Model &model : support::models_with_and_without_film()) {
        CAPTURE(std::string(model.info.name));
        const support::Varying subject(model);
        std::vector<Inputs> inputs = random_inputs(subject, 500);
        add_hard_inputs(inputs);
        for (const Bits beside : {Bits{0}, float_control::flush}) {
            std::vector<float> expected = room_for(inputs);
            Batch expected_batch(subject, inputs);
            {
                const Scope scope(modes(beside)[0].bits);
                CHECK_EQ(call_all(subject.bsdf(), inputs, expected), 0);
                CHECK_EQ(expected_batch.call(subject.bsdf().raw()), 0);
            }
            for (const Mode &mode : modes(beside)) {
                CAPTURE(mode.name);
                std::vector<float> found = room_for(inputs);
                Batch batch(subject, inputs);
                int failures;
                Bits after;
                {
                    const Scope scope(mode.bits);
                    failures = call_all(subject.bsdf(), inputs, found);
                    failures += batch.call(subject.bsdf().raw());
                    after = float_control::read();
                }
                CHECK_EQ(failures, 0);
                CHECK_EQ(differences(found, expected), 0u);
                CHECK(batch == expected_batch);
                CHECK_EQ(after & ~float_control::flags, mode.bits);
                // Who looks for the origin of an exception finds no flag of the library's.
                if (float_control::is_trapping(mode.bits)) CHECK_EQ(after, mode.bits);
            }
        }
    }
}

TEST_CASE("float environment: a BSDF created under any rounding, trap or flush-to-zero is the same") {
    for (const support::Model &model : support::models_with_and_without_film()) {
        CAPTURE(std::string(model.info.name));
        const support::Varying plain(model);
        const std::vector<Inputs> inputs = random_inputs(plain, 200);
        std::vector<float> expected = room_for(inputs), found = room_for(inputs);
        CHECK_EQ(call_all(plain.bsdf(), inputs, expected), 0);
        for (const Bits beside : {Bits{0}, float_control::flush})
            for (const Mode &mode : modes(beside)) {
                CAPTURE(mode.name);
                Bits after = 0;
                // Only the creation: the arithmetic of support::Varying is the host's.
                const support::Varying created(model, [&](const pellicle::BsdfBuilder &builder) {
                    pellicle::Bsdf bsdf;
                    const Scope scope(mode.bits);
                    const PellicleStatus status = builder.create(bsdf);
                    after = float_control::read();
                    return status == PELLICLE_OK ? std::move(bsdf) : pellicle::Bsdf();
                });
                REQUIRE(created.bsdf().raw());
                CHECK_EQ(after & ~float_control::flags, mode.bits);
                CHECK_EQ(call_all(created.bsdf(), inputs, found), 0);
                CHECK_EQ(differences(found, expected), 0u);
            }
    }
}

// Blender's --debug-fpe does this. Single calls do not read MXCSR, which is slow on some processors; they know from
// their handle that traps were unmasked when it was made.
TEST_CASE("float environment: traps unmasked in one unit alone, before anything is created, do not fire") {
    const Bits plain = float_control::read() & ~float_control::flags;
    const auto film_builder = pellicle::FilmBuilder(pellicle::Medium::constant(1.5f))
                                  .layer(pellicle::Medium::constant(1.9f, 0.01f), 0, 100)
                                  .tolerance(0.01f)
                                  .transmittance();
    const pellicle::Film expected_film = film_builder.create();
    std::vector<float> expected_colors(film_calls * film_numbers), colors = expected_colors;
    CHECK_EQ(call_all(expected_film.raw(), expected_colors), 0);
    pellicle::Film film;
    {
        const Scope scope(plain);
        float_control::write(float_control::trapping(plain));
        const PellicleStatus status = film_builder.create(film);
        const int failures = call_all(film.raw(), colors);
        float_control::write(plain);
        REQUIRE_EQ(status, PELLICLE_OK);
        CHECK_EQ(failures, 0);
    }
    CHECK_EQ(differences(colors, expected_colors), 0u);
    for (const support::Model &model : support::models_with_and_without_film()) {
        CAPTURE(std::string(model.info.name));
        const support::Varying subject(model);
        std::vector<Inputs> inputs = random_inputs(subject, 50);
        add_hard_inputs(inputs);
        std::vector<float> expected = room_for(inputs), found = room_for(inputs);
        CHECK_EQ(call_all(subject.bsdf(), inputs, expected), 0);
        const support::Varying created(model, [&](const pellicle::BsdfBuilder &builder) {
            pellicle::Bsdf bsdf;
            float_control::write(float_control::trapping(plain));
            const PellicleStatus status = builder.create(bsdf);
            float_control::write(plain);
            return status == PELLICLE_OK ? std::move(bsdf) : pellicle::Bsdf();
        });
        float_control::write(float_control::trapping(plain));
        const int failures = call_all(created.bsdf(), inputs, found);
        const Bits after = float_control::read();
        float_control::write(plain);
        CHECK_EQ(failures, 0);
        const Bits set = float_control::trapping(plain);
        CHECK_EQ(after & ~float_control::flags, set);
        if (float_control::is_trapping(set)) CHECK_EQ(after, set);
        CHECK_EQ(differences(found, expected), 0u);
    }
}

TEST_CASE("float environment: films are the same, created and called under every rounding and with every trap") {
    std::vector<float> expected(film_calls * film_numbers), found = expected;
    for (const pellicle::FilmBuilder &builder : film_builders()) {
        const pellicle::Film plain = builder.create();
        CAPTURE(std::string(plain.plan().method));
        // Films without transmittance refuse the base's side.
        const int refusals = call_all(plain.raw(), expected);
        for (const Mode &mode : modes()) {
            CAPTURE(mode.name);
            pellicle::Film created;
            int failures;
            Bits after_creation, after;
            PellicleStatus status;
            {
                const Scope scope(mode.bits);
                status = builder.create(created);
                after_creation = float_control::read();
                failures = call_all(plain.raw(), found);
                after = float_control::read();
            }
            REQUIRE_EQ(status, PELLICLE_OK);
            CHECK_EQ(failures, refusals);
            CHECK_EQ(differences(found, expected), 0u);
            CHECK_EQ(after_creation & ~float_control::flags, mode.bits);
            CHECK_EQ(after & ~float_control::flags, mode.bits);
            CHECK_EQ(call_all(created.raw(), found), refusals);
            CHECK_EQ(differences(found, expected), 0u);
        }
    }
}

TEST_CASE("float environment: a call that fails leaves the register as it was") {
    const auto film = pellicle::FilmBuilder("BK7").create();
    for (const Bits beside : {Bits{0}, float_control::flush})
        for (const Mode &mode : modes(beside)) {
            CAPTURE(mode.name);
            PellicleBsdfDesc desc{};
            desc.model = "no such model";
            PellicleBsdf *none = nullptr;
            PellicleFilm *no_film = nullptr;
            float rgb[3];
            PellicleStatus statuses[4];
            Bits after;
            {
                const Scope scope(mode.bits);
                statuses[0] = pellicle_bsdf_create(&desc, sizeof desc, &none);
                statuses[1] = pellicle_film_create(nullptr, 8, &no_film);
                statuses[2] = pellicle_film_eval(film.raw(), 0.5f, 0.0f, 7, rgb, rgb);
                statuses[3] = pellicle_film_reflectance(nullptr, 0.5f, 0.0f, rgb);
                after = float_control::read();
            }
            for (const PellicleStatus status : statuses) CHECK_NE(status, PELLICLE_OK);
            CHECK_EQ(after & ~float_control::flags, mode.bits);
        }
}

TEST_CASE("float environment: flush-to-zero and denormals-are-zero change nothing that matters") {
    for (const support::Model &model : support::models_with_and_without_film()) {
        CAPTURE(std::string(model.info.name));
        const support::Varying subject(model);
        for (const Inputs &inputs : random_inputs(subject, 5000)) {
            const std::vector<float> expected = results(subject.bsdf(), inputs);
            std::vector<float> flushed;
            {
                const Scope scope(float_control::read() | float_control::flush);
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
            const Scope scope(float_control::read() | float_control::flush);
            const Vec3 flushed = subject.bsdf().albedo(inputs.wo, inputs.varying.data());
            for (int channel = 0; channel < 3; ++channel)
                CHECK_LE(std::fabs(flushed[channel] - expected[channel]), 1e-6f * expected[channel] + FLT_MIN);
        }
    }
}

TEST_CASE("float environment: flush-to-zero and denormals-are-zero do not change a film, made or called under them") {
    const Bits flushing = float_control::read() | float_control::flush;
    std::vector<float> expected(film_calls * film_numbers), found = expected;
    for (const pellicle::FilmBuilder &builder : film_builders()) {
        const pellicle::Film plain = builder.create();
        CAPTURE(std::string(plain.plan().method));
        const int refusals = call_all(plain.raw(), expected);
        pellicle::Film made;
        PellicleStatus status;
        {
            const Scope scope(flushing);
            status = builder.create(made);
            CHECK_EQ(call_all(plain.raw(), found), refusals);
        }
        REQUIRE_EQ(status, PELLICLE_OK);
        for (std::size_t i = 0; i < expected.size(); ++i) CHECK_LE(std::fabs(found[i] - expected[i]), 1e-6f);
        CHECK_EQ(call_all(made.raw(), found), refusals);
        CHECK_EQ(differences(found, expected), 0u);
    }
}
