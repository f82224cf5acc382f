// What create() refuses: names, counts, numbers and ranges. Driven by introspection, over every
// parameter of every model.
#include "support.hpp"

#include <cmath>
#include <string_view>

namespace {

using support::infinity;
using support::quiet_nan;

float below(float x) {
    return std::nextafter(x, -infinity);
}
float above(float x) {
    return std::nextafter(x, infinity);
}

// The film that a description of these parameters needs, if any.
pellicle::Film film_for(const std::string &name, const std::vector<PellicleParam> &params,
                        const std::vector<PellicleRange> &varying) {
    const std::string thickness = "thickness_nm";
    bool has_thickness = false;
    for (const PellicleParam &param : params) has_thickness = has_thickness || param.name == thickness;
    for (const PellicleRange &range : varying) has_thickness = has_thickness || range.name == thickness;
    for (const support::Model &model : support::models())
        if (model.info.name == name) return support::film_for(model, has_thickness);
    return {};
}

// The status of a description; PELLICLE_OK releases what it made.
PellicleStatus create(const std::string &model, const std::vector<PellicleParam> &params,
                      const std::vector<PellicleRange> &varying = {}) {
    PellicleBsdfDesc desc{};
    desc.model = model.c_str();
    desc.params = params.data();
    desc.param_count = params.size();
    desc.varying = varying.data();
    desc.varying_count = varying.size();
    const pellicle::Film film = film_for(model, params, varying);
    desc.film = film.raw();
    PellicleBsdf *bsdf = nullptr;
    const PellicleStatus status = pellicle_bsdf_create(&desc, sizeof desc, &bsdf);
    CHECK_EQ(bsdf != nullptr, status == PELLICLE_OK);
    pellicle_bsdf_release(bsdf);
    return status;
}

PellicleParam numbers(const char *name, const std::vector<float> &values) {
    return {name, values.data(), values.size(), nullptr};
}

PellicleParam choice(const char *name, const char *chosen) {
    return {name, nullptr, 0, chosen};
}

// Calls visit(model, param) for every parameter of that kind; there must be at least one.
template <class Visit> void for_each_param(std::uint32_t kind, Visit visit) {
    int visited = 0;
    for (const support::Model &model : support::models()) {
        CAPTURE(std::string(model.info.name));
        for (const PellicleModelParam &param : model.params) {
            if (param.kind != kind) continue;
            CAPTURE(std::string(param.name));
            visit(model, param);
            ++visited;
        }
    }
    CHECK_GT(visited, 0);
}

// The default of every component but one.
std::vector<float> with_component(const PellicleModelParam &param, std::uint32_t component, float value) {
    std::vector<float> values(param.default_value, param.default_value + param.components);
    values[component] = value;
    return values;
}

// A choice with which a parameter has an effect; nothing if it has one by default. The last one is taken: it is the
// most general (a conductor takes indices below 1, a dielectric none).
std::vector<PellicleParam> enabling_choice(const support::Model &model, const PellicleModelParam &param) {
    if (support::has_effect(model, param)) return {};
    for (const PellicleModelParam &other : model.params)
        for (std::uint32_t i = other.choice_count; i-- > 0;) {
            if (other.name == param.name || std::string_view(other.choices[i]) == "film") continue;
            const std::vector<PellicleParam> choices = {choice(other.name, other.choices[i])};
            if (support::has_effect(model, param, choices)) return choices;
        }
    FAIL("no choice gives it an effect: ", std::string(param.name));
    return {};
}

// That choice, and every other number that has an effect then at its least, so that limits on sums (albedos,
// weights) stay out of the way.
std::vector<PellicleParam> others_least(const support::Model &model, const PellicleModelParam &kept) {
    const std::vector<PellicleParam> enabling = enabling_choice(model, kept);
    std::vector<PellicleParam> params = enabling;
    for (const PellicleModelParam &param : model.params)
        if (param.kind == PELLICLE_KIND_NUMBER && param.name != kept.name && support::has_effect(model, param, enabling))
            params.push_back({param.name, &param.min, 1, nullptr});
    return params;
}

} // namespace

TEST_CASE("names: every model's defaults are complete") {
    for (const support::Model &model : support::models()) CHECK_EQ(create(model.info.name, {}), PELLICLE_OK);
}

