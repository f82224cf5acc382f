// Films against closed forms, against the reference, and against the laws of energy and reciprocity.
#include "support.hpp"

#include <algorithm>
#include <cmath>

namespace {

using pellicle::FilmBuilder;
using pellicle::Medium;
using support::Vec3;

double squared(double x) {
    return x * x;
}

// Of an amplitude between two media that do not absorb, at normal incidence.
double bare(double outer, double inner) {
    return squared((outer - inner) / (outer + inner));
}

float spectrum_at(const pellicle::Film &film, float cos_theta, float thickness_nm, float lambda_nm) {
    float reflectance = -1.0f;
    film.spectrum(cos_theta, thickness_nm, &lambda_nm, 1, &reflectance);
    return reflectance;
}

// Errors of a channel within the film's tolerance, and what single precision adds.
void check_within(const pellicle::Film &film, const Vec3 &found, const Vec3 &expected, float tolerances = 1.0f) {
    for (int channel = 0; channel < 3; ++channel)
        CHECK_LE(std::fabs(found[channel] - expected[channel]), tolerances * film.plan().tolerance + 1e-6f);
}

Vec3 clipped(Vec3 rgb) {
    for (float &channel : rgb) channel = std::clamp(channel, 0.0f, 1.0f);
    return rgb;
}

struct Point {
    float cos_theta, thickness_nm;
};

std::vector<Point> random_points(int count, float max_nm) {
    std::mt19937 random(6);
    std::vector<Point> points;
    for (int i = 0; i < count; ++i) {
        const Vec3 u = support::random_uniforms(random);
        points.push_back({u[0], u[1] * max_nm});
    }
    return points;
}

// Of different kinds; thicknesses to 400 nm.
std::vector<FilmBuilder> kinds_of_films() {
    return {
        FilmBuilder("BK7"),
        FilmBuilder("water").layer("oil", 0, 400),
        FilmBuilder("Ti").layer("TiO2", 0, 400),
        FilmBuilder("air").layer("water", 0, 400),
        FilmBuilder("Al").layer("MgF2", 50).layer("SiO2", 0, 400).ambient("water"),
        FilmBuilder(Medium::rgb({1.5f, 1.52f, 1.54f})).layer(Medium::constant(1.9f, 0.1f), 0, 400).color_space("acescg"),
        FilmBuilder("Au").white("D65").color_space("xyz"),
    };
}

std::vector<FilmBuilder> transparent_films() {
    return {
        FilmBuilder(Medium::constant(1.5f)),
        FilmBuilder(Medium::constant(1.33f)).layer(Medium::constant(1.5f), 0, 400),
        FilmBuilder("vacuum").layer(Medium::constant(1.4f), 0, 400),
        FilmBuilder(Medium::constant(1.2f)).layer("TiO2", 80).layer("SiO2", 0, 400).ambient(Medium::constant(1.6f)),
    };
}

} // namespace

TEST_CASE("film values: bare glass reflects 0.04 at normal incidence, whatever white and space") {
    for (const char *white : {"E", "D65"})
        for (const char *space : {"rec709", "rec2020", "acescg", "xyz"}) {
            CAPTURE(std::string(white));
            CAPTURE(std::string(space));
            const pellicle::Film film = FilmBuilder(Medium::constant(1.5f)).white(white).color_space(space).create();
            check_within(film, film.reflectance(1.0f), {0.04f, 0.04f, 0.04f});
            check_within(film, film.reflectance(0.0f), {1.0f, 1.0f, 1.0f});
        }
}

TEST_CASE("film values: a medium on itself reflects nothing") {
    const pellicle::Film film = FilmBuilder("water").ambient("water").layer("water", 0, 400).create();
    for (const Point &point : random_points(5, 400))
        check_within(film, film.reflectance(point.cos_theta, point.thickness_nm), {0.0f, 0.0f, 0.0f});
}

