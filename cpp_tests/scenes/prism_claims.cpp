// The prism's rays go where Snell's law sends their wavelengths, and their power is that of Fresnel's equations.

#include "prism.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <vector>

using namespace render;

namespace {

constexpr double degree = 3.14159265358979 / 180;

/// N-SF11 by Sellmeier's formula with Schott's coefficients.
double sf11(double nm) {
    const double x = nm * nm * 1e-6;
    return std::sqrt(1 + 1.73759695 * x / (x - 0.013188707) + 0.313747346 * x / (x - 0.0623068142) +
                     1.89878101 * x / (x - 155.23629));
}

/// The angle of incidence of the beam, and the apex.
constexpr double incidence = 61 * degree, apex = 60 * degree;

/// The angle against the second face's normal at which a wavelength leaves.
double exitAngle(double nm) {
    const double inside = std::asin(std::sin(incidence) / sf11(nm));
    return std::asin(sf11(nm) * std::sin(apex - inside));
}

/// The unpolarised transmittance of a face, from the angles on both sides (Fresnel).
double transmittance(double i, double t) {
    const double s = std::sin(i - t) / std::sin(i + t), p = std::tan(i - t) / std::tan(i + t);
    return 1 - 0.5 * (s * s + p * p);
}

} // namespace

TEST_SUITE_BEGIN("prism");

TEST_CASE("each wavelength leaves the prism at its own angle, with the power that two faces let through") {
    constexpr int rays = 1 << 15;
    std::map<int, double> power;
    double all = 0;
    int compared = 0;
    tracePrism(0, rays, rays, [&](const Segment &segment) {
        const V2f d = (segment.to - segment.from).normalized();
        const double angle = std::atan2(d.y, d.x) / degree;
        // The right face's normal points to 30 degrees; light that has passed both faces leaves it below.
        if (segment.from.x < 0.1f || segment.to.x < 8 || angle > 0) return;
        const double expected = 30 - exitAngle(segment.wavelength) / degree;
        if (std::fabs(angle - expected) > 5) return; // reflected more often
        CHECK(angle == doctest::Approx(expected).epsilon(1e-4).scale(30));
        power[static_cast<int>(segment.wavelength) / 34] += segment.power;
        all += segment.power;
        ++compared;
    });
    CHECK(compared > rays / 2);
    // 390 to 730 nm in ten bands of equal width and power: from 11 to 21, the first and the last cut off.
    double expected = 0;
    for (int nm = 390; nm < 730; nm += 2) {
        const double inside = std::asin(std::sin(incidence) / sf11(nm)), second = apex - inside;
        const double through = transmittance(incidence, inside) * transmittance(second, exitAngle(nm));
        expected += through * 2 / 340;
    }
    CHECK(all == doctest::Approx(expected).epsilon(1e-2));
    for (int band = 12; band < 21; ++band) CHECK(power[band] == doctest::Approx(expected / 10).epsilon(5e-2));
}

TEST_CASE("light of equal power is white") {
    Rgb sum(0);
    for (int i = 0; i < 340; ++i) sum += colorOf(390.5f + static_cast<float>(i));
    for (int c = 0; c < 3; ++c) CHECK(sum[c] / 340 == doctest::Approx(1).epsilon(1e-3));
    CHECK(colorOf(450).z > colorOf(450).x);
    CHECK(colorOf(620).x > colorOf(620).z);
}

TEST_SUITE_END();