TEST_CASE("names: an unknown model is refused with the list of models") {
    for (const char *unknown : {"", "lamber", "Lambert", "lambert "}) {
        CHECK_REFUSED(create(unknown, {}), PELLICLE_UNKNOWN_NAME, "model");
        for (const support::Model &model : support::models()) CHECK(support::message_has(model.info.name));
    }
}

TEST_CASE("names: an unknown parameter is refused with the list of parameters") {
    for (const support::Model &model : support::models()) {
        CHECK_REFUSED(create(model.info.name, {numbers("no such name", {0.5f})}), PELLICLE_UNKNOWN_NAME,
                      "no such name");
        for (const PellicleModelParam &param : model.params) CHECK(support::message_has(param.name));
        CHECK_REFUSED(create(model.info.name, {}, {{"no such name", 0.0f, 0.5f}}), PELLICLE_UNKNOWN_NAME,
                      "no such name");
        for (const PellicleModelParam &param : model.params)
            if (param.can_vary) CHECK(support::message_has(param.name));
    }
}

TEST_CASE("names: bytes that are not UTF-8 are refused, wherever a name is expected") {
    const char *const bytes = "\xff\xfe";
    CHECK_REFUSED(create(bytes, {}), PELLICLE_INVALID_ARGUMENT, "model");
    CHECK_REFUSED(create("lambert", {numbers(bytes, {0.5f})}), PELLICLE_INVALID_ARGUMENT, "name");
    CHECK_REFUSED(create("lambert", {}, {{bytes, 0.0f, 1.0f}}), PELLICLE_INVALID_ARGUMENT, "name");
    CHECK_REFUSED(create("layered", {choice("variant", bytes)}), PELLICLE_INVALID_ARGUMENT, "choice");
}

TEST_CASE("names: an unknown choice is refused with the list of choices, a known one is taken") {
    for_each_param(PELLICLE_KIND_CHOICE, [](const support::Model &model, const PellicleModelParam &param) {
        CHECK_REFUSED(create(model.info.name, {choice(param.name, "no such choice")}), PELLICLE_UNKNOWN_NAME,
                      "no such choice");
        CHECK(support::message_has(param.name));
        for (std::uint32_t i = 0; i < param.choice_count; ++i) CHECK(support::message_has(param.choices[i]));
        for (std::uint32_t i = 0; i < param.choice_count; ++i) {
            const PellicleParam known = choice(param.name, param.choices[i]);
            if (std::string_view(param.choices[i]) == "film")
                CHECK_REFUSED(create(model.info.name, {known}), PELLICLE_INVALID_ARGUMENT, "film");
            else {
                std::vector<PellicleParam> params = enabling_choice(model, param);
                params.push_back(known);
                CHECK_EQ(create(model.info.name, params), PELLICLE_OK);
            }
        }
    });
}

TEST_CASE("kinds: numbers are refused for a choice, a choice for numbers, and both at once") {
    const std::vector<float> half = {0.5f};
    for_each_param(PELLICLE_KIND_CHOICE, [&](const support::Model &model, const PellicleModelParam &param) {
        CHECK_REFUSED(create(model.info.name, {numbers(param.name, half)}), PELLICLE_INVALID_ARGUMENT, param.name);
        const PellicleParam both = {param.name, half.data(), 1, param.choices[0]};
        CHECK_REFUSED(create(model.info.name, {both}), PELLICLE_INVALID_ARGUMENT, param.name);
    });
    for_each_param(PELLICLE_KIND_NUMBER, [&](const support::Model &model, const PellicleModelParam &param) {
        CHECK_REFUSED(create(model.info.name, {choice(param.name, "energy")}), PELLICLE_INVALID_ARGUMENT, param.name);
        const std::vector<float> values(param.components, param.min);
        const PellicleParam both = {param.name, values.data(), values.size(), "energy"};
        CHECK_REFUSED(create(model.info.name, {both}), PELLICLE_INVALID_ARGUMENT, param.name);
    });
}