TEST_CASE("film values: at Brewster's angle half of the s-polarised light is left") {
    const double eta = 1.5, s_polarised = squared((eta * eta - 1) / (eta * eta + 1));
    const float brewster = static_cast<float>(1 / std::sqrt(1 + eta * eta));
    const pellicle::Film film = FilmBuilder(Medium::constant(1.5f)).create();
    const float expected = static_cast<float>(0.5 * s_polarised);
    CHECK_LE(std::fabs(spectrum_at(film, brewster, 0.0f, 550.0f) - expected), 1e-6f);
    check_within(film, film.reflectance(brewster), {expected, expected, expected});
}

TEST_CASE("film values: a quarter wave of magnesium fluoride, and a half wave that is not there") {
    const double n0 = 1.0, n1 = 1.38, n2 = 1.52, lambda_nm = 550.0;
    const pellicle::Film film = FilmBuilder(Medium::constant(1.52f)).layer(Medium::constant(1.38f), 0, 400).create();
    const double quarter = squared((n0 * n2 - n1 * n1) / (n0 * n2 + n1 * n1));
    CHECK_LE(std::fabs(spectrum_at(film, 1.0f, float(lambda_nm / (4 * n1)), float(lambda_nm)) - quarter), 1e-6);
    CHECK_LE(std::fabs(spectrum_at(film, 1.0f, float(lambda_nm / (2 * n1)), float(lambda_nm)) - bare(n0, n2)), 1e-6);
    CHECK_LE(std::fabs(spectrum_at(film, 1.0f, 0.0f, float(lambda_nm)) - bare(n0, n2)), 1e-6);
}

TEST_CASE("film values: layers are listed from the ambient inwards") {
    // Two quarter waves: the base seems to have the index (outer / inner)^2 n2.
    const double outer = 1.38, inner = 2.0, n2 = 1.52, lambda_nm = 550.0;
    const pellicle::Film film = FilmBuilder(Medium::constant(1.52f))
                                    .layer(Medium::constant(1.38f), float(lambda_nm / (4 * outer)))
                                    .layer(Medium::constant(2.0f), float(lambda_nm / (4 * inner)))
                                    .create();
    const double expected = bare(1.0, squared(outer / inner) * n2);
    CHECK_LE(std::fabs(spectrum_at(film, 1.0f, 0.0f, float(lambda_nm)) - expected), 1e-6);
}

TEST_CASE("film values: the light comes from the ambient, whatever its index") {
    const pellicle::Film film = FilmBuilder(Medium::constant(1.2f)).ambient(Medium::constant(1.6f)).create();
    const float expected = static_cast<float>(bare(1.6, 1.2));
    CHECK_LE(std::fabs(spectrum_at(film, 1.0f, 0.0f, 550.0f) - expected), 1e-6f);
    check_within(film, film.reflectance(1.0f), {expected, expected, expected});
    // Total reflection beyond the critical angle, 48.6 degrees.
    check_within(film, film.reflectance(0.6f), {1.0f, 1.0f, 1.0f});
}

TEST_CASE("film values: gold leaves the gamut, and is clipped unless unclipped") {
    const pellicle::Film clips = FilmBuilder("Au").create(), keeps = FilmBuilder("Au").unclipped().create();
    const Vec3 inside = clips.reflectance(1.0f), outside = keeps.reflectance(1.0f), reference = clips.reference(1.0f);
    CHECK_GT(reference[0], 1.005f);
    CHECK_EQ(inside[0], 1.0f);
    CHECK_GT(outside[0], 1.0f);
    check_within(keeps, clipped(outside), inside, 2.0f);
    check_within(clips, inside, clipped(reference));
}

