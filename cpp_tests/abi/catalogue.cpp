// What exists can be asked for: models, media, names, lobes, what varies and a film's range of thickness.
// Nobody has to parse a message.
#include "support.hpp"

#include <limits>
#include <set>

namespace {

using support::Untouched;

std::vector<std::string> names(std::uint32_t list) {
    std::vector<std::string> result;
    for (std::size_t i = 0; const char *name = pellicle_name(list, i); ++i) result.push_back(name);
    return result;
}

PellicleMediumInfo medium_info(std::size_t medium) {
    PellicleMediumInfo info{};
    REQUIRE_EQ(pellicle_medium_info(medium, &info, sizeof info), PELLICLE_OK);
    return info;
}

} // namespace

TEST_CASE("catalogue: a number beyond the last is refused with what it counts") {
    Untouched<PellicleModelInfo> model;
    Untouched<PellicleModelParam> param;
    Untouched<PellicleMediumInfo> medium;
    Untouched<PellicleVaryingInfo> varying;
    Untouched<PellicleLobeInfo> lobe;
    const auto bsdf = pellicle::BsdfBuilder("phong").vary("exponent", 1.0f, 9.0f).create();
    const std::size_t model_count = pellicle_model_count(), medium_count = pellicle_medium_count();
    const std::size_t param_count = support::models().front().params.size();
    for (const std::size_t beyond : {std::size_t{0}, SIZE_MAX - 1000}) {
        CAPTURE(beyond);
        CHECK_REFUSED(pellicle_model_info(model_count + beyond, &model.output, sizeof model.output),
                      PELLICLE_OUT_OF_RANGE, "model");
        CHECK_REFUSED(pellicle_model_param(model_count + beyond, 0, &param.output, sizeof param.output),
                      PELLICLE_OUT_OF_RANGE, "model");
        CHECK_REFUSED(pellicle_model_param(0, param_count + beyond, &param.output, sizeof param.output),
                      PELLICLE_OUT_OF_RANGE, "param");
        CHECK_REFUSED(pellicle_medium_info(medium_count + beyond, &medium.output, sizeof medium.output),
                      PELLICLE_OUT_OF_RANGE, "medium");
        CHECK_REFUSED(pellicle_bsdf_varying(bsdf.raw(), 1 + beyond, &varying.output, sizeof varying.output),
                      PELLICLE_OUT_OF_RANGE, "varying");
        CHECK_REFUSED(pellicle_bsdf_lobe(bsdf.raw(), bsdf.info().lobe_count + beyond, &lobe.output, sizeof lobe.output),
                      PELLICLE_OUT_OF_RANGE, "lobe");
    }
}

TEST_CASE("catalogue: no text that the library returns is missing") {
    CHECK((pellicle_last_error() != nullptr));
    CHECK_FALSE(std::string(pellicle_version_string()).empty());
    for (PellicleStatus status = -2; status < 20; ++status)
        CHECK_FALSE(std::string(pellicle_status_string(status)).empty());
    for (const support::Model &model : support::models()) {
        for (const char *text : {model.info.name, model.info.summary, model.info.source})
            CHECK_FALSE(std::string(text).empty());
        for (const PellicleModelParam &param : model.params) {
            CHECK_FALSE(std::string(param.name).empty());
            CHECK_FALSE(std::string(param.summary).empty());
            CHECK((param.unit != nullptr));
            CHECK_EQ(param.choices != nullptr, param.kind == PELLICLE_KIND_CHOICE);
            for (std::uint32_t i = 0; i < param.choice_count; ++i) CHECK_FALSE(std::string(param.choices[i]).empty());
            if (param.choices) CHECK_EQ(param.choices[param.choice_count], nullptr);
        }
    }
}

// Silver, fused silica and water are what textbooks say: the list itself is compared with nothing of its own.
TEST_CASE("catalogue: every medium can be created by each of its names, and absorbs if it says so") {
    std::set<std::string> seen;
    for (std::size_t i = 0; i < pellicle_medium_count(); ++i) {
        const PellicleMediumInfo info = medium_info(i);
        CAPTURE(std::string(info.name));
        CHECK_FALSE(std::string(info.source).empty());
        // Vacuum is known at every wavelength.
        CHECK_EQ(info.lambda_min_nm == 0.0f, std::string(info.name) == "vacuum");
        CHECK_EQ(info.lambda_max_nm == std::numeric_limits<float>::infinity(), std::string(info.name) == "vacuum");
        CHECK_LT(info.lambda_min_nm, info.lambda_max_nm);
        std::vector<std::string> all = {info.name};
        for (const char *const *also = info.also; *also; ++also) all.push_back(*also);
        for (const std::string &name : all) {
            CHECK(seen.insert(name).second);
            // An ambient must not absorb: who is refused there absorbs.
            support::FilmDescription film;
            film.ambient = support::medium(name.c_str());
            film.desc.method = "reference";
            CHECK_EQ(film.create(), info.absorbs ? PELLICLE_OUT_OF_RANGE : PELLICLE_OK);
        }
    }
    for (const char *name : {"Au", "gold", "Ag", "SiO2", "water", "H2O", "BK7", "glass"}) CHECK(seen.count(name) == 1);
}

