// Fibres and worker threads have small stacks: every call needs at most 32 KiB, at every SIMD level.
#include "support.hpp"

#ifndef _WIN32

#include <functional>

#include <pthread.h>
#include <sys/mman.h>
#include <unistd.h>

namespace {

using support::Vec3;
using Call = std::function<void()>;

constexpr std::size_t most = 32 << 10;

// The stack of a thread, painted, so that one can see how deep it was used.
class PaintedStack {
public:
    PaintedStack() {
        void *mapping = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        REQUIRE_NE(mapping, MAP_FAILED);
        bytes_ = static_cast<unsigned char *>(mapping);
        // The C library's own part of the stack, and the way to the call.
        const Call nothing = [] {};
        run(nothing);
        run(nothing);
        // Shortened, so that the limit of a call is the end of a page.
        size_ -= untouched() % page() / 64 * 64;
        run(nothing);
        unused_ = untouched();
        REQUIRE_LT(unused_ % page(), 64u);
    }
    ~PaintedStack() { munmap(bytes_, size); }
    PaintedStack(const PaintedStack &) = delete;
    PaintedStack &operator=(const PaintedStack &) = delete;

    // The bytes that a call needs.
    std::size_t need(const Call &call) {
        run(call);
        return unused_ - untouched();
    }

    // Makes the call with `limit` bytes, and less than 64 more, above a page that may not be touched.
    void run_within(std::size_t limit, const Call &call) {
        const std::size_t guard = (unused_ - limit) / page() * page() - page();
        REQUIRE_EQ(mprotect(bytes_ + guard, page(), PROT_NONE), 0);
        start(call);
        REQUIRE_EQ(mprotect(bytes_ + guard, page(), PROT_READ | PROT_WRITE), 0);
    }

private:
    static constexpr std::size_t size = 1 << 20;
    static constexpr unsigned char paint = 0x5A;

    static std::size_t page() { return static_cast<std::size_t>(sysconf(_SC_PAGESIZE)); }

    void run(const Call &call) {
        std::memset(bytes_, paint, size);
        start(call);
    }

    void start(const Call &call) {
        pthread_attr_t attributes;
        pthread_attr_init(&attributes);
        REQUIRE_EQ(pthread_attr_setstack(&attributes, bytes_, size_), 0);
        pthread_t thread;
        const auto body = [](void *argument) -> void * {
            (*static_cast<const Call *>(argument))();
            return nullptr;
        };
        REQUIRE_EQ(pthread_create(&thread, &attributes, body, const_cast<Call *>(&call)), 0);
        pthread_join(thread, nullptr);
        pthread_attr_destroy(&attributes);
    }

    std::size_t untouched() const {
        std::size_t count = 0;
        while (count < size && bytes_[count] == paint) ++count;
        return count;
    }

    unsigned char *bytes_;
    std::size_t size_ = size;
    std::size_t unused_ = 0;
};

void check_within(std::size_t limit, const char *name, const Call &call) {
    static PaintedStack stack;
    CAPTURE(std::string(name));
    call(); // what is done once only
    const std::size_t need = stack.need(call);
    CHECK_LE(need, limit);
    if (need <= limit) stack.run_within(limit, call);
}

std::vector<std::string> levels() {
    std::vector<std::string> all;
    for (std::size_t i = 0; const char *name = pellicle_name(PELLICLE_NAMES_SIMD_LEVEL, i); ++i) all.push_back(name);
    return all;
}

// 1,000 elements: several chunks of any length. Strides of vectors are of packed elements, then of separate columns.
struct Arrays {
    static constexpr std::size_t count = 1000;
    std::vector<Vec3> wo, wi, u;
    std::vector<float> varying;
    std::vector<PellicleConstView> varying_views;
    std::vector<float> outputs;
    std::vector<std::uint32_t> numbers;
    std::ptrdiff_t element, component;

