// Thick films, colours outside the gamut, and numbers outside a film's range.
#include "films.hpp"
#include "support.hpp"

#include <cmath>

namespace {

using airy::Rgb;
using airy::Stack;

const Stack soap = {1.0, 1.33, 1.0}, lacquer = {1.0, 1.5, {1.5, 3.0}}, titania = {1.0, 2.4, 1.5};

Rgb wide(const std::array<float, 3> &rgb) { return {rgb[0], rgb[1], rgb[2]}; }

} // namespace

// Fixed wavelengths take fringes finer than their distance for coarse ones: with 16 of them lacquer on metal is off by
// 0.092 (RMS, 3 to 30 um), and never gets grey. A phase in single precision, radians or turns, has one digit after the
// point left at 10 cm: a spectrum is then off by up to 0.05.
TEST_CASE("failures: thick films fade to the grey of incoherent light") {
    double worst_aliases = 0, worst_rounded = 0;
    for (const Stack &stack : {soap, lacquer, titania}) {
        double sum = 0;
        int count = 0;
        for (double nm = 3000; nm < 30000; nm += 1350) {
            const auto spectrum = [&](double lambda_nm) { return airy::reflectance(stack, 0.7, nm, lambda_nm); };
            const double error = airy::distance(airy::fixed_wavelengths(spectrum, 16), airy::color(stack, 0.7, nm));
            sum += error * error;
            ++count;
        }
        worst_aliases = std::max(worst_aliases, std::sqrt(sum / count));
        const auto thick = films::by_chosen_methods(films::builder(stack, 1e6f));
        films::check(thick, stack, {0.03, 0.4, 1}, {3e3, 3.3e4, 1e5, 1e6});
        for (const films::Evaluated &film : thick)
            for (const double cos_theta : {0.1, 0.4, 1.0}) {
                CAPTURE(film.name);
                const double grey = airy::incoherent(stack, float(cos_theta));
                const Rgb found = films::reflectance(film.film, cos_theta, 1e6);
                CHECK_LE(airy::distance(found, {grey, grey, grey}), film.allowed());
            }
        films::check({{"bands", films::builder(stack, 1e6f).method("bands").tolerance(1e-2f).create(), 1e-2}}, stack,
                     {0.1, 0.4, 1}, {3e3, 3.3e4, 1e6});
        // The spectrum has its fringes at ten centimetres, too.
        const Stack given = films::as_given(stack);
        const pellicle::Film tenth = films::builder(stack, 1e8f).create();
        for (const float lambda_nm : {445.0f, 525.0f, 645.0f}) {
            float found = -1;
            tenth.spectrum(0.5f, 1e8f, &lambda_nm, 1, &found);
            const double truth = airy::reflectance(given, 0.5, 1e8, lambda_nm);
            CHECK_LE(std::fabs(found - truth), 1e-5);
            // What rounding the phase to single precision does.
            const airy::Power rounded = [&](const airy::Amplitudes &a, airy::Complex) {
                const float phase = float(6.283185307179586) * float(a.path.real()) * (1e8f / lambda_nm);
                return airy::all_beams(a, std::polar(1.0, double(phase)));
            };
            const double off = std::fabs(airy::reflectance(given, 0.5, 1e8, lambda_nm, rounded) - truth);
            worst_rounded = std::max(worst_rounded, off);
        }
    }
    CHECK(worst_aliases == doctest::Approx(0.092).epsilon(0.02));
    CHECK(worst_rounded == doctest::Approx(0.05).epsilon(0.05));
}