TEST_CASE("catalogue: outside the range of its data a medium is refused, or constant if that is allowed") {
    for (std::size_t i = 0; i < pellicle_medium_count(); ++i) {
        const PellicleMediumInfo info = medium_info(i);
        if (std::string(info.name) == "vacuum") continue;
        CAPTURE(std::string(info.name));
        support::FilmDescription film;
        film.base = support::medium(info.name);
        film.desc.method = "reference";
        const pellicle::Film strict(film.raw());
        CHECK_EQ(strict.info().lambda_min_nm, info.lambda_min_nm);
        CHECK_EQ(strict.info().lambda_max_nm, info.lambda_max_nm);
        const float ends[2] = {info.lambda_min_nm, info.lambda_max_nm};
        float at_ends[2];
        CHECK_EQ(pellicle_film_spectrum(strict.raw(), 1.0f, 0.0f, ends, 2, at_ends), PELLICLE_OK);
        for (const float outside : {0.999f * info.lambda_min_nm, 1.001f * info.lambda_max_nm}) {
            const float lambda_nm[2] = {info.lambda_min_nm, outside};
            support::Untouched<float[2]> untouched;
            CHECK_REFUSED(pellicle_film_spectrum(strict.raw(), 1.0f, 0.0f, lambda_nm, 2, untouched.output),
                          PELLICLE_OUT_OF_RANGE, "lambda_nm[1]");
            for (const char *word : {"base", "extrapolate"}) CHECK(support::message_has(word));
        }
        film.desc.extrapolate = 1;
        const pellicle::Film bare(film.raw());
        const float nm[4] = {info.lambda_min_nm, 0.9f * info.lambda_min_nm, info.lambda_max_nm, 1.1f * info.lambda_max_nm};
        float reflectance[4];
        bare.spectrum(1.0f, 0.0f, nm, 4, reflectance);
        CHECK_EQ(reflectance[0], doctest::Approx(reflectance[1]).epsilon(1e-6));
        CHECK_EQ(reflectance[2], doctest::Approx(reflectance[3]).epsilon(1e-6));
    }
}

TEST_CASE("catalogue: the names of every list are accepted, and the first space and white are the defaults") {
    CHECK_EQ(names(PELLICLE_NAMES_COLOR_SPACE), std::vector<std::string>{"rec709", "rec2020", "acescg", "xyz"});
    CHECK_EQ(names(PELLICLE_NAMES_WHITE), std::vector<std::string>{"E", "D65"});
    const std::vector<std::string> methods = names(PELLICLE_NAMES_METHOD);
    CHECK_GE(methods.size(), 10u);
    for (const std::string &method : methods) {
        CAPTURE(method);
        support::FilmDescription film;
        film.layers = {{support::medium("water"), 0.0f, 300.0f}};
        film.desc.method = method.c_str();
        film.desc.tolerance = 1.0f;
        // Some take a bare base only; an unknown name would be UNKNOWN_NAME.
        const PellicleStatus status = film.create();
        CHECK((status == PELLICLE_OK || status == PELLICLE_UNSUPPORTED));
    }
    CHECK(names(4).empty());
    CHECK(names(UINT32_MAX).empty());
}

TEST_CASE("simd_level: every level of this processor gives the same numbers, and the plan names it") {
    const std::vector<std::string> levels = names(PELLICLE_NAMES_SIMD_LEVEL);
    REQUIRE_FALSE(levels.empty());
    std::mt19937 random(5);
    std::vector<support::Vec3> wo, wi;
    for (int i = 0; i < 100; ++i) {
        wo.push_back(support::random_direction(random));
        wi.push_back(support::random_direction(random));
    }
    std::vector<support::Vec3> expected;
    for (const std::string &level : levels) {
        CAPTURE(level);
        const auto bsdf = pellicle::BsdfBuilder("microfacet").simd_level(level).create();
        CHECK_NE(std::string(bsdf.info().plan).find("batches by " + level), std::string::npos);
        std::vector<support::Vec3> values(100);
        PellicleEvalBatchArgs args{};
        args.count = values.size();
        args.wo = {wo[0].data(), 12, 4};
        args.wi = {wi[0].data(), 12, 4};
        args.value = {values[0].data(), 12, 4};
        bsdf.eval_batch(args);
        if (expected.empty()) expected = values;
        for (std::size_t i = 0; i < values.size(); ++i)
            CHECK(support::same_bits(values[i].data(), expected[i].data(), 3));
    }
    const auto widest = pellicle::BsdfBuilder("microfacet").create();
    CHECK_NE(std::string(widest.info().plan).find("batches by " + levels.back()), std::string::npos);
}