    Arrays(const support::Varying &subject, bool is_packed)
        : outputs(13 * count), numbers(2 * count), element(is_packed ? 12 : 4),
          component(is_packed ? 4 : static_cast<std::ptrdiff_t>(4 * count)) {
        std::mt19937 random(3);
        for (std::size_t i = 0; i < count; ++i) {
            wo.push_back(support::random_direction(random));
            wi.push_back(support::random_direction(random));
            u.push_back(support::random_uniforms(random));
            const std::vector<float> values = subject.random_values(random);
            varying.insert(varying.end(), values.begin(), values.end());
        }
        std::size_t first = 0;
        for (const std::size_t components : subject.components()) {
            varying_views.push_back({varying.data() + first, static_cast<std::ptrdiff_t>(4 * subject.floats()), 4});
            first += components;
        }
    }

    PellicleConstView input(const std::vector<Vec3> &vectors) const { return {vectors[0].data(), element, component}; }
    PellicleView vectors(std::size_t place) { return {outputs.data() + 3 * count * place, element, component}; }
    PellicleView scalars(std::size_t place) { return {outputs.data() + (9 + place) * count, 4, 4}; }

    PellicleStatus eval(const PellicleBsdf *bsdf) {
        PellicleEvalBatchArgs args{};
        args.count = count;
        args.wo = input(wo);
        args.wi = input(wi);
        args.varying = varying_views.data();
        args.varying_count = varying_views.size();
        args.value = vectors(0);
        args.pdf = scalars(0);
        args.pdf_reverse = scalars(1);
        return pellicle_bsdf_eval_batch(bsdf, &args, sizeof args);
    }

    PellicleStatus sample(const PellicleBsdf *bsdf) {
        PellicleSampleBatchArgs args{};
        args.count = count;
        args.wo = input(wo);
        args.u = input(u);
        args.varying = varying_views.data();
        args.varying_count = varying_views.size();
        args.wi = vectors(0);
        args.weight = vectors(1);
        args.pdf = scalars(0);
        args.eta = scalars(1);
        args.lobe_probability = scalars(2);
        args.flags = {numbers.data(), 4};
        args.lobe = {numbers.data() + count, 4};
        return pellicle_bsdf_sample_batch(bsdf, &args, sizeof args);
    }
};

} // namespace