TEST_CASE("film values: white and colour space count for whatever is not grey") {
    const auto gold = [](const char *white, const char *space) {
        return FilmBuilder("Au").white(white).color_space(space).create().reflectance(1.0f);
    };
    const Vec3 colors[] = {gold("E", "rec709"), gold("E", "rec2020"), gold("E", "acescg"), gold("E", "xyz"),
                           gold("D65", "rec709"), gold("D65", "rec2020")};
    for (const Vec3 &a : colors)
        for (const Vec3 &b : colors) CHECK_EQ(support::same_bits(a.data(), b.data(), 3), &a == &b);
    const pellicle::Film by_default = FilmBuilder("Au").create();
    CHECK(support::same_bits(by_default.reflectance(1.0f).data(), colors[0].data(), 3));
}

TEST_CASE("film values: the reflectance is the clipped reference within the plan's tolerance") {
    for (const FilmBuilder &builder : kinds_of_films()) {
        const pellicle::Film film = builder.create();
        CAPTURE(std::string(film.plan().method));
        for (const Point &point : random_points(25, 400)) {
            const Vec3 found = film.reflectance(point.cos_theta, point.thickness_nm);
            check_within(film, found, clipped(film.reference(point.cos_theta, point.thickness_nm)));
        }
    }
}

TEST_CASE("film values: without absorption what is not reflected is transmitted") {
    for (FilmBuilder &builder : transparent_films()) {
        const pellicle::Film film = builder.transmittance().create();
        for (const Point &point : random_points(10, 400)) {
            const Vec3 reflected = film.reflectance(point.cos_theta, point.thickness_nm);
            check_within(film, film.eval(point.cos_theta, point.thickness_nm).reflectance, reflected, 2.0f);
            for (const std::uint32_t side : {PELLICLE_SIDE_AMBIENT, PELLICLE_SIDE_BASE}) {
                CAPTURE(side);
                const pellicle::FilmColors colors = film.eval(point.cos_theta, point.thickness_nm, side);
                Vec3 rest{};
                for (int channel = 0; channel < 3; ++channel) rest[channel] = 1.0f - colors.reflectance[channel];
                check_within(film, colors.transmittance, rest, 2.0f);
            }
        }
    }
}

TEST_CASE("film values: as much is transmitted one way as the other, at the angles that belong together") {
    struct Pair {
        double ambient, base;
        FilmBuilder builder;
    };
    const Pair pairs[] = {
        {1.0, 1.5, FilmBuilder(Medium::constant(1.5f)).layer("TiO2", 0, 400)},
        {1.0, 1.5, FilmBuilder(Medium::constant(1.5f)).layer(Medium::constant(1.7f, 0.2f), 0, 400)},
        {1.6, 1.2, FilmBuilder(Medium::constant(1.2f)).layer("water", 0, 400).ambient(Medium::constant(1.6f))},
    };
    for (Pair pair : pairs) {
        const pellicle::Film film = pair.builder.transmittance().create();
        for (const Point &point : random_points(10, 400)) {
            const double cos_theta = point.cos_theta;
            const double sine = std::sqrt(1 - squared(cos_theta)) * pair.ambient / pair.base;
            const auto there = film.eval(point.cos_theta, point.thickness_nm, PELLICLE_SIDE_AMBIENT);
            if (sine >= 1) {
                check_within(film, there.transmittance, {0.0f, 0.0f, 0.0f});
                continue;
            }
            const float inside = static_cast<float>(std::sqrt(1 - squared(sine)));
            const auto back = film.eval(inside, point.thickness_nm, PELLICLE_SIDE_BASE);
            check_within(film, back.transmittance, there.transmittance, 2.0f);
        }
    }
}

TEST_CASE("film values: nothing comes from the side of an opaque base") {
    const pellicle::Film film = FilmBuilder("Ag").layer("SiO2", 0, 400).transmittance().create();
    const pellicle::FilmColors colors = film.eval(0.7f, 200.0f, PELLICLE_SIDE_BASE);
    CHECK(colors.reflectance == Vec3{0.0f, 0.0f, 0.0f});
    CHECK(colors.transmittance == Vec3{0.0f, 0.0f, 0.0f});
    check_within(film, film.eval(0.7f, 200.0f).reflectance, film.reflectance(0.7f, 200.0f), 2.0f);
}
