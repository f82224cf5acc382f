#include "films.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

namespace films {

namespace {

pellicle::Medium medium(airy::Complex index) {
    return pellicle::Medium::constant(float(index.real()), float(index.imag()));
}

void add(std::vector<Evaluated> &all, pellicle::FilmBuilder builder, const std::string &method, float tolerance) {
    if (!method.empty()) builder.method(method);
    builder.tolerance(tolerance);
    try {
        all.push_back({method + " at " + std::to_string(tolerance), builder.create(), tolerance});
    } catch (const pellicle::Error &error) {
        CAPTURE(std::string(error.what()));
        CHECK_FALSE(method.empty());
        CHECK_EQ(error.status(), PELLICLE_UNSUPPORTED);
        CHECK_NE(std::string(error.what()).find("cannot hold tolerance"), std::string::npos);
    }
}

} // namespace

pellicle::FilmBuilder builder(const airy::Stack &stack, float max_nm) {
    return pellicle::FilmBuilder(medium(stack.base))
        .ambient(medium(stack.ambient))
        .layer(medium(stack.film), 0.0f, max_nm);
}

airy::Stack as_given(const airy::Stack &stack) {
    return {float(stack.ambient), airy::Complex(std::complex<float>(stack.film)), airy::Complex(std::complex<float>(stack.base))};
}

std::vector<Evaluated> by_chosen_methods(const pellicle::FilmBuilder &builder) {
    std::vector<Evaluated> all;
    for (const float tolerance : {1e-2f, 2e-3f, 2e-4f}) add(all, builder, "", tolerance);
    return all;
}

std::vector<Evaluated> by_every_method(const pellicle::FilmBuilder &builder) {
    std::vector<Evaluated> all = by_chosen_methods(builder);
    for (const char *steady : {"table", "bands", "series"})
        for (const float tolerance : {1e-2f, 2e-3f, 2e-4f}) add(all, builder, steady, tolerance);
    // The same at every tolerance.
    add(all, builder, "reference", 2e-4f);
    for (const char *unsteady : {"two_beam", "airy_rgb", "quadrature", "harmonics"})
        add(all, builder, unsteady, 1.0f);
    return all;
}

airy::Rgb reflectance(const pellicle::Film &film, double cos_theta, double thickness_nm) {
    const std::array<float, 3> rgb = film.reflectance(float(cos_theta), float(thickness_nm));
    return {rgb[0], rgb[1], rgb[2]};
}

void check(const std::vector<Evaluated> &films, const airy::Stack &stack, const std::vector<double> &cosines,
           const std::vector<double> &thicknesses_nm) {
    for (const double cos_theta : cosines)
        for (const double thickness_nm : thicknesses_nm) {
            // The same numbers as the library gets; it clamps cosines to [1e-9, 1], where soap is not singular.
            const double cosine = std::max<double>(float(cos_theta), 1e-9), nm = float(thickness_nm);
            const airy::Rgb truth = airy::clipped(airy::color(as_given(stack), cosine, nm));
            CAPTURE(cos_theta);
            CAPTURE(thickness_nm);
            for (const Evaluated &film : films) {
                CAPTURE(film.name);
                CAPTURE(std::string(film.film.plan().method));
                const airy::Rgb found = reflectance(film.film, cosine, nm);
                for (const double channel : found) CHECK((channel >= 0 && channel <= 1));
                CHECK_LE(airy::distance(found, truth), film.allowed());
            }
        }
}

} // namespace films