TEST_CASE("counts: any other number of numbers than the parameter has is refused") {
    for (const std::uint32_t kind : {PELLICLE_KIND_NUMBER, PELLICLE_KIND_DIRECTION})
        for_each_param(kind, [&](const support::Model &model, const PellicleModelParam &param) {
            const std::vector<float> plenty = {0.5f, 0.5f, 1.0f, 0.5f, 0.5f};
            for (std::size_t count = 0; count <= plenty.size(); ++count) {
                const bool stands_for_all = count == 1 && kind == PELLICLE_KIND_NUMBER;
                if (count == param.components || stands_for_all) continue;
                CAPTURE(count);
                const PellicleParam given = {param.name, plenty.data(), count, nullptr};
                CHECK_REFUSED(create(model.info.name, {given}), PELLICLE_INVALID_ARGUMENT, param.name);
            }
        });
}

TEST_CASE("counts: one number stands for all three components") {
    const pellicle::Bsdf one = pellicle::BsdfBuilder("lambert").set("reflectance", 0.25f).create();
    const pellicle::Bsdf three = pellicle::BsdfBuilder("lambert").set("reflectance", {0.25f, 0.25f, 0.25f}).create();
    const support::Vec3 up = {0.0f, 0.0f, 1.0f};
    CHECK(support::same_bits(one.value(up, up).data(), three.value(up, up).data(), 3));
}

TEST_CASE("counts: a number of entries that no memory holds is refused, not added up") {
    const std::vector<float> half = {0.5f};
    const PellicleParam huge = {"reflectance", half.data(), SIZE_MAX / 2, nullptr};
    CHECK_REFUSED(create("lambert", {huge}), PELLICLE_INVALID_ARGUMENT, "reflectance");
}

TEST_CASE("twice: the same parameter or the same varying given twice is refused") {
    for (const support::Model &model : support::models()) {
        for (const PellicleModelParam &param : model.params) {
            CAPTURE(std::string(param.name));
            const std::vector<float> values(param.default_value, param.default_value + param.components);
            const PellicleParam given = param.kind == PELLICLE_KIND_CHOICE ? choice(param.name, param.choices[0])
                                                                           : numbers(param.name, values);
            CHECK_REFUSED(create(model.info.name, {given, given}), PELLICLE_INVALID_ARGUMENT, param.name);
            if (!param.can_vary) continue;
            const PellicleRange range = {param.name, param.kind == PELLICLE_KIND_DIRECTION ? 0.0f : param.min,
                                         param.kind == PELLICLE_KIND_DIRECTION ? 0.0f : param.max};
            CHECK_REFUSED(create(model.info.name, {}, {range, range}), PELLICLE_INVALID_ARGUMENT, param.name);
        }
    }
}

TEST_CASE("range: the limits themselves are accepted") {
    for_each_param(PELLICLE_KIND_NUMBER, [](const support::Model &model, const PellicleModelParam &param) {
        for (const float limit : {param.min, param.max}) {
            const std::vector<float> values(param.components, limit);
            std::vector<PellicleParam> params = others_least(model, param);
            params.push_back(numbers(param.name, values));
            CAPTURE(limit);
            CAPTURE(std::string(pellicle_last_error()));
            CHECK_EQ(create(model.info.name, params), PELLICLE_OK);
        }
    });
}

TEST_CASE("range: one step below the least, one above the greatest, NaN and infinities are refused") {
    for_each_param(PELLICLE_KIND_NUMBER, [](const support::Model &model, const PellicleModelParam &param) {
        for (std::uint32_t component = 0; component < param.components; ++component)
            for (const float bad : {below(param.min), above(param.max), quiet_nan, infinity, -infinity}) {
                CAPTURE(component);
                CAPTURE(bad);
                const std::vector<float> values = with_component(param, component, bad);
                CHECK_REFUSED(create(model.info.name, {numbers(param.name, values)}), PELLICLE_OUT_OF_RANGE,
                              param.name);
            }
    });
}

