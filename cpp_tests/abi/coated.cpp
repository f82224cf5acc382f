// A film on a rough surface: the formula written out a second time, the mirror, what varies, and the
// film's rules.
#include "support.hpp"

#include <cmath>

namespace {

using support::Vec3;

pellicle::BsdfBuilder coated(const pellicle::Film &film) {
    return pellicle::BsdfBuilder("microfacet").choose("fresnel", "film").film(film);
}

double dot(const Vec3 &a, const Vec3 &b) {
    return double(a[0]) * b[0] + double(a[1]) * b[1] + double(a[2]) * b[2];
}

// Walter et al. 2007, eq. 33, with the height-correlated masking of Heitz 2014, eq. 72 and 99: all but F of
// f |wi.z|.
double without_fresnel(double alpha, const Vec3 &wo, const Vec3 &wi, double &wo_dot_h) {
    constexpr double pi = 3.14159265358979323846;
    const double x = wo[0] + wi[0], y = wo[1] + wi[1], z = wo[2] + wi[2];
    const double length = std::sqrt(x * x + y * y + z * z);
    wo_dot_h = (wo[0] * x + wo[1] * y + wo[2] * z) / length;
    const double cos_squared = z * z / (length * length);
    const double root = cos_squared * (alpha * alpha - 1.0) + 1.0;
    const double density = alpha * alpha / (pi * root * root);
    const auto lambda = [&](const Vec3 &w) {
        const double tan_squared = (double(w[0]) * w[0] + double(w[1]) * w[1]) / (double(w[2]) * w[2]);
        return 0.5 * (std::sqrt(1.0 + alpha * alpha * tan_squared) - 1.0);
    };
    return density / (1.0 + lambda(wo) + lambda(wi)) / (4.0 * wo[2]);
}

} // namespace

TEST_CASE("coated: values are D G F / 4 with the film's reflectance at <wo, h>") {
    const pellicle::Film &film = support::varying_film();
    const auto bsdf = coated(film).set("alpha", 0.5f).vary("alpha", 1e-4f, 1.0f).set("thickness_nm", 0.0f)
                          .vary("thickness_nm", 0.0f, support::varying_film_max_nm).create();
    REQUIRE_EQ(bsdf.info().varying_floats, 2u);
    std::mt19937 random(1);
    for (int i = 0; i < 2000; ++i) {
        const Vec3 wo = support::random_direction(random), wi = support::random_direction(random);
        const Vec3 u = support::random_uniforms(random);
        // In the order of introspection: alpha comes first.
        const float varying[2] = {0.05f + 0.95f * u[0], support::varying_film_max_nm * u[1]};
        double wo_dot_h;
        const double rest = without_fresnel(varying[0], wo, wi, wo_dot_h);
        const Vec3 fresnel = film.reflectance(static_cast<float>(wo_dot_h), varying[1]);
        const Vec3 found = bsdf.value(wo, wi, varying);
        for (int channel = 0; channel < 3; ++channel)
            CHECK(found[channel] == doctest::Approx(rest * fresnel[channel]).epsilon(2e-4));
    }
}

TEST_CASE("coated: a sample's weight is at most what its facet reflects, its density that of pdf") {
    const pellicle::Film &film = support::varying_film();
    const auto bsdf = coated(film).set("alpha", 0.4f).set("thickness_nm", 250.0f).create();
    std::mt19937 random(2);
    int sampled = 0;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 wo = support::random_direction(random);
        const PellicleSample sample = bsdf.sample(wo, support::random_uniforms(random));
        if (sample.pdf == 0.0f) continue;
        ++sampled;
        const Vec3 wi = {sample.wi[0], sample.wi[1], sample.wi[2]};
        const double half_angle_cosine = std::sqrt(0.5 * (1.0 + dot(wo, wi)));
        const Vec3 facet = film.reflectance(static_cast<float>(half_angle_cosine), 250.0f);
        for (int channel = 0; channel < 3; ++channel) CHECK_LE(sample.weight[channel], facet[channel] * 1.0001f + 1e-6f);
        CHECK(sample.pdf == doctest::Approx(bsdf.pdf(wo, wi)).epsilon(1e-4));
    }
    CHECK_GT(sampled, 1000);
}

TEST_CASE("coated: without roughness it is a mirror with the film's colours") {
    const pellicle::Film &film = support::varying_film();
    const auto bsdf = coated(film).set("alpha", 0.0f).vary("thickness_nm", 0.0f, 400.0f).create();
    std::mt19937 random(3);
    for (int i = 0; i < 200; ++i) {
        const Vec3 wo = support::random_direction(random);
        const float thickness_nm = 400.0f * support::random_uniforms(random)[0];
        const PellicleSample sample = bsdf.sample(wo, Vec3{0.5f, 0.5f, 0.5f}, &thickness_nm);
        CHECK_EQ(sample.flags, PELLICLE_REFLECTION | PELLICLE_DELTA);
        const Vec3 expected = film.reflectance(wo[2], thickness_nm);
        for (int channel = 0; channel < 3; ++channel)
            CHECK(sample.weight[channel] == doctest::Approx(expected[channel]).epsilon(1e-5));
    }
}

