// Newton's charts show what the film's own call returns.

#include "chart.hpp"

#include "math.hpp"

#include <OpenImageIO/imagebufalgo.h>
#include <doctest/doctest.h>

#include <ostream>
#include <set>

using namespace render;

TEST_SUITE_BEGIN("charts");

TEST_CASE("a chart's pixels are the film's reflectance") {
    const int width = 30, height = 18;
    const OIIO::ImageBuf chart = reflectanceChart(oxidisedSilicon(), width, height);
    const pellicle::Film film = oxidisedSilicon().film(chartThickness).create();
    // 50 nm and 5 degrees to a pixel. The first column is at 25 nm, the lowest row at 2.5 degrees.
    for (const V2i &pixel : {V2i(0, 17), V2i(5, 17), V2i(29, 0), V2i(12, 9)}) {
        const float thickness = 25.0f + 50.0f * static_cast<float>(pixel.x);
        const float angle = 2.5f + 5.0f * static_cast<float>(height - 1 - pixel.y);
        const auto expected = film.reflectance(std::cos(radians(angle)), thickness);
        float shown[3];
        chart.getpixel(pixel.x, pixel.y, shown);
        for (int c = 0; c < 3; ++c) CHECK(shown[c] == doctest::Approx(expected[c]).epsilon(1e-4));
    }
}

TEST_CASE("charts are shown in sRGB, at their exposure") {
    OIIO::ImageBuf grey(OIIO::ImageSpec(60, 40, 3, OIIO::TypeFloat));
    const float quarter[3] = {0.25f, 0.25f, 0.25f};
    OIIO::ImageBufAlgo::fill(grey, quarter);
    const OIIO::ImageBuf page = displayChart(grey, 1);
    REQUIRE(page.spec().width > 60);
    REQUIRE(page.spec().height > 40);
    int found = 0; // 0.25 times 2 is 0.735 in sRGB
    for (OIIO::ImageBuf::ConstIterator<float> pixel(page); !pixel.done(); ++pixel)
        found += std::fabs(pixel[0] - 0.7354f) < 2e-3f && std::fabs(pixel[2] - 0.7354f) < 2e-3f;
    CHECK(found >= 60 * 40);
}

TEST_CASE("every stack has its chart") {
    std::set<std::string> names;
    for (const Chart &chart : charts()) names.insert(chart.name);
    CHECK(names.size() == stacks().size());
    CHECK(names.count("newton-soap") == 1);
}

TEST_SUITE_END();
