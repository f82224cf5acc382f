// Every pointer of every function, NULL one at a time: refused by name, with the outputs untouched.
#include "support.hpp"

namespace {

using support::Untouched;

const float up[3] = {0.0f, 0.0f, 1.0f};
const float u[3] = {0.3f, 0.6f, 0.9f};

pellicle::Bsdf lambert() {
    return pellicle::BsdfBuilder("lambert").create();
}

PellicleStatus create(const PellicleBsdfDesc &desc) {
    Untouched<PellicleBsdf *> bsdf;
    return pellicle_bsdf_create(&desc, sizeof desc, &bsdf.output);
}

} // namespace

TEST_CASE("null: introspection refuses a missing output and an index that does not exist") {
    CHECK_REFUSED(pellicle_model_info(0, nullptr, sizeof(PellicleModelInfo)), PELLICLE_INVALID_ARGUMENT, "info");
    CHECK_REFUSED(pellicle_model_param(0, 0, nullptr, sizeof(PellicleModelParam)), PELLICLE_INVALID_ARGUMENT, "info");

    const std::size_t model_count = pellicle_model_count();
    const std::size_t param_count = support::models().front().params.size();
    Untouched<PellicleModelInfo> model;
    Untouched<PellicleModelParam> param;
    for (const std::size_t beyond : {std::size_t{0}, SIZE_MAX - model_count - param_count}) {
        CHECK_REFUSED(pellicle_model_info(model_count + beyond, &model.output, sizeof model.output),
                      PELLICLE_OUT_OF_RANGE, "model");
        CHECK_REFUSED(pellicle_model_param(model_count + beyond, 0, &param.output, sizeof param.output),
                      PELLICLE_OUT_OF_RANGE, "model");
        CHECK_REFUSED(pellicle_model_param(0, param_count + beyond, &param.output, sizeof param.output),
                      PELLICLE_OUT_OF_RANGE, "param");
    }
}

TEST_CASE("null: create refuses every missing pointer of its description") {
    Untouched<PellicleBsdf *> bsdf;
    PellicleBsdfDesc lambert{};
    lambert.model = "lambert";
    CHECK_REFUSED(pellicle_bsdf_create(nullptr, sizeof lambert, &bsdf.output), PELLICLE_INVALID_ARGUMENT, "desc");
    CHECK_REFUSED(pellicle_bsdf_create(&lambert, sizeof lambert, nullptr), PELLICLE_INVALID_ARGUMENT, "bsdf");
    CHECK_REFUSED(create(PellicleBsdfDesc{}), PELLICLE_INVALID_ARGUMENT, "model");

    PellicleBsdfDesc desc = lambert;
    desc.param_count = 1;
    CHECK_REFUSED(create(desc), PELLICLE_INVALID_ARGUMENT, "params");

    const float half = 0.5f;
    const PellicleParam nameless = {nullptr, &half, 1, nullptr};
    desc.params = &nameless;
    CHECK_REFUSED(create(desc), PELLICLE_INVALID_ARGUMENT, "name");

    const PellicleParam valueless = {"reflectance", nullptr, 1, nullptr};
    desc.params = &valueless;
    CHECK_REFUSED(create(desc), PELLICLE_INVALID_ARGUMENT, "values");

    PellicleBsdfDesc varying = lambert;
    varying.varying_count = 1;
    CHECK_REFUSED(create(varying), PELLICLE_INVALID_ARGUMENT, "varying");

    const PellicleRange nameless_range = {nullptr, 0.0f, 1.0f};
    varying.varying = &nameless_range;
    CHECK_REFUSED(create(varying), PELLICLE_INVALID_ARGUMENT, "name");

    PellicleBsdfDesc layered{};
    layered.model = "layered";
    const PellicleParam choiceless = {"variant", nullptr, 0, nullptr};
    layered.params = &choiceless;
    layered.param_count = 1;
    CHECK_REFUSED(create(layered), PELLICLE_INVALID_ARGUMENT, "variant");
}

TEST_CASE("null: retain refuses it, release takes it as nothing to do") {
    CHECK_REFUSED(pellicle_bsdf_retain(nullptr), PELLICLE_INVALID_ARGUMENT, "bsdf");
    pellicle_bsdf_release(nullptr);
}

TEST_CASE("null: info refuses every missing pointer") {
    const auto bsdf = lambert();
    Untouched<PellicleBsdfInfo> info;
    CHECK_REFUSED(pellicle_bsdf_info(nullptr, &info.output, sizeof info.output), PELLICLE_INVALID_ARGUMENT, "bsdf");
    CHECK_REFUSED(pellicle_bsdf_info(bsdf.raw(), nullptr, sizeof info.output), PELLICLE_INVALID_ARGUMENT, "info");
}

