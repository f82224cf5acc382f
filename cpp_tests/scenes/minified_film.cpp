// A film whose thickness varies within a pixel: the mean thickness alone has the wrong colour; with the standard deviation
// it has that of full detail, as far as thickness is distributed normally.

#include "minified_film.hpp"
#include "render.hpp"
#include "stacks.hpp"
#include "temporary.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <ostream>

using namespace render;

namespace {

/// A picture's pixels are `angle` wide. White light: their radiance is the film's mean reflectance.
constexpr int side = 32;
const float angle = 2 * std::tan(radians(22)) / side;

Picture pictureOf(Minification minification, const std::shared_ptr<const Texture> &moments, int samples) {
    const auto world = anodisedSheet(unevenOxide(minification, moments));
    RenderSettings settings;
    settings.width = settings.height = side;
    settings.samplesPerPixel = samples;
    return renderPicture(*world, Environment::constant(Rgb(1)), overSheet(), settings);
}

/// Root mean square of the channels' differences, where pixels are at least `width` wide on the surface.
double difference(const Picture &a, const Picture &b, float width) {
    double squares = 0, count = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        if (a.pixels[i].distance * angle < width) continue;
        for (int c = 0; c < 3; ++c) {
            const double d = a.pixels[i].radiance[c] - b.pixels[i].radiance[c];
            squares += d * d;
            ++count;
        }
    }
    return std::sqrt(squares / count);
}

} // namespace

TEST_SUITE_BEGIN("minified_film");

TEST_CASE("unevenness is normal and repeats itself without a seam") {
    constexpr int size = 256;
    const std::vector<float> image = unevenness(size);
    double moments[5] = {};
    for (const float x : image)
        for (int n = 0; n < 5; ++n) moments[n] += std::pow(static_cast<double>(x), n) / static_cast<double>(image.size());
    MESSAGE("moments: ", moments[1], ", ", moments[2], ", ", moments[3], ", ", moments[4]);
    CHECK(std::fabs(moments[1]) < 1e-3);
    CHECK(std::fabs(moments[2] - 1) < 0.03);
    CHECK(std::fabs(moments[3]) < 0.1);
    CHECK(std::fabs(moments[4] - 3) < 0.1);

    const auto at = [&](int column, int row) { return image[static_cast<std::size_t>(row * size + column)]; };
    float inside = 0, across = 0;
    for (int i = 0; i < size; ++i) {
        for (int j = 1; j < size; ++j)
            inside = std::max({inside, std::fabs(at(j, i) - at(j - 1, i)), std::fabs(at(i, j) - at(i, j - 1))});
        across = std::max({across, std::fabs(at(0, i) - at(size - 1, i)), std::fabs(at(i, 0) - at(i, size - 1))});
    }
    CHECK(across <= inside);
}

TEST_CASE("a footprint's deviation grows from none to that of the whole") {
    const TemporaryDirectory directory;
    const auto moments = std::make_shared<Texture>(writeMoments(directory / "maps"), Encoding::linear);
    const Pattern deviation = ThicknessMap(moments, 100, {{3, 1}, {4, 2}}).deviation(10);
    SurfacePoint point;
    const auto at = [&](float width) {
        point.footprint = {V2f(width, 0), V2f(0, width)};
        float sum = 0;
        for (int i = 0; i < 100; ++i) {
            point.uv = V2f(0.137f, 0.319f) * static_cast<float>(i);
            float number;
            deviation.write(point, &number);
            sum += number / 100;
        }
        return sum;
    };
    // In full detail neighbouring texels differ a little, and half precision rounds.
    CHECK(at(0) < 0.5f);
    // A box of width w keeps sinc(u w) sinc(v w) of a wave with u and v periods to a side. Averaged over all waves that
    // leaves a deviation of 2.7 within a box of 0.01 and of 4.0 within 0.02; texture filters are up to twice as wide as what
    // is asked.
    const float partly = at(0.01f);
    CHECK(partly > 2.6f);
    CHECK(partly < 4.1f);
    CHECK(at(0.5f) == doctest::Approx(5).epsilon(0.03)); // 3 and 4 are independent
}

// What a normal distribution cannot do, as a part of the fringes' amplitude; kappa = 4 pi n cos(theta in the layer) / lambda.
//   The fine unevenness of 28 nm is a sum of N = 64 waves: colours fade by J0(kappa sigma sqrt(2 / N))^N and not by
// exp(-(kappa sigma)^2 / 2). The two differ by at most 0.0022.
//   Of the broad one, 22 nm, a pixel may see a part of one wave, which fades by J0(sqrt(2) kappa sigma) where it is whole.
// Behind the fine one's fade the difference is at most 0.029, for kappa = 0.062 / nm.
//   The films' tolerance, 2e-3, is allowed for twice. All this is for pixels that see several fine waves, which are
// 0.02 to 0.08 long; of fewer the picture's filter and the texture's see different ones.
TEST_CASE("with its deviation a minified thickness has the colours of full detail, and not without") {
    const TemporaryDirectory directory;
    const auto moments = std::make_shared<Texture>(writeMoments(directory / "maps"), Encoding::linear);
    const Picture mean = pictureOf(Minification::mean, moments, 64),
                  both = pictureOf(Minification::meanAndDeviation, moments, 64),
                  truth = pictureOf(Minification::none, moments, 2048);

    const pellicle::Film film = anodisedTitanium().film(320).create();
    float amplitude = 0;
    for (int c = 0; c < 3; ++c) {
        float least = 1, greatest = 0;
        for (float thickness = 0; thickness <= 320; thickness += 5) {
            least = std::min(least, film.reflectance(0.7f, thickness)[c]);
            greatest = std::max(greatest, film.reflectance(0.7f, thickness)[c]);
        }
        amplitude = std::max(amplitude, (greatest - least) / 2);
    }
    const double bound = 2 * 2e-3 + (0.0022 + 0.029) * amplitude;

    constexpr float severalWaves = 0.12f;
    const double wrong = difference(mean, truth, severalWaves), right = difference(both, truth, severalWaves);
    MESSAGE("several waves a pixel: ", wrong, " without, ", right, " with; bound ", bound);
    CHECK(right < bound);
    CHECK(wrong > 8 * right);

    // Towards the upper edge footprints are also longer than most broad waves. What a pixel sees is then the sum of two
    // unevennesses of 64 waves each, which are both nearly normal.
    constexpr float longerThanBroadWaves = 0.25f;
    const double far = difference(both, truth, longerThanBroadWaves), farBound = 2 * 2e-3 + 2 * 0.0022 * amplitude;
    MESSAGE("far away: ", difference(mean, truth, longerThanBroadWaves), " without, ", far, " with; bound ", farBound);
    CHECK(far < farBound);

    const double allWrong = difference(mean, truth, 0), allRight = difference(both, truth, 0);
    MESSAGE("all pixels: ", allWrong, " without, ", allRight, " with");
    CHECK(allWrong > 8 * allRight);
}

TEST_SUITE_END();
