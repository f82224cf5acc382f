// Every pointer of every function, NULL one at a time: refused by name, with the outputs untouched.
#include "support.hpp"

#include <functional>
#include <set>
#include <tuple>

namespace {

using support::Untouched;

const float up[3] = {0.0f, 0.0f, 1.0f};
const float u[3] = {0.3f, 0.6f, 0.9f};

pellicle::Bsdf lambert() {
    return pellicle::BsdfBuilder("lambert").create();
}

template <std::size_t place, class Call, class Arguments>
void check_null(Call call, Arguments arguments, const char *name) {
    if constexpr (std::is_pointer_v<std::tuple_element_t<place, Arguments>>) {
        if (*name == 0) return;
        std::get<place>(arguments) = nullptr;
        CHECK_REFUSED(std::apply(call, arguments), PELLICLE_INVALID_ARGUMENT, name);
    } else {
        CHECK_EQ(std::string(name), "");
    }
}

template <class Call, class Arguments, std::size_t... place>
void check_each(Call call, const Arguments &valid, const std::vector<const char *> &names, std::index_sequence<place...>) {
    (check_null<place>(call, valid, names[place]), ...);
}

// Calls a function with one pointer after another NULL. `names` has a name for every argument, which the message
// must contain; "" stands for what is no pointer, or may be NULL.
template <class... Parameters>
void check_nulls(PellicleStatus (*call)(Parameters...), const std::vector<const char *> &names,
                 const std::tuple<Parameters...> &valid) {
    REQUIRE_EQ(names.size(), sizeof...(Parameters));
    check_each(call, valid, names, std::index_sequence_for<Parameters...>());
}

// One output of each kind; at its end it checks that nothing was written.
struct Outputs {
    Untouched<PellicleModelInfo> model;
    Untouched<PellicleModelParam> param;
    Untouched<PellicleMediumInfo> medium;
    Untouched<PellicleFilmInfo> film_info;
    Untouched<PellicleFilmPlan> plan;
    Untouched<PellicleBsdfInfo> bsdf_info;
    Untouched<PellicleVaryingInfo> varying;
    Untouched<PellicleLobeInfo> lobe;
    Untouched<PellicleSample> sample;
    Untouched<PellicleSpectralSample> spectral_sample;
    Untouched<PellicleFilm *> film_handle;
    Untouched<PellicleBsdf *> bsdf_handle;
    Untouched<float[3]> rgb, other;
    Untouched<float> pdf, pdf_reverse;
    Untouched<std::size_t> size;
    Untouched<PellicleAmplitudes[3]> amplitudes;
};

// The functions below, which the last test compares with those of the header.
std::vector<std::pair<std::string, std::function<void()>>> all_calls(Outputs &outputs) {
    static const pellicle::Bsdf bsdf = lambert();
    static const PellicleFilm *const film = support::fixed_film().raw();
    static support::FilmDescription film_description;
    static const PellicleBsdfDesc bsdf_desc = [] {
        PellicleBsdfDesc desc{};
        desc.model = "lambert";
        return desc;
    }();
    static const float lambda_nm[3] = {450.0f, 550.0f, 650.0f};
    static const PellicleEvalBatchArgs eval_args{};
    static const PellicleSampleBatchArgs sample_args{};
    static const PellicleEvalSpectralBatchArgs eval_spectral_args{};
    static const PellicleSampleSpectralBatchArgs sample_spectral_args{};
    static const PellicleFilmBatchArgs film_args{};
    static const PellicleAmplitudesBatchArgs amplitudes_args{};
#define NULLS(function, names, ...) {#function, [&outputs] { check_nulls(pellicle_##function, names, {__VA_ARGS__}); }}
#define NAMES(...) {__VA_ARGS__}
    return {
        NULLS(model_info, NAMES("", "info", ""), 0, &outputs.model.output, sizeof outputs.model.output),
        NULLS(model_param, NAMES("", "", "info", ""), 0, 0, &outputs.param.output, sizeof outputs.param.output),
        NULLS(medium_info, NAMES("", "info", ""), 0, &outputs.medium.output, sizeof outputs.medium.output),
        NULLS(film_create, NAMES("desc", "", "film"), &film_description.raw(), sizeof film_description.desc,
              &outputs.film_handle.output),
        NULLS(film_info, NAMES("film", "info", ""), film, &outputs.film_info.output, sizeof outputs.film_info.output),
        NULLS(film_plan, NAMES("film", "plan", ""), film, &outputs.plan.output, sizeof outputs.plan.output),
        NULLS(film_save, NAMES("film", "", "", "size"), film, nullptr, 0, &outputs.size.output),
        NULLS(film_load, NAMES("block", "", "film"), up, sizeof up, &outputs.film_handle.output),
        NULLS(film_reflectance, NAMES("film", "", "", "rgb"), film, 1.0f, 0.0f, outputs.rgb.output),
        NULLS(film_eval, NAMES("film", "", "", "", "", ""), film, 1.0f, 0.0f, PELLICLE_SIDE_AMBIENT, outputs.rgb.output,
              outputs.other.output),
        NULLS(film_reflectance_spread, NAMES("film", "", "", "", "rgb"), film, 1.0f, 0.0f, 0.0f, outputs.rgb.output),
        NULLS(film_eval_spread, NAMES("film", "", "", "", "", "", ""), film, 1.0f, 0.0f, 0.0f, PELLICLE_SIDE_AMBIENT,
              outputs.rgb.output, outputs.other.output),
        NULLS(film_reference, NAMES("film", "", "", "rgb"), film, 1.0f, 0.0f, outputs.rgb.output),
        NULLS(film_spectrum, NAMES("film", "", "", "lambda_nm", "", "reflectance"), film, 1.0f, 0.0f, lambda_nm, 3,
              outputs.rgb.output),
        NULLS(film_spectrum_eval, NAMES("film", "", "", "", "lambda_nm", "", "", ""), film, 1.0f, 0.0f,
              PELLICLE_SIDE_AMBIENT, lambda_nm, 3, outputs.rgb.output, outputs.other.output),
        NULLS(film_amplitudes, NAMES("film", "", "", "", "lambda_nm", "", "amplitudes"), film, 1.0f, 0.0f,
              PELLICLE_SIDE_AMBIENT, lambda_nm, 3, outputs.amplitudes.output),
        NULLS(film_amplitudes_batch, NAMES("film", "args", ""), film, &amplitudes_args, sizeof amplitudes_args),
        NULLS(film_reflectance_batch, NAMES("film", "args", ""), film, &film_args, sizeof film_args),
        NULLS(bsdf_create, NAMES("desc", "", "bsdf"), &bsdf_desc, sizeof bsdf_desc, &outputs.bsdf_handle.output),
        NULLS(bsdf_info, NAMES("bsdf", "info", ""), bsdf.raw(), &outputs.bsdf_info.output, sizeof outputs.bsdf_info.output),
        NULLS(bsdf_varying, NAMES("bsdf", "", "info", ""), bsdf.raw(), 0, &outputs.varying.output, sizeof outputs.varying.output),
        NULLS(bsdf_lobe, NAMES("bsdf", "", "info", ""), bsdf.raw(), 0, &outputs.lobe.output, sizeof outputs.lobe.output),
        NULLS(bsdf_eval, NAMES("bsdf", "wo", "wi", "", "", "", "", ""), bsdf.raw(), up, up, nullptr, nullptr,
              outputs.rgb.output, &outputs.pdf.output, &outputs.pdf_reverse.output),
        NULLS(bsdf_sample, NAMES("bsdf", "wo", "u", "", "", "sample", ""), bsdf.raw(), up, u, nullptr, nullptr,
              &outputs.sample.output, sizeof outputs.sample.output),
        NULLS(bsdf_albedo, NAMES("bsdf", "wo", "", "", "albedo"), bsdf.raw(), up, nullptr, nullptr, outputs.rgb.output),
        NULLS(bsdf_eval_batch, NAMES("bsdf", "args", ""), bsdf.raw(), &eval_args, sizeof eval_args),
        NULLS(bsdf_sample_batch, NAMES("bsdf", "args", ""), bsdf.raw(), &sample_args, sizeof sample_args),
        NULLS(bsdf_eval_spectral, NAMES("bsdf", "wo", "wi", "", "", "lambda_nm", "", "", ""), bsdf.raw(), up, up, nullptr,
              nullptr, lambda_nm, 3, outputs.rgb.output, outputs.other.output),
        NULLS(bsdf_sample_spectral, NAMES("bsdf", "wo", "u", "", "", "lambda_nm", "", "", "", "", "sample", ""), bsdf.raw(),
              up, u, nullptr, nullptr, lambda_nm, 3, 0, outputs.rgb.output, outputs.other.output,
              &outputs.spectral_sample.output, sizeof outputs.spectral_sample.output),
        NULLS(bsdf_eval_spectral_batch, NAMES("bsdf", "args", ""), bsdf.raw(), &eval_spectral_args,
              sizeof eval_spectral_args),
        NULLS(bsdf_sample_spectral_batch, NAMES("bsdf", "args", ""), bsdf.raw(), &sample_spectral_args,
              sizeof sample_spectral_args),
    };
#undef NULLS
#undef NAMES
}

PellicleStatus create(const PellicleBsdfDesc &desc) {
    Untouched<PellicleBsdf *> bsdf;
    return pellicle_bsdf_create(&desc, sizeof desc, &bsdf.output);
}

} // namespace