TEST_CASE("null: eval refuses every missing pointer but one output and the varying values") {
    const auto bsdf = lambert();
    Untouched<float[3]> value;
    Untouched<float> pdf;
    CHECK_REFUSED(pellicle_bsdf_eval(nullptr, up, up, nullptr, value.output, &pdf.output), PELLICLE_INVALID_ARGUMENT,
                  "bsdf");
    CHECK_REFUSED(pellicle_bsdf_eval(bsdf.raw(), nullptr, up, nullptr, value.output, &pdf.output),
                  PELLICLE_INVALID_ARGUMENT, "wo");
    CHECK_REFUSED(pellicle_bsdf_eval(bsdf.raw(), up, nullptr, nullptr, value.output, &pdf.output),
                  PELLICLE_INVALID_ARGUMENT, "wi");
    CHECK_REFUSED(pellicle_bsdf_eval(bsdf.raw(), up, up, nullptr, nullptr, nullptr), PELLICLE_INVALID_ARGUMENT,
                  "value");
}

TEST_CASE("null: either output of eval may be missing, and the other does not change for it") {
    const auto bsdf = lambert();
    const auto both = bsdf.eval(up, up);
    CHECK(support::same_bits(bsdf.value(up, up).data(), both.value.data(), 3));
    CHECK_EQ(bsdf.pdf(up, up), both.pdf);
}

TEST_CASE("null: sample refuses every missing pointer") {
    const auto bsdf = lambert();
    Untouched<PellicleSample> sample;
    const std::size_t size = sizeof sample.output;
    CHECK_REFUSED(pellicle_bsdf_sample(nullptr, up, u, nullptr, &sample.output, size), PELLICLE_INVALID_ARGUMENT,
                  "bsdf");
    CHECK_REFUSED(pellicle_bsdf_sample(bsdf.raw(), nullptr, u, nullptr, &sample.output, size),
                  PELLICLE_INVALID_ARGUMENT, "wo");
    CHECK_REFUSED(pellicle_bsdf_sample(bsdf.raw(), up, nullptr, nullptr, &sample.output, size),
                  PELLICLE_INVALID_ARGUMENT, "u");
    CHECK_REFUSED(pellicle_bsdf_sample(bsdf.raw(), up, u, nullptr, nullptr, size), PELLICLE_INVALID_ARGUMENT,
                  "sample");
}

TEST_CASE("null: albedo refuses every missing pointer") {
    const auto bsdf = lambert();
    Untouched<float[3]> albedo;
    CHECK_REFUSED(pellicle_bsdf_albedo(nullptr, up, nullptr, albedo.output), PELLICLE_INVALID_ARGUMENT, "bsdf");
    CHECK_REFUSED(pellicle_bsdf_albedo(bsdf.raw(), nullptr, nullptr, albedo.output), PELLICLE_INVALID_ARGUMENT, "wo");
    CHECK_REFUSED(pellicle_bsdf_albedo(bsdf.raw(), up, nullptr, nullptr), PELLICLE_INVALID_ARGUMENT, "albedo");
}

TEST_CASE("null: eval_batch refuses every missing pointer but the outputs not wanted") {
    const auto bsdf = lambert();
    Untouched<float[3]> value;
    Untouched<float> pdf;
    PellicleEvalBatchArgs args{};
    args.count = 1;
    args.wo = args.wi = {up, 12, 4};
    args.value = {value.output, 12, 4};
    args.pdf = {&pdf.output, 4, 4};
    const auto call = [&](const PellicleEvalBatchArgs &changed) {
        return pellicle_bsdf_eval_batch(bsdf.raw(), &changed, sizeof changed);
    };
    CHECK_REFUSED(pellicle_bsdf_eval_batch(nullptr, &args, sizeof args), PELLICLE_INVALID_ARGUMENT, "bsdf");
    CHECK_REFUSED(pellicle_bsdf_eval_batch(bsdf.raw(), nullptr, sizeof args), PELLICLE_INVALID_ARGUMENT, "args");

    PellicleEvalBatchArgs changed = args;
    changed.wo.data = nullptr;
    CHECK_REFUSED(call(changed), PELLICLE_INVALID_ARGUMENT, "wo");
    changed = args;
    changed.wi.data = nullptr;
    CHECK_REFUSED(call(changed), PELLICLE_INVALID_ARGUMENT, "wi");
    changed = args;
    changed.value.data = changed.pdf.data = nullptr;
    CHECK_REFUSED(call(changed), PELLICLE_INVALID_ARGUMENT, "value");
    changed = args;
    changed.varying_count = 1;
    CHECK_REFUSED(call(changed), PELLICLE_INVALID_ARGUMENT, "varying");
}

