// Structs grow by appending. Here an older caller (smaller size) and a newer one (larger size) meet
// this build.
#include "support.hpp"

#include <algorithm>
#include <cstring>
#include <string>

namespace {

constexpr unsigned char guard = 0xA5;

// Bytes that the compiler inserts; their content means nothing.
struct Padding {
    std::size_t begin, end;
    bool holds(std::size_t byte) const { return byte >= begin && byte < end; }
};

// Calls with every size from 1 to beyond this build's, and looks at each byte of the output. A size
// that no struct has is a mistake and refused: 0, nonsense, or one that cuts a pointer or a number in two.
template <class Output, class Call> void check_written_up_to_size(Call call, std::vector<Padding> paddings = {}) {
    Output full;
    std::memset(&full, 0, sizeof full);
    REQUIRE_EQ(call(&full, sizeof full), PELLICLE_OK);
    unsigned char expected[sizeof full];
    std::memcpy(expected, &full, sizeof full);

    alignas(Output) unsigned char buffer[sizeof full + 32];
    for (std::size_t size = 1; size <= sizeof full + 16; ++size) {
        CAPTURE(size);
        std::memset(buffer, guard, sizeof buffer);
        const bool is_whole = size % alignof(Output) == 0;
        REQUIRE_EQ(call(reinterpret_cast<Output *>(buffer), size),
                   is_whole ? PELLICLE_OK : PELLICLE_INVALID_ARGUMENT);
        const std::size_t written = is_whole ? std::min(size, sizeof full) : 0;
        bool as_expected = true;
        for (std::size_t i = 0; i < sizeof buffer; ++i) {
            if (std::any_of(paddings.begin(), paddings.end(), [i](Padding padding) { return padding.holds(i); })) continue;
            as_expected = as_expected && buffer[i] == (i < written ? expected[i] : guard);
        }
        CHECK(as_expected);
    }
    for (const std::size_t nonsense : {std::size_t{0}, SIZE_MAX})
        CHECK_REFUSED(call(reinterpret_cast<Output *>(buffer), nonsense), PELLICLE_INVALID_ARGUMENT, "size");
}

pellicle::Bsdf lambert() {
    return pellicle::BsdfBuilder("lambert").create();
}

const float up[3] = {0.0f, 0.0f, 1.0f};
const float slanted[3] = {0.0f, 0.6f, 0.8f};

const float visible_nm[1] = {550.0f};

// One valid element for each batch call.
struct EvalSpectralBatch {
    float value = -1.0f;
    PellicleEvalSpectralBatchArgs args{};
    EvalSpectralBatch() {
        args.count = args.lambda_count = 1;
        args.lambda_nm = {visible_nm, 4, 4};
        args.wo = {up, 12, 4};
        args.wi = {slanted, 12, 4};
        args.value = {&value, 4, 4};
    }
};

struct SampleSpectralBatch {
    float weight = -1.0f;
    PellicleSampleSpectralBatchArgs args{};
    SampleSpectralBatch() {
        args.count = args.lambda_count = 1;
        args.lambda_nm = {visible_nm, 4, 4};
        args.wo = {up, 12, 4};
        args.u = {slanted, 12, 4};
        args.weight = {&weight, 4, 4};
    }
};

struct EvalBatch {
    float value[3] = {-1.0f, -1.0f, -1.0f};
    float pdf = -1.0f;
    PellicleEvalBatchArgs args{};
    EvalBatch() {
        args.count = 1;
        args.wo = {up, 12, 4};
        args.wi = {slanted, 12, 4};
        args.value = {value, 12, 4};
        args.pdf = {&pdf, 4, 4};
    }
};

struct SampleBatch {
    float wi[3] = {-1.0f, -1.0f, -1.0f};
    float pdf = -1.0f;
    std::uint32_t lobe = 77;
    PellicleSampleBatchArgs args{};
    SampleBatch() {
        args.count = 1;
        args.wo = {up, 12, 4};
        args.u = {slanted, 12, 4};
        args.wi = {wi, 12, 4};
        args.pdf = {&pdf, 4, 4};
        args.lobe = {&lobe, 4};
    }
};

struct FilmBatch {
    float cosine = 1.0f;
    float reflectance[3] = {-1.0f, -1.0f, -1.0f};
    PellicleFilmBatchArgs args{};
    FilmBatch() {
        args.count = 1;
        args.cos_theta = {&cosine, 4, 4};
        args.reflectance = {reflectance, 12, 4};
    }
};

struct AmplitudesBatch {
    float cosine = 1.0f, lambda_nm = 550.0f;
    float r_s[2] = {-2.0f, -2.0f};
    PellicleAmplitudesBatchArgs args{};
    AmplitudesBatch() {
        args.count = args.lambda_count = 1;
        args.cos_theta = {&cosine, 4, 4};
        args.lambda_nm = {&lambda_nm, 4, 4};
        args.r_s = {r_s, 8, 4};
    }
};

// `input` followed by `tail` bytes of which the one at `position` is `byte`; ends at a guard page.
template <class Input> class WithTail {
public:
    WithTail(const Input &input, std::size_t tail, std::size_t position, unsigned char byte)
        : bytes_(sizeof input + tail), size_(sizeof input + tail) {
        std::memcpy(bytes_.template as<unsigned char>(), &input, sizeof input);
        bytes_.template as<unsigned char>()[sizeof input + position] = byte;
    }
    const Input *get() { return bytes_.template as<Input>(); }
    std::size_t size() const { return size_; }

private:
    support::GuardedBytes bytes_;
    std::size_t size_;
};

template <class Input, class Call> void check_tails(const Input &input, Call call) {
    for (const std::size_t tail : {8, 16, 256}) {
        CAPTURE(tail);
        WithTail<Input> zero(input, tail, 0, 0);
        CHECK_EQ(call(zero.get(), zero.size()), PELLICLE_OK);
        for (const std::size_t position : {std::size_t{0}, tail / 2 + 1, tail - 1}) {
            CAPTURE(position);
            WithTail<Input> unknown(input, tail, position, 1);
            CHECK_EQ(call(unknown.get(), unknown.size()), PELLICLE_UNSUPPORTED);
        }
    }
}

// The first `size` bytes of `input`, ending at a guard page: reading more stops the program.
template <class Input, class Call> PellicleStatus call_truncated(const Input &input, std::size_t size, Call call) {
    support::GuardedBytes bytes(size);
    std::memcpy(bytes.as<unsigned char>(), &input, size);
    return call(bytes.as<const Input>(), size);
}

} // namespace