TEST_CASE("range: a direction is refused below its least z, without length, with NaN or infinities") {
    for_each_param(PELLICLE_KIND_DIRECTION, [](const support::Model &model, const PellicleModelParam &param) {
        const std::vector<std::vector<float>> refused = {
            {0.0f, 0.0f, 0.0f},    {0.0f, 0.0f, -1.0f},    {1.0f, 0.0f, 0.5f * param.min},
            {quiet_nan, 0.0f, 1.0f},     {0.0f, quiet_nan, 1.0f},      {0.0f, 0.0f, quiet_nan},
            {infinity, 0.0f, 1.0f}, {0.0f, -infinity, 1.0f}, {0.0f, 0.0f, infinity},
        };
        for (const std::vector<float> &values : refused) {
            CAPTURE(values[0]);
            CAPTURE(values[1]);
            CAPTURE(values[2]);
            CHECK_REFUSED(create(model.info.name, {numbers(param.name, values)}), PELLICLE_OUT_OF_RANGE, param.name);
        }
    });
}

TEST_CASE("range: a direction of any length is accepted, also one whose square leaves the floats") {
    for_each_param(PELLICLE_KIND_DIRECTION, [](const support::Model &model, const PellicleModelParam &param) {
        for (const float length : {1e-30f, 1e-3f, 1.0f, 1e3f, 1e30f}) {
            CAPTURE(length);
            CHECK_EQ(create(model.info.name, {numbers(param.name, {0.3f * length, 0.0f, 0.9f * length})}), PELLICLE_OK);
        }
    });
}

TEST_CASE("varying: a reversed range and one beyond the declared limits are refused") {
    for_each_param(PELLICLE_KIND_NUMBER, [](const support::Model &model, const PellicleModelParam &param) {
        if (!param.can_vary) return;
        const auto create_with = [&](float min, float max) { return create(model.info.name, {}, {{param.name, min, max}}); };
        CHECK_REFUSED(create_with(param.max, param.min), PELLICLE_OUT_OF_RANGE, param.name);
        for (const float bad : {below(param.min), quiet_nan, -infinity})
            CHECK_REFUSED(create_with(bad, param.max), PELLICLE_OUT_OF_RANGE, param.name);
        for (const float bad : {above(param.max), quiet_nan, infinity})
            CHECK_REFUSED(create_with(param.min, bad), PELLICLE_OUT_OF_RANGE, param.name);
    });
}

TEST_CASE("varying: a parameter that cannot vary is refused as unsupported") {
    int visited = 0;
    for (const support::Model &model : support::models())
        for (const PellicleModelParam &param : model.params) {
            if (param.can_vary) continue;
            CAPTURE(std::string(param.name));
            CHECK_REFUSED(create(model.info.name, {}, {{param.name, param.min, param.max}}), PELLICLE_UNSUPPORTED,
                          param.name);
            ++visited;
        }
    CHECK_GT(visited, 0);
}

TEST_CASE("film: refused by a model that uses none, and missed by one that needs it") {
    int needing = 0;
    for (const support::Model &model : support::models()) {
        CAPTURE(std::string(model.info.name));
        PellicleBsdfDesc desc{};
        desc.model = model.info.name;
        desc.film = model.info.needs_film ? nullptr : support::fixed_film().raw();
        support::Untouched<PellicleBsdf *> bsdf;
        CHECK_REFUSED(pellicle_bsdf_create(&desc, sizeof desc, &bsdf.output), PELLICLE_INVALID_ARGUMENT, "film");
        CHECK(support::message_has(model.info.name));
        needing += model.info.needs_film != 0;
    }
    CHECK_GT(needing, 0);
}

TEST_CASE("varying: what was declared is what info() counts") {
    for (const support::Model &model : support::models()) {
        const support::Varying varying(model);
        CHECK_EQ(varying.bsdf().info().varying_count, varying.components().size());
        CHECK_EQ(varying.bsdf().info().varying_floats, varying.floats());
    }
}

TEST_CASE("varying: finite values beyond the range given at creation are clamped to it") {
    const auto bsdf = pellicle::BsdfBuilder("lambert").set("reflectance", 0.3f).vary("reflectance", 0.2f, 0.4f).create();
    const support::Vec3 up = {0.0f, 0.0f, 1.0f};
    const float values[3] = {-7.0f, 0.3f, 1e30f}, clamped[3] = {0.2f, 0.3f, 0.4f};
    CHECK(support::same_bits(bsdf.value(up, up, values).data(), bsdf.value(up, up, clamped).data(), 3));
}