TEST_CASE("null: sample_batch refuses every missing pointer but the outputs not wanted") {
    const auto bsdf = lambert();
    Untouched<float[3]> wi;
    PellicleSampleBatchArgs args{};
    args.count = 1;
    args.wo = {up, 12, 4};
    args.u = {u, 12, 4};
    args.wi = {wi.output, 12, 4};
    const auto call = [&](const PellicleSampleBatchArgs &changed) {
        return pellicle_bsdf_sample_batch(bsdf.raw(), &changed, sizeof changed);
    };
    CHECK_REFUSED(pellicle_bsdf_sample_batch(nullptr, &args, sizeof args), PELLICLE_INVALID_ARGUMENT, "bsdf");
    CHECK_REFUSED(pellicle_bsdf_sample_batch(bsdf.raw(), nullptr, sizeof args), PELLICLE_INVALID_ARGUMENT, "args");

    PellicleSampleBatchArgs changed = args;
    changed.wo.data = nullptr;
    CHECK_REFUSED(call(changed), PELLICLE_INVALID_ARGUMENT, "wo");
    changed = args;
    changed.u.data = nullptr;
    CHECK_REFUSED(call(changed), PELLICLE_INVALID_ARGUMENT, "u");
    changed = args;
    changed.varying_count = 1;
    CHECK_REFUSED(call(changed), PELLICLE_INVALID_ARGUMENT, "varying");
}

TEST_CASE("null: film create refuses every missing pointer of its description") {
    Untouched<PellicleFilm *> film;
    PellicleFilmDesc glass{};
    glass.base = support::medium(1.5f);
    CHECK_REFUSED(pellicle_film_create(nullptr, sizeof glass, &film.output), PELLICLE_INVALID_ARGUMENT, "desc");
    CHECK_REFUSED(pellicle_film_create(&glass, sizeof glass, nullptr), PELLICLE_INVALID_ARGUMENT, "film");

    PellicleFilmDesc desc = glass;
    desc.layer_count = 1;
    CHECK_REFUSED(pellicle_film_create(&desc, sizeof desc, &film.output), PELLICLE_INVALID_ARGUMENT, "layers");

    const float numbers[2] = {500.0f, 600.0f};
    for (const float *PellicleMedium::*part :
         {&PellicleMedium::table_nm, &PellicleMedium::table_eta, &PellicleMedium::table_k}) {
        desc = PellicleFilmDesc{};
        desc.base.table_nm = desc.base.table_eta = desc.base.table_k = numbers;
        desc.base.table_count = 2;
        desc.base.*part = nullptr;
        CHECK_REFUSED(pellicle_film_create(&desc, sizeof desc, &film.output), PELLICLE_INVALID_ARGUMENT,
                      "base: table_");
    }
}

TEST_CASE("null: film retain refuses it, release takes it as nothing to do") {
    CHECK_REFUSED(pellicle_film_retain(nullptr), PELLICLE_INVALID_ARGUMENT, "film");
    pellicle_film_release(nullptr);
}