TEST_CASE("growth: every struct that is written is written up to the size given") {
    static const auto bsdf = pellicle::BsdfBuilder("phong").vary("exponent", 1.0f, 9.0f).create();
    static const PellicleFilm *const film = support::fixed_film().raw();
    check_written_up_to_size<PellicleModelInfo>(
        [](PellicleModelInfo *info, std::size_t size) { return pellicle_model_info(0, info, size); },
        {{36, 40}, {60, 64}});
    check_written_up_to_size<PellicleModelParam>(
        [](PellicleModelParam *info, std::size_t size) { return pellicle_model_param(0, 0, info, size); }, {{68, 72}});
    check_written_up_to_size<PellicleMediumInfo>(
        [](PellicleMediumInfo *info, std::size_t size) { return pellicle_medium_info(0, info, size); }, {{36, 40}});
    check_written_up_to_size<PellicleBsdfInfo>(
        [](PellicleBsdfInfo *info, std::size_t size) { return pellicle_bsdf_info(bsdf.raw(), info, size); });
    check_written_up_to_size<PellicleVaryingInfo>([](PellicleVaryingInfo *info, std::size_t size) {
        return pellicle_bsdf_varying(bsdf.raw(), 0, info, size);
    });
    check_written_up_to_size<PellicleLobeInfo>(
        [](PellicleLobeInfo *info, std::size_t size) { return pellicle_bsdf_lobe(bsdf.raw(), 0, info, size); },
        {{12, 16}});
    check_written_up_to_size<PellicleSample>([](PellicleSample *sample, std::size_t size) {
        const float u[3] = {0.3f, 0.6f, 0.9f};
        return pellicle_bsdf_sample(bsdf.raw(), up, u, nullptr, nullptr, sample, size);
    });
    check_written_up_to_size<PellicleSpectralSample>([](PellicleSpectralSample *sample, std::size_t size) {
        const float u[3] = {0.3f, 0.6f, 0.9f}, lambda_nm[2] = {450.0f, 650.0f};
        float weight[2];
        return pellicle_bsdf_sample_spectral(bsdf.raw(), up, u, nullptr, nullptr, lambda_nm, 2, 1, weight, nullptr, sample,
                                             size);
    });
    check_written_up_to_size<PellicleFilmInfo>(
        [](PellicleFilmInfo *info, std::size_t size) { return pellicle_film_info(film, info, size); });
    check_written_up_to_size<PellicleFilmPlan>(
        [](PellicleFilmPlan *plan, std::size_t size) { return pellicle_film_plan(film, plan, size); },
        {{20, 24}, {100, 104}});
}