TEST_CASE("stack: every call of a BSDF needs at most 32 KiB, at every SIMD level") {
    PellicleStatus status = PELLICLE_OK;
    const auto check = [&](const char *name, const Call &call) {
        check_within(most, name, call);
        CHECK_EQ(status, PELLICLE_OK);
    };
    for (const support::Model &model : support::models_with_and_without_film())
        for (const std::string &level : levels()) {
            CAPTURE(std::string(model.info.name));
            CAPTURE(level);
            const support::Varying subject(model, [&](const pellicle::BsdfBuilder &builder) {
                return pellicle::BsdfBuilder(builder).simd_level(level).create();
            });
            const PellicleBsdf *bsdf = subject.bsdf().raw();
            for (const bool is_packed : {true, false}) {
                Arrays arrays(subject, is_packed);
                check("eval_batch", [&] { status = arrays.eval(bsdf); });
                check("sample_batch", [&] { status = arrays.sample(bsdf); });
            }
            if (level != levels()[0]) continue;
            const Arrays one(subject, true);
            float value[3], pdf, reverse;
            PellicleSample sample;
            check("eval", [&] {
                status = pellicle_bsdf_eval(bsdf, one.wo[0].data(), one.wi[0].data(), one.varying.data(), nullptr, value,
                                            &pdf, &reverse);
            });
            check("sample", [&] {
                status = pellicle_bsdf_sample(bsdf, one.wo[0].data(), one.u[0].data(), one.varying.data(), nullptr,
                                              &sample, sizeof sample);
            });
            check("albedo", [&] {
                status = pellicle_bsdf_albedo(bsdf, one.wo[0].data(), one.varying.data(), nullptr, value);
            });
            // What varies may be anything here: enough numbers for 16 wavelengths of every parameter. Spreads are refused.
            const std::vector<float> lambda_nm(16, 550.0f), numbers(256, 0.3f);
            float at_each[2][16];
            PellicleSpectralSample drawn;
            check_within(most, "eval_spectral", [&] {
                pellicle_bsdf_eval_spectral(bsdf, one.wo[0].data(), one.wi[0].data(), numbers.data(), nullptr,
                                            lambda_nm.data(), 16, at_each[0], at_each[1]);
            });
            check_within(most, "sample_spectral", [&] {
                pellicle_bsdf_sample_spectral(bsdf, one.wo[0].data(), one.u[0].data(), numbers.data(), nullptr,
                                              lambda_nm.data(), 16, 5, at_each[0], at_each[1], &drawn, sizeof drawn);
            });
            PellicleEvalSpectralBatchArgs pairs{};
            pairs.count = 2;
            pairs.lambda_count = 16;
            pairs.lambda_nm = {lambda_nm.data(), 0, 4};
            pairs.wo = {one.wo[0].data(), 0, 4};
            pairs.wi = {one.wi[0].data(), 0, 4};
            pairs.value = {at_each[0], 0, 4};
            check_within(most, "eval_spectral_batch",
                         [&] { pellicle_bsdf_eval_spectral_batch(bsdf, &pairs, sizeof pairs); });
            PellicleSampleSpectralBatchArgs draws{};
            draws.count = 2;
            draws.lambda_count = 16;
            draws.lambda_nm = pairs.lambda_nm;
            draws.wo = pairs.wo;
            draws.u = {one.u[0].data(), 0, 4};
            draws.weight = pairs.value;
            check_within(most, "sample_spectral_batch",
                         [&] { pellicle_bsdf_sample_spectral_batch(bsdf, &draws, sizeof draws); });
            check("retain and release", [&] {
                pellicle_bsdf_retain(bsdf);
                pellicle_bsdf_release(bsdf);
            });
            PellicleBsdfInfo info;
            check("info", [&] { status = pellicle_bsdf_info(bsdf, &info, sizeof info); });
            PellicleLobeInfo lobe;
            check("lobe", [&] { status = pellicle_bsdf_lobe(bsdf, 0, &lobe, sizeof lobe); });
        }
}

TEST_CASE("stack: every call of a film needs at most 32 KiB, at every SIMD level") {
    using pellicle::FilmBuilder;
    using pellicle::Medium;
    const auto glass = [] { return FilmBuilder(Medium::constant(1.5f)); };
    const auto coated = [&] { return glass().layer(Medium::constant(1.38f), 0, 100).tolerance(0.02f); };
    auto many = FilmBuilder("Au").method("reference");
    for (int i = 0; i < 30; ++i) many.layer(i % 2 ? "TiO2" : "SiO2", 60);
    const FilmBuilder builders[] = {coated(),
                                    FilmBuilder("Au").tolerance(0.02f),
                                    glass().layer(Medium::constant(1.9f, 0.01f), 0, 100).tolerance(0.01f).transmittance(),
                                    coated().method("harmonics").tolerance(0.3f),
                                    coated().method("bands").tolerance(0.05f),
                                    coated().transmittance().method("series"),
                                    coated().transmittance().method("reference"),
                                    many};
    for (const FilmBuilder &builder : builders)
        for (const std::string &level : levels()) {
            CAPTURE(level);
            if (&builder != &builders[0] && level != levels()[0]) continue;
            const pellicle::Film film = FilmBuilder(builder).simd_level(level).create();
            CAPTURE(std::string(film.plan().method));
            PellicleStatus status = PELLICLE_OK;
            const auto check = [&](const char *name, const Call &call) {
                check_within(most, name, call);
                CHECK_EQ(status, PELLICLE_OK);
            };
            float rgb[6];
            check("reflectance", [&] { status = pellicle_film_reflectance(film.raw(), 0.5f, 100.0f, rgb); });
            // A film without transmittance refuses it: that needs a message.
            check_within(most, "eval", [&] {
                pellicle_film_eval(film.raw(), 0.5f, 100.0f, PELLICLE_SIDE_BASE, rgb, rgb + 3);
            });
            check("reference", [&] { status = pellicle_film_reference(film.raw(), 0.5f, 100.0f, rgb); });
            const float lambda_nm[] = {450, 550};
            check("spectrum", [&] { status = pellicle_film_spectrum(film.raw(), 0.5f, 100.0f, lambda_nm, 2, rgb); });
            check("spectrum_eval", [&] {
                status = pellicle_film_spectrum_eval(film.raw(), 0.5f, 100.0f, PELLICLE_SIDE_BASE, lambda_nm, 2, rgb, rgb + 2);
            });
            PellicleAmplitudes amplitudes[2];
            check("amplitudes", [&] {
                status = pellicle_film_amplitudes(film.raw(), 0.5f, 100.0f, PELLICLE_SIDE_AMBIENT, lambda_nm, 2, amplitudes);
            });
            PellicleAmplitudesBatchArgs pairs{};
            pairs.count = 1;
            pairs.lambda_count = 2;
            pairs.lambda_nm = {lambda_nm, 0, 4};
            pairs.cos_theta = pairs.thickness_nm = {lambda_nm, 4, 4};
            pairs.t_p = {rgb, 16, 4};
            check("amplitudes_batch", [&] { status = pellicle_film_amplitudes_batch(film.raw(), &pairs, sizeof pairs); });
            PellicleFilmPlan plan;
            check("plan", [&] { status = pellicle_film_plan(film.raw(), &plan, sizeof plan); });
            std::vector<float> cosines(1000, 0.5f), thicknesses(1000, 100.0f), reflectance(3000);
            PellicleFilmBatchArgs args{};
            args.count = film.plan().method == std::string("reference") ? 2 : 1000;
            args.cos_theta = {cosines.data(), 4, 4};
            args.thickness_nm = {thicknesses.data(), 4, 4};
            args.reflectance = {reflectance.data(), 12, 4};
            check("reflectance_batch",
                  [&] { status = pellicle_film_reflectance_batch(film.raw(), &args, sizeof args); });
        }
}

