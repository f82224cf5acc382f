// A film whose thickness varies within a pixel: its mean thickness has the wrong colour, mean and deviation the right one.

#include "minified_film.hpp"
#include "render.hpp"
#include "temporary.hpp"

#include <doctest/doctest.h>

#include <ostream>

using namespace render;

namespace {

constexpr int side = 32;

Picture pictureOf(Minification minification, const std::shared_ptr<const Texture> &moments, int samples) {
    const auto world = wafer(unevenOxide(minification, moments));
    RenderSettings settings;
    settings.width = settings.height = side;
    settings.samplesPerPixel = samples;
    // In white light a pixel's radiance is the film's reflectance.
    return renderPicture(*world, Environment::constant(Rgb(1)), overWafer(), settings);
}

} // namespace

TEST_SUITE_BEGIN("minified_film");

TEST_CASE("the unevenness is normal, and so is what wide pixels see of it") {
    const std::vector<float> image = unevenness(256);
    double powers[5] = {};
    for (const float x : image)
        for (int n = 0; n < 5; ++n) powers[n] += std::pow(static_cast<double>(x), n) / static_cast<double>(image.size());
    MESSAGE("moments: ", powers[1], ", ", powers[2], ", ", powers[3], ", ", powers[4]);
}

TEST_CASE("measure") {
    const TemporaryDirectory directory;
    const auto moments = std::make_shared<Texture>(writeMoments(directory / "maps"), Encoding::linear);
    const Picture mean = pictureOf(Minification::mean, moments, 64), both = pictureOf(Minification::meanAndDeviation, moments, 64),
                  truth = pictureOf(Minification::none, moments, 4096);
    for (int y = 0; y < side; ++y) {
        double m = 0, b = 0, bias = 0, d = 0, t = 0;
        for (int x = 0; x < side; ++x) {
            const Pixel &p = mean.pixels[y * side + x], &q = both.pixels[y * side + x], &r = truth.pixels[y * side + x];
            d += r.distance / side;
            for (int c = 0; c < 3; ++c) {
                m += std::pow(p.radiance[c] - r.radiance[c], 2) / (3 * side);
                b += std::pow(q.radiance[c] - r.radiance[c], 2) / (3 * side);
                bias += (q.radiance[c] - r.radiance[c]) / (3 * side);
                t += r.radiance[c] / (3 * side);
            }
        }
        MESSAGE(y, " distance ", d, " truth ", t, " mean only ", std::sqrt(m), " both ", std::sqrt(b), " bias ", bias);
    }
}

TEST_SUITE_END();