TEST_CASE("growth: an older, shorter BSDF description means default for what it lacks") {
    PellicleBsdfDesc desc{};
    desc.model = "lambert";
    desc.params = reinterpret_cast<const PellicleParam *>(std::uintptr_t{16});
    desc.param_count = 9;
    desc.varying = reinterpret_cast<const PellicleRange *>(std::uintptr_t{16});
    desc.varying_count = 9;
    const auto create = [](const PellicleBsdfDesc *truncated, std::size_t size) {
        PellicleBsdf *raw = nullptr;
        const PellicleStatus status = pellicle_bsdf_create(truncated, size, &raw);
        const pellicle::Bsdf bsdf(raw);
        if (status == PELLICLE_OK) {
            CHECK_EQ(bsdf.info().varying_count, 0);
            CHECK_EQ(bsdf.value(up, up)[0], doctest::Approx(0.5 / 3.14159265));
        }
        return status;
    };

    CHECK_EQ(call_truncated(desc, offsetof(PellicleBsdfDesc, params), create), PELLICLE_OK);
    desc.params = nullptr;
    desc.param_count = 0;
    CHECK_EQ(call_truncated(desc, offsetof(PellicleBsdfDesc, varying), create), PELLICLE_OK);
    CHECK_EQ(call_truncated(desc, 0, create), PELLICLE_INVALID_ARGUMENT);
}

TEST_CASE("growth: older, shorter eval batch arguments leave out the outputs they lack") {
    const auto bsdf = lambert();
    EvalBatch batch;
    const auto call = [&](const PellicleEvalBatchArgs *args, std::size_t size) {
        return pellicle_bsdf_eval_batch(bsdf.raw(), args, size);
    };
    CHECK_EQ(call_truncated(batch.args, offsetof(PellicleEvalBatchArgs, pdf), call), PELLICLE_OK);
    CHECK_EQ(batch.value[0], doctest::Approx(0.5 * 0.8 / 3.14159265));
    CHECK_EQ(batch.pdf, -1.0f);
}

TEST_CASE("growth: older, shorter sample batch arguments leave out the outputs they lack") {
    const auto bsdf = lambert();
    SampleBatch batch;
    const auto call = [&](const PellicleSampleBatchArgs *args, std::size_t size) {
        return pellicle_bsdf_sample_batch(bsdf.raw(), args, size);
    };
    CHECK_EQ(call_truncated(batch.args, offsetof(PellicleSampleBatchArgs, lobe), call), PELLICLE_OK);
    CHECK_GT(batch.pdf, 0.0f);
    CHECK_EQ(batch.lobe, 77);
}

// Found by the fuzzer: half of the pointer to the model's name was followed.
TEST_CASE("growth: a description that ends within a pointer is refused") {
    PellicleBsdfDesc desc{};
    desc.model = "lambert";
    support::FilmDescription film;
    for (std::size_t size = 1; size < sizeof film.desc; ++size) {
        if (size % alignof(PellicleFilmDesc) == 0) continue;
        CAPTURE(size);
        support::Untouched<PellicleBsdf *> bsdf;
        if (size < sizeof desc)
            CHECK_REFUSED(pellicle_bsdf_create(&desc, size, &bsdf.output), PELLICLE_INVALID_ARGUMENT, "size");
        support::Untouched<PellicleFilm *> handle;
        CHECK_REFUSED(pellicle_film_create(&film.raw(), size, &handle.output), PELLICLE_INVALID_ARGUMENT, "size");
    }
}

TEST_CASE("growth: an older BSDF description ends before its film") {
    PellicleBsdfDesc desc{};
    desc.model = "lambert";
    desc.film = reinterpret_cast<const PellicleFilm *>(std::uintptr_t{16});
    const auto create = [](const PellicleBsdfDesc *truncated, std::size_t size) {
        PellicleBsdf *raw = nullptr;
        const PellicleStatus status = pellicle_bsdf_create(truncated, size, &raw);
        pellicle_bsdf_release(raw);
        return status;
    };
    CHECK_EQ(call_truncated(desc, offsetof(PellicleBsdfDesc, film), create), PELLICLE_OK);
}