TEST_CASE("null: every function refuses every missing pointer by name") {
    Outputs outputs;
    for (const auto &[name, check] : all_calls(outputs)) {
        CAPTURE(name);
        check();
    }
}

TEST_CASE("null: every function of the header that returns a status is in the list above") {
    std::set<std::string> tried, declared;
    Outputs outputs;
    for (const auto &[name, check] : all_calls(outputs)) tried.insert(name);
#define FUNCTION(name)                                                                                       \
    if (std::is_same_v<decltype(support::result_of(&pellicle_##name)), PellicleStatus>) declared.insert(#name);
#include "functions.inc"
#undef FUNCTION
    CHECK_EQ(tried, declared);
}

TEST_CASE("null: retain and release take it as nothing to do") {
    pellicle_bsdf_retain(nullptr);
    pellicle_bsdf_release(nullptr);
    pellicle_film_retain(nullptr);
    pellicle_film_release(nullptr);
}

TEST_CASE("null: all outputs missing are refused, any of them alone does not change the others") {
    const auto bsdf = lambert();
    const float slanted[3] = {0.0f, 0.6f, 0.8f};
    CHECK_REFUSED(pellicle_bsdf_eval(bsdf.raw(), up, up, nullptr, nullptr, nullptr, nullptr, nullptr),
                  PELLICLE_INVALID_ARGUMENT, "value");
    float value[3], pdf, reverse;
    REQUIRE_EQ(pellicle_bsdf_eval(bsdf.raw(), up, slanted, nullptr, nullptr, value, &pdf, &reverse), PELLICLE_OK);
    for (int wanted = 1; wanted < 8; ++wanted) {
        CAPTURE(wanted);
        float some_value[3], some_pdf, some_reverse;
        REQUIRE_EQ(pellicle_bsdf_eval(bsdf.raw(), up, slanted, nullptr, nullptr, wanted & 1 ? some_value : nullptr,
                                      wanted & 2 ? &some_pdf : nullptr, wanted & 4 ? &some_reverse : nullptr),
                   PELLICLE_OK);
        if (wanted & 1) CHECK(support::same_bits(some_value, value, 3));
        if (wanted & 2) CHECK_EQ(some_pdf, pdf);
        if (wanted & 4) CHECK_EQ(some_reverse, reverse);
    }

    const pellicle::Film &film = support::fixed_film();
    CHECK_REFUSED(pellicle_film_eval(film.raw(), 1.0f, 0.0f, PELLICLE_SIDE_AMBIENT, nullptr, nullptr),
                  PELLICLE_INVALID_ARGUMENT, "reflectance");
    for (const std::uint32_t side : {PELLICLE_SIDE_AMBIENT, PELLICLE_SIDE_BASE}) {
        const pellicle::FilmColors both = film.eval(0.5f, 0.0f, side);
        float reflectance[3], transmittance[3];
        CHECK_EQ(pellicle_film_eval(film.raw(), 0.5f, 0.0f, side, reflectance, nullptr), PELLICLE_OK);
        CHECK_EQ(pellicle_film_eval(film.raw(), 0.5f, 0.0f, side, nullptr, transmittance), PELLICLE_OK);
        CHECK(support::same_bits(reflectance, both.reflectance.data(), 3));
        CHECK(support::same_bits(transmittance, both.transmittance.data(), 3));
    }
    CHECK_EQ(pellicle_film_spectrum(film.raw(), 1.0f, 0.0f, nullptr, 0, nullptr), PELLICLE_OK);
    CHECK_EQ(pellicle_film_amplitudes(film.raw(), 1.0f, 0.0f, PELLICLE_SIDE_BASE, nullptr, 0, nullptr), PELLICLE_OK);

    const float nm[2] = {450.0f, 550.0f};
    CHECK_REFUSED(pellicle_film_spectrum_eval(film.raw(), 1.0f, 0.0f, PELLICLE_SIDE_BASE, nm, 2, nullptr, nullptr),
                  PELLICLE_INVALID_ARGUMENT, "reflectance");
    float both[4], alone[4];
    film.spectrum_eval(0.5f, 0.0f, PELLICLE_SIDE_BASE, nm, 2, both, both + 2);
    film.spectrum_eval(0.5f, 0.0f, PELLICLE_SIDE_BASE, nm, 2, alone, nullptr);
    film.spectrum_eval(0.5f, 0.0f, PELLICLE_SIDE_BASE, nm, 2, nullptr, alone + 2);
    CHECK(support::same_bits(both, alone, 4));
}

TEST_CASE("null: create refuses every missing pointer of its description") {
    CHECK_REFUSED(create(PellicleBsdfDesc{}), PELLICLE_INVALID_ARGUMENT, "model");
    const float half = 0.5f;
    const PellicleParam nameless = {nullptr, &half, 1, nullptr}, valueless = {"reflectance", nullptr, 1, nullptr},
                        choiceless = {"variant", nullptr, 0, nullptr};
    const PellicleRange nameless_range = {nullptr, 0.0f, 1.0f};
    struct Case {
        const char *model;
        const PellicleParam *params;
        std::size_t param_count;
        const PellicleRange *varying;
        std::size_t varying_count;
        const char *words;
    };
    for (const Case &refused : {Case{"lambert", nullptr, 1, nullptr, 0, "params"},
                                Case{"lambert", &nameless, 1, nullptr, 0, "name"},
                                Case{"lambert", &valueless, 1, nullptr, 0, "values"},
                                Case{"lambert", nullptr, 0, nullptr, 1, "varying"},
                                Case{"lambert", nullptr, 0, &nameless_range, 1, "name"},
                                Case{"layered", &choiceless, 1, nullptr, 0, "variant"}}) {
        PellicleBsdfDesc desc{};
        desc.model = refused.model;
        desc.params = refused.params;
        desc.param_count = refused.param_count;
        desc.varying = refused.varying;
        desc.varying_count = refused.varying_count;
        CHECK_REFUSED(create(desc), PELLICLE_INVALID_ARGUMENT, refused.words);
    }
}

TEST_CASE("null: film create refuses every missing pointer of its description") {
    support::FilmDescription film;
    film.layers = {{support::medium(1.38f), 10.0f, 10.0f}};
    PellicleFilmDesc desc = film.raw();
    desc.layers = nullptr;
    CHECK_REFUSED(support::create_film(desc), PELLICLE_INVALID_ARGUMENT, "layers");
    desc = film.raw();
    desc.base = nullptr;
    CHECK_REFUSED(support::create_film(desc), PELLICLE_INVALID_ARGUMENT, "base");
    desc = film.raw();
    desc.ambient = nullptr; // vacuum
    CHECK_EQ(support::create_film(desc), PELLICLE_OK);
    const PellicleLayer without_medium = {nullptr, 10.0f, 10.0f};
    desc = film.raw();
    desc.layers = &without_medium;
    CHECK_REFUSED(support::create_film(desc), PELLICLE_INVALID_ARGUMENT, "layers[0].medium");

    const float numbers[2] = {500.0f, 600.0f};
    for (const float *PellicleMedium::*part :
         {&PellicleMedium::table_nm, &PellicleMedium::table_eta, &PellicleMedium::table_k}) {
        support::FilmDescription measured;
        measured.base = PellicleMedium{};
        measured.base.table_nm = measured.base.table_eta = measured.base.table_k = numbers;
        measured.base.table_count = 2;
        measured.base.*part = nullptr;
        CHECK_REFUSED(measured.create(), PELLICLE_INVALID_ARGUMENT, "base: table_");
    }
}

TEST_CASE("null: batches refuse every missing view but the outputs not wanted") {
    const auto bsdf = lambert();
    const PellicleFilm *film = support::varying_film().raw();
    const float number = 1.0f;
    Untouched<float[3]> output;
    PellicleEvalBatchArgs eval{};
    eval.count = 1;
    eval.wo = eval.wi = {up, 12, 4};
    eval.value = {output.output, 12, 4};
    PellicleSampleBatchArgs sample{};
    sample.count = 1;
    sample.wo = {up, 12, 4};
    sample.u = {u, 12, 4};
    sample.wi = {output.output, 12, 4};
    PellicleFilmBatchArgs reflectance{};
    reflectance.count = 1;
    reflectance.cos_theta = reflectance.thickness_nm = {&number, 4, 4};
    reflectance.reflectance = {output.output, 12, 4};

    const auto refuse_eval = [&](const char *words, auto change) {
        PellicleEvalBatchArgs args = eval;
        change(args);
        CHECK_REFUSED(pellicle_bsdf_eval_batch(bsdf.raw(), &args, sizeof args), PELLICLE_INVALID_ARGUMENT, words);
    };
    refuse_eval("wo", [](auto &args) { args.wo.data = nullptr; });
    refuse_eval("wi", [](auto &args) { args.wi.data = nullptr; });
    refuse_eval("value", [](auto &args) { args.value.data = nullptr; });
    refuse_eval("varying", [](auto &args) { args.varying_count = 1; });
    const auto refuse_sample = [&](const char *words, auto change) {
        PellicleSampleBatchArgs args = sample;
        change(args);
        CHECK_REFUSED(pellicle_bsdf_sample_batch(bsdf.raw(), &args, sizeof args), PELLICLE_INVALID_ARGUMENT, words);
    };
    refuse_sample("wo", [](auto &args) { args.wo.data = nullptr; });
    refuse_sample("u", [](auto &args) { args.u.data = nullptr; });
    refuse_sample("output", [](auto &args) { args.wi.data = nullptr; });
    refuse_sample("varying", [](auto &args) { args.varying_count = 1; });
    const auto refuse_film = [&](const char *words, auto change) {
        PellicleFilmBatchArgs args = reflectance;
        change(args);
        CHECK_REFUSED(pellicle_film_reflectance_batch(film, &args, sizeof args), PELLICLE_INVALID_ARGUMENT, words);
    };
    refuse_film("cos_theta", [](auto &args) { args.cos_theta.data = nullptr; });
    refuse_film("thickness_nm", [](auto &args) { args.thickness_nm.data = nullptr; });
    refuse_film("reflectance", [](auto &args) { args.reflectance.data = nullptr; });
    PellicleAmplitudesBatchArgs amplitudes{};
    amplitudes.count = amplitudes.lambda_count = 1;
    amplitudes.cos_theta = amplitudes.thickness_nm = amplitudes.lambda_nm = {&number, 4, 4};
    amplitudes.r_s = {output.output, 8, 4};
    const auto refuse_amplitudes = [&](const char *words, auto change) {
        PellicleAmplitudesBatchArgs args = amplitudes;
        change(args);
        CHECK_REFUSED(pellicle_film_amplitudes_batch(film, &args, sizeof args), PELLICLE_INVALID_ARGUMENT, words);
    };
    refuse_amplitudes("cos_theta", [](auto &args) { args.cos_theta.data = nullptr; });
    refuse_amplitudes("thickness_nm", [](auto &args) { args.thickness_nm.data = nullptr; });
    refuse_amplitudes("lambda_nm", [](auto &args) { args.lambda_nm.data = nullptr; });
    refuse_amplitudes("t_p", [](auto &args) { args.r_s.data = nullptr; });
    amplitudes.cos_theta.data = nullptr;
    amplitudes.lambda_count = 0;
    CHECK_EQ(pellicle_film_amplitudes_batch(film, &amplitudes, sizeof amplitudes), PELLICLE_OK);
    reflectance.thickness_nm.data = nullptr;
    reflectance.count = 0;
    CHECK_EQ(pellicle_film_reflectance_batch(film, &reflectance, sizeof reflectance), PELLICLE_OK);
}