TEST_CASE("null: the calls of a film refuse a missing film and missing outputs") {
    const PellicleFilm *film = support::fixed_film().raw();
    Untouched<PellicleFilmPlan> plan;
    Untouched<float[3]> rgb, other;
    CHECK_REFUSED(pellicle_film_plan(nullptr, &plan.output, sizeof plan.output), PELLICLE_INVALID_ARGUMENT, "film");
    CHECK_REFUSED(pellicle_film_plan(film, nullptr, sizeof plan.output), PELLICLE_INVALID_ARGUMENT, "plan");
    CHECK_REFUSED(pellicle_film_reflectance(nullptr, 1.0f, 0.0f, rgb.output), PELLICLE_INVALID_ARGUMENT, "film");
    CHECK_REFUSED(pellicle_film_reflectance(film, 1.0f, 0.0f, nullptr), PELLICLE_INVALID_ARGUMENT, "rgb");
    CHECK_REFUSED(pellicle_film_reference(nullptr, 1.0f, 0.0f, rgb.output), PELLICLE_INVALID_ARGUMENT, "film");
    CHECK_REFUSED(pellicle_film_reference(film, 1.0f, 0.0f, nullptr), PELLICLE_INVALID_ARGUMENT, "rgb");
    CHECK_REFUSED(pellicle_film_eval(nullptr, 1.0f, 0.0f, PELLICLE_SIDE_AMBIENT, rgb.output, other.output),
                  PELLICLE_INVALID_ARGUMENT, "film");
    CHECK_REFUSED(pellicle_film_eval(film, 1.0f, 0.0f, PELLICLE_SIDE_AMBIENT, nullptr, nullptr),
                  PELLICLE_INVALID_ARGUMENT, "reflectance");

    const float lambda_nm = 550.0f;
    CHECK_REFUSED(pellicle_film_spectrum(nullptr, 1.0f, 0.0f, &lambda_nm, 1, rgb.output), PELLICLE_INVALID_ARGUMENT,
                  "film");
    CHECK_REFUSED(pellicle_film_spectrum(film, 1.0f, 0.0f, nullptr, 1, rgb.output), PELLICLE_INVALID_ARGUMENT,
                  "lambda_nm");
    CHECK_REFUSED(pellicle_film_spectrum(film, 1.0f, 0.0f, &lambda_nm, 1, nullptr), PELLICLE_INVALID_ARGUMENT,
                  "reflectance");
    CHECK_EQ(pellicle_film_spectrum(film, 1.0f, 0.0f, nullptr, 0, nullptr), PELLICLE_OK);
}

TEST_CASE("null: either output of film eval may be missing, and the other does not change for it") {
    const pellicle::Film &film = support::fixed_film();
    for (const std::uint32_t side : {PELLICLE_SIDE_AMBIENT, PELLICLE_SIDE_BASE}) {
        const pellicle::FilmColors both = film.eval(0.5f, 0.0f, side);
        float reflectance[3], transmittance[3];
        CHECK_EQ(pellicle_film_eval(film.raw(), 0.5f, 0.0f, side, reflectance, nullptr), PELLICLE_OK);
        CHECK_EQ(pellicle_film_eval(film.raw(), 0.5f, 0.0f, side, nullptr, transmittance), PELLICLE_OK);
        CHECK(support::same_bits(reflectance, both.reflectance.data(), 3));
        CHECK(support::same_bits(transmittance, both.transmittance.data(), 3));
    }
}

TEST_CASE("null: the film batch refuses every missing pointer but thicknesses where none varies") {
    Untouched<float[3]> reflectance;
    const float number = 1.0f;
    PellicleFilmBatchArgs args{};
    args.count = 1;
    args.cos_theta = args.thickness_nm = {&number, 4, 4};
    args.reflectance = {reflectance.output, 12, 4};
    const PellicleFilm *film = support::varying_film().raw();
    const auto call = [&](const PellicleFilmBatchArgs &changed) {
        return pellicle_film_reflectance_batch(film, &changed, sizeof changed);
    };
    CHECK_REFUSED(pellicle_film_reflectance_batch(nullptr, &args, sizeof args), PELLICLE_INVALID_ARGUMENT, "film");
    CHECK_REFUSED(pellicle_film_reflectance_batch(film, nullptr, sizeof args), PELLICLE_INVALID_ARGUMENT, "args");

    PellicleFilmBatchArgs changed = args;
    changed.cos_theta.data = nullptr;
    CHECK_REFUSED(call(changed), PELLICLE_INVALID_ARGUMENT, "cos_theta");
    changed = args;
    changed.thickness_nm.data = nullptr;
    CHECK_REFUSED(call(changed), PELLICLE_INVALID_ARGUMENT, "thickness_nm");
    changed.count = 0;
    CHECK_EQ(call(changed), PELLICLE_OK);
    changed = args;
    changed.reflectance.data = nullptr;
    CHECK_REFUSED(call(changed), PELLICLE_INVALID_ARGUMENT, "reflectance");
}

TEST_CASE("null: no text that the library returns is missing") {
    CHECK((pellicle_last_error() != nullptr));
    CHECK_FALSE(std::string(pellicle_version_string()).empty());
    for (PellicleStatus status = -2; status < 20; ++status)
        CHECK_FALSE(std::string(pellicle_status_string(status)).empty());
    for (const support::Model &model : support::models()) {
        CHECK_FALSE(std::string(model.info.name).empty());
        CHECK_FALSE(std::string(model.info.summary).empty());
        CHECK_FALSE(std::string(model.info.source).empty());
        for (const PellicleModelParam &param : model.params) {
            CHECK_FALSE(std::string(param.name).empty());
            CHECK_FALSE(std::string(param.summary).empty());
            CHECK((param.unit != nullptr));
        }
    }
}
