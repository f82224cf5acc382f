// Films so thin, or so like their neighbours, that they are hardly there.
#include "films.hpp"
#include "support.hpp"

#include <cmath>

namespace {

using airy::Rgb;
using airy::Stack;

const Stack soap = {1.0, 1.33, 1.0}, titania = {1.0, 2.4, {2.9, 3.1}};

} // namespace

// Methods that stop at the third harmonic are at their worst here, where the reflections of both sides nearly
// cancel and no beam is small: 0.26 off at cos = 0.04, d = 6 nm.
TEST_CASE("failures: a very thin film seen at a grazing angle") {
    const Rgb truth = airy::color(soap, 0.04, 6);
    const Rgb three = airy::color([](double lambda_nm) {
        return airy::reflectance(soap, 0.04, 6, lambda_nm, airy::harmonics(3));
    });
    CHECK(airy::distance(three, truth) == doctest::Approx(0.264).epsilon(0.01));
    films::check(films::by_every_method(films::builder(soap, 400)), soap, {1e-6, 0.005, 0.04, 0.2},
                 {1e-6, 1e-3, 0.1, 1, 3, 6, 12, 25});
    films::check(films::by_chosen_methods(films::builder(soap, 20)), soap, {1e-6, 0.005, 0.04, 0.2},
                 {1e-6, 1e-3, 0.1, 1, 3, 6, 12, 20});
}

// Renderers fade the film in over its first 30 nm by smoothstep: titania on its metal is then off by 0.088 at
// 10 nm, soap by 0.039 at 20 nm and cos = 0.2. Others switch it off below a thickness, and it jumps there.
TEST_CASE("failures: a film that thins out goes over into its bare base") {
    const auto faded = [](const Stack &stack, double cos_theta, double thickness_nm) {
        const double t = thickness_nm / 30, weight = t * t * (3 - 2 * t);
        const Rgb film = airy::color(stack, cos_theta, thickness_nm), base = airy::color(stack, cos_theta, 0);
        Rgb mixed;
        for (int c = 0; c < 3; ++c) mixed[c] = base[c] + weight * (film[c] - base[c]);
        return airy::distance(mixed, film);
    };
    CHECK(faded(titania, 1, 10) == doctest::Approx(0.088).epsilon(0.01));
    CHECK(faded(soap, 0.2, 20) == doctest::Approx(0.0385).epsilon(0.01));
    for (const Stack &stack : {soap, titania, Stack{1.0, 1.5, 1.33}, Stack{1.5, 1.0, 1.5}}) {
        const auto all = films::by_every_method(films::builder(stack, 300));
        films::check(all, stack, {0.01, 0.2, 0.7, 1}, {0, 1e-30, 1e-6, 0.01, 0.099, 0.101, 1, 5, 10, 20, 29, 31});
        // No jump either: two thicknesses that differ by a hundredth of an Angstrom look the same.
        for (const films::Evaluated &film : all)
            for (const double cos_theta : {0.05, 0.5, 1.0})
                for (double nm = 0; nm < 35; nm += 0.1) {
                    CAPTURE(film.name);
                    CAPTURE(nm);
                    const Rgb here = films::reflectance(film.film, cos_theta, nm);
                    CHECK_LE(airy::distance(here, films::reflectance(film.film, cos_theta, nm + 1e-3)), 1e-3);
                }
    }
}

// 0 / 0 along the surface gave NaN in two renderers: 1 - |r01|^2 and 1 - r01^2 r12^2 vanish together.
TEST_CASE("failures: a film of its neighbour's index is not there") {
    const std::vector<double> cosines = {0, 1e-9, 1e-3, 0.1, 0.5, 0.9, 1}, thicknesses = {0, 1, 100, 333, 400};
    for (const Stack &stack : {Stack{1.0, 1.0, 1.5}, Stack{1.0, 1.5, 1.5}, Stack{1.33, 1.33, 1.0}, Stack{1.33, 1.0, 1.0},
                               Stack{1.0, 1.0, {0.2, 3.0}}, Stack{1.0, {1.5, 3.0}, {1.5, 3.0}}}) {
        // With one half-space's index twice there is one boundary, and its colour is the same at all thicknesses.
        const auto all = films::by_every_method(films::builder(stack, 400));
        films::check(all, stack, cosines, {0});
        for (const films::Evaluated &film : all)
            for (const double cos_theta : cosines) {
                const Rgb bare = films::reflectance(film.film, cos_theta, 0);
                for (const double nm : thicknesses) {
                    CAPTURE(film.name);
                    CAPTURE(cos_theta);
                    CAPTURE(nm);
                    CHECK_LE(airy::distance(films::reflectance(film.film, cos_theta, nm), bare), 1e-6);
                }
            }
    }
    for (const Stack &stack : {Stack{1.0, 1.0, 1.0}, Stack{1.5, 1.5, 1.5}})
        for (const films::Evaluated &film : films::by_every_method(films::builder(stack, 400)))
            for (const double cos_theta : cosines)
                for (const double nm : thicknesses) {
                    CAPTURE(film.name);
                    CHECK_EQ(films::reflectance(film.film, cos_theta, nm), Rgb{0, 0, 0});
                }
}

// Three renderers drew soap black or as NaN, as they divide by the base's reflectance, or take an index of
// exactly 1 for "no index". At 100 nm and normal incidence soap reflects 0.078 of green.
TEST_CASE("failures: a base of the ambient's index, and indices of exactly 1") {
    CHECK(airy::color(soap, 1, 100)[1] == doctest::Approx(0.0775).epsilon(0.01));
    for (const Stack &stack : {soap, Stack{1.5, 1.33, 1.5}, Stack{1.5, 1.0, 1.5}, Stack{1.5, 1.0, 1.0}})
        films::check(films::by_every_method(films::builder(stack, 400)), stack, {0, 0.02, 0.3, 0.72, 1},
                     {0, 1, 100, 217, 400});
    // Surfaces without contrast reflect nothing.
    const support::Vec3 wo = {0.6f, 0, 0.8f}, wi = {-0.6f, 0, 0.8f}, black = {0, 0, 0};
    const auto microfacet = [](const char *fresnel) {
        return pellicle::BsdfBuilder("microfacet").choose("fresnel", fresnel).set("eta", 1.0f);
    };
    CHECK_EQ(microfacet("dielectric").create().value(wo, wi), black);
    CHECK_EQ(microfacet("conductor").create().value(wo, wi), black);
    const auto film = films::builder({1.0, 1.0, 1.0}, 400).create();
    const auto coated = pellicle::BsdfBuilder("microfacet").choose("fresnel", "film").film(film).set("thickness_nm", 300.0f);
    CHECK_EQ(coated.create().value(wo, wi), black);
    // Where Schlick's factor stands for Fresnel's, that holds at normal incidence only.
    const support::Vec3 up = {0, 0, 1};
    const auto plain = pellicle::BsdfBuilder("metallic_roughness").set("eta", 1.0f).set("roughness", 0.1f).create();
    for (const float channel : plain.value(up, up)) CHECK(channel == doctest::Approx(0.5 / 3.14159265).epsilon(0.01));
    const auto layered = [](float base) {
        return pellicle::BsdfBuilder("layered").set("eta", 1.0f).set("base", base)
            .set("specular_weight", 1.0f).set("diffuse_weight", 0.0f);
    };
    CHECK_EQ(layered(0).create().value(up, up), black);
    for (const float channel : layered(1).create().value(up, up)) CHECK_GT(channel, 1.0f);
}
