#include "support.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>

namespace support {

PellicleMedium medium(const char *name) {
    PellicleMedium result{};
    result.name = name;
    return result;
}

PellicleMedium medium(float eta, float k) {
    PellicleMedium result{};
    for (int channel = 0; channel < 3; ++channel) {
        result.eta[channel] = eta;
        result.k[channel] = k;
    }
    return result;
}

const PellicleFilmDesc &FilmDescription::raw() {
    media_.clear();
    for (const Layer &layer : layers) media_.push_back(layer.medium);
    raw_layers_.clear();
    for (std::size_t i = 0; i < layers.size(); ++i)
        raw_layers_.push_back({&media_[i], layers[i].thickness_min_nm, layers[i].thickness_max_nm});
    desc.medium_size = sizeof(PellicleMedium);
    desc.layer_size = sizeof(PellicleLayer);
    desc.ambient = &ambient;
    desc.layers = raw_layers_.data();
    desc.layer_count = raw_layers_.size();
    desc.base = &base;
    return desc;
}

PellicleStatus FilmDescription::create() { return create_film(raw()); }

const char *simd_level() {
    const char *level = std::getenv("ABI_TEST_SIMD_LEVEL");
    if (level && *level) return level;
    static const std::string widest = [] {
        std::string name;
        for (std::size_t i = 0; pellicle_name(PELLICLE_NAMES_SIMD_LEVEL, i); ++i)
            name = pellicle_name(PELLICLE_NAMES_SIMD_LEVEL, i);
        return name;
    }();
    return widest.c_str();
}

static pellicle::Film magnesium_fluoride(float least_nm, float greatest_nm) {
    return pellicle::FilmBuilder(pellicle::Medium::constant(1.5f))
        .layer("MgF2", least_nm, greatest_nm)
        .transmittance()
        .simd_level(simd_level())
        .create();
}

const pellicle::Film &varying_film() {
    static const pellicle::Film film = magnesium_fluoride(0.0f, varying_film_max_nm);
    return film;
}

const pellicle::Film &fixed_film() {
    static const pellicle::Film film = magnesium_fluoride(100.0f, 100.0f);
    return film;
}

pellicle::Film film_for(const Model &model, bool has_thickness) {
    if (!model.takes_film()) return {};
    return has_thickness ? varying_film() : fixed_film();
}

pellicle::BsdfBuilder builder(const Model &model) {
    pellicle::BsdfBuilder result(model.info.name);
    result.film(film_for(model, false)).simd_level(simd_level());
    if (model.film_param) result.choose(model.film_param, "film");
    return result;
}

static bool is_thickness(const PellicleModelParam &param) { return param.name == std::string("thickness_nm"); }

bool has_effect(const Model &model, const PellicleModelParam &param, std::vector<PellicleParam> choices) {
    PellicleParam own = {param.name, param.default_value, param.components, nullptr};
    if (param.kind == PELLICLE_KIND_CHOICE) own = {param.name, nullptr, 0, param.choices[0]};
    choices.push_back(own);
    if (model.film_param) choices.push_back({model.film_param, nullptr, 0, "film"});
    PellicleBsdfDesc desc{};
    desc.model = model.info.name;
    desc.params = choices.data();
    desc.param_count = choices.size();
    const pellicle::Film film = film_for(model, is_thickness(param));
    desc.film = film.raw();
    PellicleBsdf *bsdf = nullptr;
    const PellicleStatus status = pellicle_bsdf_create(&desc, sizeof desc, &bsdf);
    pellicle_bsdf_release(bsdf);
    return status == PELLICLE_OK || !message_has("no effect");
}

PellicleStatus create_film(const PellicleFilmDesc &desc) {
    Untouched<PellicleFilm *> film;
    const PellicleStatus status = pellicle_film_create(&desc, sizeof desc, &film.output);
    if (status == PELLICLE_OK) {
        pellicle_film_release(film.output);
        film.restore();
    }
    return status;
}


// That of the parameter whose choice makes the model take a film, or NULL.
static const char *name_of_film_choice(const Model &model) {
    for (const PellicleModelParam &param : model.params)
        for (std::uint32_t i = 0; i < param.choice_count; ++i)
            if (param.choices[i] == std::string("film")) return param.name;
    return nullptr;
}

// The models; where a film is not a must, with it if the model can take one.
static std::vector<Model> models_if(bool with_film) {
    std::vector<Model> result(pellicle_model_count());
    REQUIRE_FALSE(result.empty());
    for (std::size_t model = 0; model < result.size(); ++model) {
        REQUIRE_EQ(pellicle_model_info(model, &result[model].info, sizeof(PellicleModelInfo)), PELLICLE_OK);
        result[model].params.resize(result[model].info.param_count);
        for (std::size_t param = 0; param < result[model].params.size(); ++param)
            REQUIRE_EQ(pellicle_model_param(model, param, &result[model].params[param], sizeof(PellicleModelParam)),
                       PELLICLE_OK);
        auto &params = result[model].params;
        // It needs a thickness beside it, and a film that allows a spread: film_spread.cpp tests it.
        params.erase(std::remove_if(params.begin(), params.end(),
                                    [](const PellicleModelParam &param) {
                                        return param.name == std::string("thickness_spread_nm");
                                    }),
                     params.end());
        if (with_film) result[model].film_param = name_of_film_choice(result[model]);
        if (!result[model].takes_film())
            params.erase(std::remove_if(params.begin(), params.end(), is_thickness), params.end());
        for (PellicleModelParam &param : params) {
            if (is_thickness(param)) param.max = varying_film_max_nm;
            // 0 is a mirror, apart from the range that may vary.
            if (param.name == std::string("alpha")) param.min = 1e-4f;
        }
    }
    return result;
}

std::vector<Model> models() { return models_if(false); }

std::vector<Model> models_with_and_without_film() {
    std::vector<Model> result = models();
    for (Model &model : models_if(true))
        if (model.film_param) result.push_back(std::move(model));
    REQUIRE_GT(result.size(), models().size());
    return result;
}

Varying::Varying(const Model &model, const Create &create) {
    pellicle::BsdfBuilder builder(model.info.name);
    builder.film(film_for(model, true)).simd_level(simd_level());
    if (model.film_param) builder.choose(model.film_param, "film");
    for (const PellicleModelParam &param : model.params) {
        if (!param.can_vary || !has_effect(model, param)) continue;
        components_.push_back(param.components);
        if (param.kind == PELLICLE_KIND_DIRECTION) {
            builder.vary(param.name, 0.0f, 0.0f);
            // Leaning by up to 50 degrees.
            lows_.insert(lows_.end(), {-0.6f, -0.6f, 0.7f});
            highs_.insert(highs_.end(), {0.6f, 0.6f, 1.0f});
            continue;
        }
        // The lower half of the range: there the albedos that a model adds up stay below 1. The
        // value used without `varying` must lie in it, too.
        const float middle = param.min + 0.5f * (param.max - param.min);
        builder.vary(param.name, param.min, middle);
        builder.set(param.name, 0.5f * (param.min + middle));
        lows_.insert(lows_.end(), param.components, param.min);
        highs_.insert(highs_.end(), param.components, middle);
    }
    bsdf_ = create ? create(builder) : builder.create();
    REQUIRE(bsdf_.raw());
    REQUIRE_EQ(bsdf_.info().varying_floats, floats());
}

std::vector<float> Varying::random_values(std::mt19937 &random) const {
    std::vector<float> values;
    for (std::size_t i = 0; i < lows_.size(); ++i)
        values.push_back(std::uniform_real_distribution<float>(lows_[i], highs_[i])(random));
    return values;
}

Vec3 random_direction(std::mt19937 &random) {
    const Vec3 u = random_uniforms(random);
    const float z = 1.0f - u[0];
    const float radius = std::sqrt(1.0f - z * z), phi = 6.2831853f * u[1];
    return {radius * std::cos(phi), radius * std::sin(phi), z};
}

Vec3 random_uniforms(std::mt19937 &random) {
    // 24 bits: std::uniform_real_distribution may round up to 1.
    const auto uniform = [&] { return static_cast<float>(random() >> 8) * 0x1p-24f; };
    const float a = uniform(), b = uniform(), c = uniform();
    return {a, b, c};
}

bool same_bits(const float *a, const float *b, std::size_t count) {
    return std::memcmp(a, b, count * sizeof(float)) == 0;
}

bool same_bits(const PellicleSample &a, const PellicleSample &b) {
    static_assert(sizeof(PellicleSample) == 11 * sizeof(float), "no padding to compare");
    return std::memcmp(&a, &b, sizeof a) == 0;
}

bool finite_and_non_negative(const float *values, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
        if (!std::isfinite(values[i]) || values[i] < 0.0f) return false;
    return true;
}

bool all_zero(const PellicleSample &sample) {
    return same_bits(sample, PellicleSample{});
}

bool message_has(const std::string &words) {
    return std::string(pellicle_last_error()).find(words) != std::string::npos;
}

GuardedBytes::GuardedBytes(std::size_t size) {
    const std::size_t page = pages::page_size();
    const std::size_t usable = (size + page - 1) / page * page;
    mapped_ = usable + page;
    mapping_ = static_cast<unsigned char *>(pages::map(mapped_, true));
    REQUIRE(mapping_);
    REQUIRE(pages::forbid(mapping_ + usable, page));
    data_ = mapping_ + usable - size;
}

GuardedBytes::~GuardedBytes() {
    pages::unmap(mapping_, mapped_);
}

} // namespace support