// What facets pass on to each other is coloured again: a rough mirror of silver under a film of no thickness
// returns nearly what it does with its own Fresnel factor.
TEST_CASE("coated: energy compensation gives back light of the film's colours") {
    const pellicle::Film film = pellicle::FilmBuilder("Ag").layer("SiO2", 0.0f, 400.0f).create();
    const auto create = [&](const char *compensation) {
        return coated(film).choose("energy_compensation", compensation).set("alpha", 1.0f)
            .vary("thickness_nm", 0.0f, 400.0f).create();
    };
    const auto bare = pellicle::BsdfBuilder("microfacet").choose("fresnel", "conductor").choose("metal", "Ag")
                          .choose("energy_compensation", "on").set("alpha", 1.0f).create();
    const float no_thickness = 0.0f, some_nm = 300.0f;
    const Vec3 wo = {0.6f, 0.0f, 0.8f};
    const Vec3 off = create("off").albedo(wo, &some_nm), on = create("on").albedo(wo, &some_nm);
    const Vec3 zero = create("on").albedo(wo, &no_thickness), metal = bare.albedo(wo);
    for (int channel = 0; channel < 3; ++channel) {
        CHECK_GT(on[channel], off[channel] + 0.1f);
        CHECK_LE(on[channel], 1.0f);
        CHECK(zero[channel] == doctest::Approx(metal[channel]).epsilon(6e-3));
    }
}

TEST_CASE("coated: a film that is missing, or that nothing uses, is refused with the choices") {
    const char *choices = "choices: schlick, dielectric, conductor, film";
    const pellicle::Film &varying = support::varying_film(), &fixed = support::fixed_film();
    const auto status = [](const pellicle::BsdfBuilder &builder, const std::string &words) {
        try {
            builder.create();
        } catch (const pellicle::Error &error) {
            CAPTURE(std::string(error.what()));
            CHECK_NE(std::string(error.what()).find(words), std::string::npos);
            return error.status();
        }
        return PellicleStatus{PELLICLE_OK};
    };
    using pellicle::BsdfBuilder;
    CHECK_EQ(status(BsdfBuilder("microfacet").choose("fresnel", "film"), choices), PELLICLE_INVALID_ARGUMENT);
    CHECK_EQ(status(BsdfBuilder("microfacet").film(fixed), choices), PELLICLE_INVALID_ARGUMENT);
    CHECK_EQ(status(BsdfBuilder("metallic_roughness").film(fixed), "uses no film"), PELLICLE_INVALID_ARGUMENT);
    CHECK_EQ(status(coated(varying), "needs 'thickness_nm'"), PELLICLE_INVALID_ARGUMENT);
    CHECK_EQ(status(coated(fixed).set("thickness_nm", 100.0f), "no layer of its film varies"), PELLICLE_INVALID_ARGUMENT);
    CHECK_EQ(status(coated(varying).set("thickness_nm", 401.0f), "[0, 400]"), PELLICLE_OUT_OF_RANGE);
    CHECK_EQ(status(coated(fixed), ""), PELLICLE_OK);
}

TEST_CASE("microfacet: unknown choices and roughness outside its range are refused") {
    struct Refused {
        const char *param, *choice, *words;
    };
    for (const Refused &refused : {Refused{"distribution", "ggxx", "ggx, beckmann, blinn_phong, abc, sgd"},
                                   Refused{"masking", "none", "smith, schlick, kelemen, cook_torrance, implicit"},
                                   Refused{"fresnel", "exact", "schlick, dielectric, conductor, film"}}) {
        PellicleParam param{};
        param.name = refused.param;
        param.choice = refused.choice;
        PellicleBsdfDesc desc{};
        desc.model = "microfacet";
        desc.params = &param;
        desc.param_count = 1;
        support::Untouched<PellicleBsdf *> bsdf;
        CHECK_REFUSED(pellicle_bsdf_create(&desc, sizeof desc, &bsdf.output), PELLICLE_UNKNOWN_NAME, refused.words);
    }
    for (const char *model : {"microfacet", "metallic_roughness"})
        for (const float value : {-0.1f, 1.5f, support::quiet_nan}) {
            const char *name = model == std::string("microfacet") ? "alpha" : "roughness";
            CHECK_THROWS_AS(pellicle::BsdfBuilder(model).set(name, value).create(), pellicle::Error);
            CHECK(support::message_has(name));
            CHECK(support::message_has("[0, 1]"));
        }
}