TEST_CASE("growth: an older, shorter film description means default for what it lacks") {
    support::FilmDescription film;
    PellicleFilmDesc desc = film.raw();
    desc.tolerance = -1.0f;
    desc.unclipped = desc.transmittance = 2;
    desc.base_opaque = 3;
    desc.white = desc.color_space = desc.method = desc.simd_level = "no such name";
    const auto create = [](const PellicleFilmDesc *truncated, std::size_t size) {
        PellicleFilm *raw = nullptr;
        const PellicleStatus status = pellicle_film_create(truncated, size, &raw);
        const pellicle::Film film(raw);
        if (status == PELLICLE_OK) CHECK_EQ(film.plan().tolerance, 2e-3f);
        return status;
    };
    const auto up_to = [&](std::size_t size) { return call_truncated(desc, size, create); };
    CHECK_EQ(up_to(offsetof(PellicleFilmDesc, tolerance)), PELLICLE_OK);
    CHECK_EQ(up_to(offsetof(PellicleFilmDesc, white)), PELLICLE_OUT_OF_RANGE);
    desc.tolerance = 0.0f;
    desc.unclipped = desc.transmittance = 0;
    CHECK_EQ(up_to(offsetof(PellicleFilmDesc, white)), PELLICLE_OK);
    CHECK_EQ(up_to(offsetof(PellicleFilmDesc, color_space)), PELLICLE_UNKNOWN_NAME);
    desc.white = desc.color_space = desc.method = nullptr;
    CHECK_EQ(up_to(offsetof(PellicleFilmDesc, simd_level)), PELLICLE_OK);
    CHECK_EQ(up_to(offsetof(PellicleFilmDesc, base_opaque)), PELLICLE_UNKNOWN_NAME);
    desc.simd_level = nullptr;
    CHECK_EQ(up_to(offsetof(PellicleFilmDesc, base_opaque)), PELLICLE_OK);
    CHECK_EQ(up_to(sizeof desc), PELLICLE_OUT_OF_RANGE);
    CHECK_REFUSED(up_to(offsetof(PellicleFilmDesc, base)), PELLICLE_INVALID_ARGUMENT, "base");
    CHECK_EQ(up_to(0), PELLICLE_INVALID_ARGUMENT);
}

// A caller's elements may be shorter or longer than this build's: the description states their size.
TEST_CASE("growth: shorter media and layers mean default for what they lack") {
    support::FilmDescription film;
    film.layers = {{support::medium("water"), 10.0f, 20.0f}, {support::medium("SiO2"), 30.0f, 30.0f}};
    PellicleFilmDesc desc = film.raw();

    // Media that end before the table: what follows in memory is not looked at.
    constexpr std::size_t short_medium = offsetof(PellicleMedium, table_nm);
    PellicleMedium base = support::medium(1.5f);
    base.table_count = 99;
    PellicleMedium of_layer = support::medium("water");
    of_layer.table_eta = base.eta;
    const PellicleLayer layer = {&of_layer, 10.0f, 20.0f};
    desc.layers = &layer;
    desc.layer_count = 1;
    desc.base = desc.ambient = &base;
    CHECK_EQ(support::create_film(desc), PELLICLE_INVALID_ARGUMENT);
    desc.medium_size = short_medium;
    CHECK_EQ(support::create_film(desc), PELLICLE_OK);

    // Layers that end before their thicknesses, side by side: pointers alone, of thickness 0.
    const PellicleMedium *const pointers[2] = {&of_layer, &of_layer};
    desc.layers = reinterpret_cast<const PellicleLayer *>(pointers);
    desc.layer_size = sizeof pointers[0];
    desc.layer_count = 2;
    PellicleFilm *raw = nullptr;
    REQUIRE_EQ(pellicle_film_create(&desc, sizeof desc, &raw), PELLICLE_OK);
    CHECK_EQ(pellicle::Film(raw).info().varies, 0);
}

TEST_CASE("growth: longer media and layers are taken if what this build does not know is zero") {
    struct LongerMedium {
        PellicleMedium medium;
        std::uint64_t tail[2];
    };
    struct LongerLayer {
        PellicleLayer layer;
        std::uint64_t tail;
    };
    LongerMedium base = {support::medium(1.5f), {}}, ambient = {{}, {}}, water = {support::medium("water"), {}};
    LongerLayer layers[2] = {{{&water.medium, 0.0f, 200.0f}, 0}, {{&water.medium, 50.0f, 50.0f}, 0}};
    PellicleFilmDesc desc{};
    desc.medium_size = sizeof(LongerMedium);
    desc.layer_size = sizeof(LongerLayer);
    desc.ambient = &ambient.medium;
    desc.layers = &layers[0].layer;
    desc.layer_count = 2;
    desc.base = &base.medium;
    REQUIRE_EQ(support::create_film(desc), PELLICLE_OK);
    const pellicle::Film longer(desc);

    support::FilmDescription same;
    same.layers = {{support::medium("water"), 0.0f, 200.0f}, {support::medium("water"), 50.0f, 50.0f}};
    const pellicle::Film plain(same.raw());
    CHECK(support::same_bits(longer.reflectance(0.7f, 120.0f).data(), plain.reflectance(0.7f, 120.0f).data(), 3));

    const std::pair<std::uint64_t *, const char *> tails[] = {{&base.tail[1], "base"},
                                                              {&ambient.tail[0], "ambient"},
                                                              {&water.tail[1], "layers[0].medium"},
                                                              {&layers[1].tail, "layers[1]"}};
    for (const auto &[tail, words] : tails) {
        *tail = 1;
        CHECK_REFUSED(support::create_film(desc), PELLICLE_UNSUPPORTED, words);
        *tail = 0;
    }
}