TEST_CASE("simd_level: unknown ones and those of other processors are refused with this processor's") {
    support::FilmDescription film;
    PellicleBsdfDesc desc{};
    desc.model = "lambert";
    support::Untouched<PellicleBsdf *> bsdf;
    const auto refuse = [&](const char *level, PellicleStatus status, const std::string &words) {
        desc.simd_level = film.desc.simd_level = level;
        CHECK_REFUSED(pellicle_bsdf_create(&desc, sizeof desc, &bsdf.output), status, words);
        CHECK_REFUSED(film.create(), status, words);
        CHECK(support::message_has("simd_level"));
    };
    refuse("", PELLICLE_UNKNOWN_NAME, names(PELLICLE_NAMES_SIMD_LEVEL).front());
    refuse("avx9", PELLICLE_UNKNOWN_NAME, names(PELLICLE_NAMES_SIMD_LEVEL).front());
    refuse("\xff\xfe", PELLICLE_INVALID_ARGUMENT, "UTF-8");
#if defined(__x86_64__)
    refuse("neon", PELLICLE_UNKNOWN_NAME, names(PELLICLE_NAMES_SIMD_LEVEL).front());
#elif defined(__aarch64__)
    refuse("avx2", PELLICLE_UNKNOWN_NAME, names(PELLICLE_NAMES_SIMD_LEVEL).front());
#endif
}

TEST_CASE("lobes: a BSDF has as many as it says, and their flags together are its own") {
    for (const support::Model &model : support::models_with_and_without_film()) {
        CAPTURE(std::string(model.info.name));
        const pellicle::Bsdf bsdf = support::builder(model).create();
        std::uint32_t flags = 0;
        for (std::uint32_t i = 0; i < bsdf.info().lobe_count; ++i) {
            const PellicleLobeInfo lobe = bsdf.lobe(i);
            CHECK_FALSE(std::string(lobe.name).empty());
            flags |= lobe.flags;
        }
        CHECK_EQ(flags, bsdf.info().flags);
    }
}

TEST_CASE("lobes: a sample's flags are those of the lobe that it names") {
    std::mt19937 random(6);
    for (const support::Model &model : support::models_with_and_without_film()) {
        CAPTURE(std::string(model.info.name));
        const pellicle::Bsdf bsdf = support::builder(model).create();
        for (int i = 0; i < 100; ++i) {
            const PellicleSample sample = bsdf.sample(support::random_direction(random), support::random_uniforms(random));
            if (sample.flags != 0) CHECK_EQ(sample.flags, bsdf.lobe(sample.lobe).flags);
        }
    }
}

TEST_CASE("varying: a BSDF tells names, order, ranges, units and defaults of what varies") {
    const auto bsdf = pellicle::BsdfBuilder("layered")
                          .set("base", {0.1f, 0.2f, 0.3f})
                          .vary("base", 0.0f, 0.5f)
                          .vary("base_normal", 0.0f, 0.0f)
                          .vary("thickness_nm", 66.0f, 76.0f)
                          .create();
    REQUIRE_EQ(bsdf.info().varying_count, 3);
    const PellicleVaryingInfo base = bsdf.varying(0), normal = bsdf.varying(1), thickness = bsdf.varying(2);
    CHECK_EQ(std::string(base.name), "base");
    CHECK_EQ(base.kind, PELLICLE_KIND_NUMBER);
    CHECK_EQ(base.components, 3);
    CHECK_EQ(base.offset, 0);
    CHECK_EQ(base.max, 0.5f);
    CHECK_EQ(base.default_value[2], 0.3f);
    CHECK_EQ(std::string(normal.name), "base_normal");
    CHECK_EQ(normal.kind, PELLICLE_KIND_DIRECTION);
    CHECK_EQ(normal.offset, 3);
    CHECK_EQ(normal.default_value[2], 1.0f);
    CHECK_EQ(std::string(thickness.name), "thickness_nm");
    CHECK_EQ(std::string(thickness.unit), "nm");
    CHECK_EQ(thickness.components, 1);
    CHECK_EQ(thickness.offset, 6);
    CHECK_EQ(thickness.min, 66.0f);
    CHECK_EQ(thickness.max, 76.0f);
    CHECK_EQ(bsdf.info().varying_floats, 7);
}