TEST_CASE("stack: what can be asked, and calls that fail, need at most 32 KiB") {
    PellicleModelInfo model;
    PellicleModelParam param;
    PellicleMediumInfo medium;
    check_within(most, "catalogue", [&] {
        for (std::size_t i = 0; i < pellicle_model_count(); ++i) pellicle_model_info(i, &model, sizeof model);
        pellicle_model_param(0, 0, &param, sizeof param);
        for (std::size_t i = 0; i < pellicle_medium_count(); ++i) pellicle_medium_info(i, &medium, sizeof medium);
        for (std::uint32_t list = 0; list < 8; ++list) pellicle_name(list, 0);
        pellicle_get_api(PELLICLE_ABI_VERSION);
    });
    PellicleBsdfDesc desc{};
    desc.model = "no such model";
    PellicleBsdf *none = nullptr;
    check_within(most, "failures", [&] {
        pellicle_bsdf_create(&desc, sizeof desc, &none);
        pellicle_film_reflectance(nullptr, 0.5f, 0.0f, nullptr);
        pellicle_model_info(1000, &model, sizeof model);
        pellicle_last_error();
    });
}

TEST_CASE("stack: creation needs at most 32 KiB") {
    for (const support::Model &model : support::models_with_and_without_film()) {
        CAPTURE(std::string(model.info.name));
        const auto builder = support::builder(model);
        check_within(most, "bsdf_create", [&] { builder.create(); });
    }
    using pellicle::FilmBuilder;
    using pellicle::Medium;
    const auto coated = [] { return FilmBuilder(Medium::constant(1.5f)).layer(Medium::constant(1.38f), 0, 100); };
    auto many = FilmBuilder("Au").tolerance(0.02f);
    for (int i = 0; i < 8; ++i) many.layer(i % 2 ? "TiO2" : "SiO2", 60);
    for (const FilmBuilder &builder :
         {coated(), coated().transmittance(), FilmBuilder("Au"), coated().method("bands").tolerance(0.05f),
          coated().method("harmonics").tolerance(0.3f), coated().transmittance().method("series"), many})
        check_within(most, "film_create", [&] { builder.create(); });
}

#endif
