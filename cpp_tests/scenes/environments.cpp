// Light from images: colours, orientation and importance sampling.

#include "environment.hpp"
#include "sampler.hpp"
#include "temporary.hpp"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <doctest/doctest.h>

#include <ostream>

using namespace render;

namespace {

std::string writeGrey(const TemporaryDirectory &directory, const std::string &name, int channels,
                      float level) {
    OIIO::ImageBuf image(OIIO::ImageSpec(4, 2, channels, OIIO::TypeFloat));
    std::vector<float> colour(channels, level);
    if (channels == 4) colour[3] = 1;
    OIIO::ImageBufAlgo::fill(image, colour);
    const std::string file = directory / name;
    REQUIRE(image.write(file, name.find(".png") == std::string::npos ? OIIO::TypeFloat : OIIO::TypeUInt8));
    return file;
}

/// One bright texel in a dim, uneven sky.
LatLongMap lantern() {
    LatLongMap map{32, 16, {}};
    for (int i = 0; i < map.width * map.height; ++i)
        map.texels.push_back(Rgb(0.1f * static_cast<float>(1 + i % 3), 0.1f, 0.05f));
    map.texels[5 * 32 + 24] = Rgb(200, 150, 100);
    return map;
}

} // namespace

TEST_SUITE_BEGIN("environments");

TEST_CASE("images are read as linear RGB") {
    const TemporaryDirectory directory;
    for (const int channels : {1, 3, 4}) {
        CAPTURE(channels);
        CHECK(readLatLongMap(writeGrey(directory, "linear.exr", channels, 0.5f)).texels[3].y ==
              doctest::Approx(0.5f));
        // 188 of 255 in sRGB is half of white (IEC 61966-2-1).
        CHECK(readLatLongMap(writeGrey(directory, "srgb.png", channels, 188.0f / 255)).texels[3].y ==
              doctest::Approx(0.5029f).epsilon(2e-3));
    }
}

TEST_CASE("the middle of the map is where the camera looks, the right is +x, the top +y") {
    const Environment environment(lantern());
    // Column 24.5 of 32 is a quarter turn to the right, row 5.5 of 16 is 28 degrees up.
    const float elevation = pi / 2 - pi * 5.5f / 16;
    const float azimuth = 2 * pi * 24.5f / 32 - pi;
    const V3f direction(std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
                        -std::cos(elevation) * std::cos(azimuth));
    CHECK(direction.x > 0.8f);
    CHECK(environment.radiance(direction).x == doctest::Approx(200).epsilon(1e-3));
    CHECK(environment.radiance(-direction).x < 1);
}

TEST_CASE("samples have the density that pdf() tells, and estimate the light") {
    const LatLongMap map = lantern();
    const Environment environment(map);
    Sampler sampler(1 << 14, 1);
    double one = 0, light = 0;
    for (int i = 0; i < 1 << 14; ++i) {
        sampler.start({0, 0}, i);
        const Environment::Sample sample = environment.sample(sampler.next(1).at2d(0));
        REQUIRE(sample.pdf > 0);
        REQUIRE(environment.pdf(sample.direction) == doctest::Approx(sample.pdf).epsilon(1e-4));
        one += 1 / sample.pdf;
        light += sample.radiance.x / sample.pdf;
    }
    // The reference: the interpolant at the centres of a fine grid.
    double expected = 0;
    constexpr int rows = 512, columns = 1024;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            expected += environment
                            .radiance(latLongDirection((static_cast<float>(column) + 0.5f) / columns,
                                                       1 - 2 * (static_cast<float>(row) + 0.5f) / rows))
                            .x;
    CHECK(one / (1 << 14) == doctest::Approx(4 * pi).epsilon(0.02));
    CHECK(light / (1 << 14) == doctest::Approx(expected * 4 * pi / (rows * columns)).epsilon(2e-3));
}

TEST_CASE("a black map gives no samples") {
    const Environment black({2, 1, {Rgb(0), Rgb(0)}});
    CHECK(black.sample({0.3f, 0.7f}).pdf == 0);
    CHECK(black.pdf(V3f(0, 1, 0)) == 0);
}

TEST_SUITE_END();