// The default thickness of 300 nm lies above the range, the default reflectance within it.
TEST_CASE("varying: what a call does not give has its value in params, else the model's default within the range") {
    const support::Vec3 wo = {0.0f, 0.6f, 0.8f}, wi = {0.0f, -0.6f, 0.8f};
    const auto layered = pellicle::BsdfBuilder("layered").vary("thickness_nm", 66.0f, 76.0f).create();
    CHECK_EQ(layered.varying(0).default_value[0], 76.0f);
    const float greatest_nm = 76.0f;
    CHECK(support::same_bits(layered.value(wo, wi).data(), layered.value(wo, wi, &greatest_nm).data(), 3));
    const auto lambert = pellicle::BsdfBuilder("lambert").vary("reflectance", 0.0f, 1.0f).create();
    CHECK_EQ(lambert.varying(0).default_value[1], 0.5f);
    for (const support::Model &model : support::models_with_and_without_film()) {
        CAPTURE(std::string(model.info.name));
        const support::Varying subject(model);
        std::vector<float> values;
        for (std::size_t i = 0; i < subject.components().size(); ++i) {
            const PellicleVaryingInfo info = subject.bsdf().varying(i);
            REQUIRE_EQ(info.offset, values.size());
            values.insert(values.end(), info.default_value, info.default_value + info.components);
        }
        CHECK(support::same_bits(subject.bsdf().value(wo, wi).data(), subject.bsdf().value(wo, wi, values.data()).data(), 3));
    }
}

TEST_CASE("film info: the range of thickness, and whether it keeps its transmittance") {
    const PellicleFilmInfo varying = support::varying_film().info(), fixed = support::fixed_film().info();
    CHECK_EQ(varying.varies, 1);
    CHECK_EQ(varying.thickness_min_nm, 0.0f);
    CHECK_EQ(varying.thickness_max_nm, support::varying_film_max_nm);
    CHECK_EQ(varying.transmittance, 1);
    CHECK_EQ(fixed.varies, 0);
    CHECK_EQ(fixed.thickness_max_nm, 0.0f);
    CHECK_EQ(pellicle::FilmBuilder("BK7").create().info().transmittance, 0);
}

TEST_CASE("film info: whether the base is opaque, and its attenuation, by k or as the description says") {
    const auto info = [](float k, std::uint32_t base_opaque) {
        support::FilmDescription film;
        film.base = support::medium(1.5f, k);
        film.desc.base_opaque = base_opaque;
        film.desc.transmittance = 1;
        const pellicle::Film created(film.raw());
        const pellicle::Bsdf bsdf = pellicle::BsdfBuilder("film").film(created).create();
        const bool is_opaque = created.info().base_opaque == 1;
        CHECK_EQ((bsdf.info().flags & PELLICLE_TRANSMISSION) == 0, is_opaque);
        const auto from_base = created.eval(0.9f, 0.0f, PELLICLE_SIDE_BASE);
        CHECK_EQ(from_base.transmittance[1] == 0.0f, is_opaque);
        // From the ambient's side nothing depends on it.
        CHECK_GT(created.eval(0.9f, 0.0f).transmittance[1], 0.95f);
        return created.info();
    };
    for (const float k : {0.0f, 1e-12f, 1e-6f, 1e-3f}) {
        CHECK_EQ(info(k, PELLICLE_BASE_BY_K).base_opaque, 0);
        CHECK_EQ(info(k, PELLICLE_BASE_OPAQUE).base_opaque, 1);
    }
    for (const float k : {1.001e-3f, 0.1f}) {
        CHECK_EQ(info(k, PELLICLE_BASE_BY_K).base_opaque, 1);
        CHECK_EQ(info(k, PELLICLE_BASE_TRANSPARENT).base_opaque, 0);
    }
    // 4 pi k / lambda: 22.8 per mm at 550 nm.
    const PellicleFilmInfo tinted = info(1e-3f, PELLICLE_BASE_BY_K);
    CHECK_EQ(tinted.base_attenuation_per_mm[1], doctest::Approx(22.8).epsilon(0.04));
    CHECK_LT(tinted.base_attenuation_per_mm[0], tinted.base_attenuation_per_mm[1]);
    CHECK_GT(tinted.base_attenuation_per_mm[2], tinted.base_attenuation_per_mm[1]);
    CHECK_EQ(info(0.0f, PELLICLE_BASE_BY_K).base_attenuation_per_mm[1], 0.0f);
}