// Saturated films leave Rec.709: 4.4 % of the values of soap are below 0, the truth included. Who clips inside a table
// finds none of them, and colours beside them are wrong as well. Without a white of its own per channel a mirror
// under equal-energy light would be (1.205, 0.948, 0.909).
TEST_CASE("failures: colours outside the gamut, and what is white") {
    int negative = 0, count = 0;
    const auto keeps = films::by_chosen_methods(films::builder(soap, 1000).unclipped());
    const auto clips = films::by_chosen_methods(films::builder(soap, 1000));
    std::vector<int> found(keeps.size());
    for (double cos_theta = 0.0125; cos_theta < 1; cos_theta += 0.05)
        for (double nm = 0; nm <= 1000; nm += 20) {
            const double cosine = float(cos_theta);
            const Rgb truth = airy::color(soap, cosine, nm);
            for (const double channel : truth) negative += channel < 0;
            count += 3;
            for (std::size_t i = 0; i < keeps.size(); ++i) {
                const Rgb kept = films::reflectance(keeps[i].film, cosine, nm);
                CAPTURE(keeps[i].name);
                CAPTURE(cos_theta);
                CAPTURE(nm);
                CHECK_LE(airy::distance(kept, truth), keeps[i].allowed());
                CHECK_LE(airy::distance(films::reflectance(clips[i].film, cosine, nm), airy::clipped(truth)), clips[i].allowed());
                for (const double channel : kept) found[i] += channel < 0;
            }
        }
    CHECK(double(negative) / count == doctest::Approx(0.044).epsilon(0.02));
    // Those nearer to 0 than the tolerance may go either way.
    CHECK(found.back() == doctest::Approx(negative).epsilon(0.05));
    // The reference is never clipped.
    double least = 0;
    for (double nm = 0; nm <= 1000; nm += 20)
        for (const double channel : wide(clips[0].film.reference(0.9f, float(nm)))) least = std::min(least, channel);
    CHECK_LT(least, -0.01);
    // A mirror is white under every light and in every space.
    for (const char *white : {"E", "D65"})
        for (const char *space : {"rec709", "rec2020", "acescg", "xyz"})
            for (const films::Evaluated &film : films::by_every_method(
                     films::builder({1.0, 1.5, {0.001, 1000.0}}, 400).white(white).color_space(space).unclipped())) {
                CAPTURE(film.name);
                CAPTURE(std::string(space));
                if (film.tolerance == 1) continue;
                for (const double nm : {0.0, 150.0, 400.0})
                    CHECK_LE(airy::distance(films::reflectance(film.film, 0.8, nm), {1, 1, 1}), film.allowed());
            }
}

// An index from NaN or infinity read beyond the table and stopped a renderer; a fraction that is not held in [0, 1]
// continues the last cell's slope: at 1e8 nm numbers of a million.
TEST_CASE("failures: thicknesses beyond the table, infinite, or no number") {
    const float max_nm = 400;
    for (const films::Evaluated &film : films::by_every_method(films::builder(titania, max_nm)))
        for (const float cos_theta : {0.0f, 0.3f, 1.0f, 2.0f}) {
            CAPTURE(film.name);
            const auto at = [&](float thickness_nm) { return film.film.reflectance(cos_theta, thickness_nm); };
            for (const float above : {400.00003f, 401.0f, 1e8f, 3.4e38f, support::infinity}) CHECK_EQ(at(above), at(max_nm));
            for (const float below : {-0.0f, -1e-30f, -1.0f, -1e8f, -support::infinity}) CHECK_EQ(at(below), at(0));
            CHECK_EQ(at(support::quiet_nan), support::Vec3{});
            CHECK_EQ(film.film.reflectance(support::quiet_nan, 100), support::Vec3{});
            // In a batch, side by side with numbers that are in order.
            const float nm[8] = {100, support::infinity, 200, support::quiet_nan, 1e8f, 300, -support::infinity, 50};
            float found[8][3];
            PellicleFilmBatchArgs args{};
            args.count = 8;
            args.cos_theta = {&cos_theta, 0, 4};
            args.thickness_nm = {nm, 4, 4};
            args.reflectance = {found[0], 12, 4};
            film.film.reflectance_batch(args);
            for (int i = 0; i < 8; ++i) CHECK(support::same_bits(found[i], at(nm[i]).data(), 3));
        }
    // Through a BSDF a finite thickness is clamped as well; one that is not finite gives 0.
    const auto film = films::builder(titania, max_nm).create();
    const auto bsdf = pellicle::BsdfBuilder("microfacet").choose("fresnel", "film").film(film)
                          .set("thickness_nm", 0.0f).vary("thickness_nm", 0.0f, max_nm).create();
    const support::Vec3 wo = {0.6f, 0, 0.8f}, wi = {-0.6f, 0, 0.8f};
    const auto value = [&](float nm) { return bsdf.value(wo, wi, &nm); };
    for (const float above : {401.0f, 1e8f, 3.4e38f}) CHECK_EQ(value(above), value(max_nm));
    for (const float below : {-1.0f, -3.4e38f}) CHECK_EQ(value(below), value(0));
    for (const float nm : {support::infinity, -support::infinity, support::quiet_nan}) CHECK_EQ(value(nm), support::Vec3{});
}