TEST_CASE("growth: film batch arguments too short for their output are refused") {
    FilmBatch batch;
    const auto call = [](const PellicleFilmBatchArgs *args, std::size_t size) {
        return pellicle_film_reflectance_batch(support::fixed_film().raw(), args, size);
    };
    CHECK_REFUSED(call_truncated(batch.args, offsetof(PellicleFilmBatchArgs, reflectance), call),
                  PELLICLE_INVALID_ARGUMENT, "reflectance");
    CHECK_EQ(batch.reflectance[0], -1.0f);
}

TEST_CASE("growth: a newer description is refused if it uses what this build does not know") {
    PellicleBsdfDesc desc{};
    desc.model = "lambert";
    check_tails(desc, [](const PellicleBsdfDesc *longer, std::size_t size) {
        PellicleBsdf *raw = nullptr;
        const PellicleStatus status = pellicle_bsdf_create(longer, size, &raw);
        CHECK_EQ(raw != nullptr, status == PELLICLE_OK);
        pellicle_bsdf_release(raw);
        return status;
    });
    support::FilmDescription film;
    check_tails(film.raw(), [](const PellicleFilmDesc *longer, std::size_t size) {
        PellicleFilm *raw = nullptr;
        const PellicleStatus status = pellicle_film_create(longer, size, &raw);
        CHECK_EQ(raw != nullptr, status == PELLICLE_OK);
        pellicle_film_release(raw);
        return status;
    });
}

TEST_CASE("growth: newer batch arguments are refused if they use what this build does not know") {
    const auto bsdf = lambert();
    EvalBatch eval;
    check_tails(eval.args, [&](const PellicleEvalBatchArgs *longer, std::size_t size) {
        eval.pdf = -1.0f;
        const PellicleStatus status = pellicle_bsdf_eval_batch(bsdf.raw(), longer, size);
        CHECK_EQ(eval.pdf == -1.0f, status != PELLICLE_OK);
        return status;
    });
    SampleBatch sample;
    check_tails(sample.args, [&](const PellicleSampleBatchArgs *longer, std::size_t size) {
        sample.pdf = -1.0f;
        const PellicleStatus status = pellicle_bsdf_sample_batch(bsdf.raw(), longer, size);
        CHECK_EQ(sample.pdf == -1.0f, status != PELLICLE_OK);
        return status;
    });
    FilmBatch film;
    check_tails(film.args, [&](const PellicleFilmBatchArgs *longer, std::size_t size) {
        film.reflectance[0] = -1.0f;
        const PellicleStatus status = pellicle_film_reflectance_batch(support::fixed_film().raw(), longer, size);
        CHECK_EQ(film.reflectance[0] == -1.0f, status != PELLICLE_OK);
        return status;
    });
    EvalSpectralBatch eval_spectral;
    check_tails(eval_spectral.args, [&](const PellicleEvalSpectralBatchArgs *longer, std::size_t size) {
        eval_spectral.value = -1.0f;
        const PellicleStatus status = pellicle_bsdf_eval_spectral_batch(bsdf.raw(), longer, size);
        CHECK_EQ(eval_spectral.value == -1.0f, status != PELLICLE_OK);
        return status;
    });
    SampleSpectralBatch sample_spectral;
    check_tails(sample_spectral.args, [&](const PellicleSampleSpectralBatchArgs *longer, std::size_t size) {
        sample_spectral.weight = -1.0f;
        const PellicleStatus status = pellicle_bsdf_sample_spectral_batch(bsdf.raw(), longer, size);
        CHECK_EQ(sample_spectral.weight == -1.0f, status != PELLICLE_OK);
        return status;
    });
    AmplitudesBatch amplitudes;
    check_tails(amplitudes.args, [&](const PellicleAmplitudesBatchArgs *longer, std::size_t size) {
        amplitudes.r_s[0] = -2.0f;
        const PellicleStatus status = pellicle_film_amplitudes_batch(support::fixed_film().raw(), longer, size);
        CHECK_EQ(amplitudes.r_s[0] == -2.0f, status != PELLICLE_OK);
        return status;
    });
}
