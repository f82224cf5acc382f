// The page of spheres that shows how far the ways to an environment's reflection are apart.

#include "environment_chart.hpp"

#include <OpenImageIO/imagebufalgo.h>
#include <doctest/doctest.h>

#include <ostream>

using namespace render;

namespace {

/// How many pixels of a page have this grey.
int count(const OIIO::ImageBuf &page, float level) {
    int found = 0;
    for (OIIO::ImageBuf::ConstIterator<float> pixel(page); !pixel.done(); ++pixel)
        found += std::fabs(pixel[0] - level) < 2e-3f && std::fabs(pixel[2] - level) < 2e-3f;
    return found;
}

} // namespace

TEST_SUITE_BEGIN("environment charts");

TEST_CASE("spheres are shown in sRGB, their differences around grey") {
    const int size = 24, columns = PrefilteredEnvironment::steps + 1;
    EnvironmentSpheres spheres{OIIO::ImageBuf(OIIO::ImageSpec(columns * size, 3 * size, 3, OIIO::TypeFloat)),
                               std::vector<Deviation>(columns), std::vector<Deviation>(columns)};
    const auto fill = [&](int row, float level) {
        OIIO::ImageBufAlgo::fill(spheres.radiance, {level, level, level},
                                 OIIO::ROI(0, columns * size, row * size, (row + 1) * size));
    };
    fill(0, 0.25f);
    fill(1, 0.25f);
    fill(2, 0.2f);
    const OIIO::ImageBuf page = displaySpheres(spheres, 1);
    const int all = columns * static_cast<int>(spherePixels(size).size());
    // At one stop 0.25 is 0.735 in sRGB and 0.2 is 0.665 (IEC 61966-2-1). Text adds a pixel here and there.
    CHECK(count(page, 0.7354f) == doctest::Approx(2 * all).epsilon(0.05));
    CHECK(count(page, 0.6652f) == doctest::Approx(all).epsilon(0.05));
    CHECK(count(page, 0.5f) == doctest::Approx(all).epsilon(0.05));
    // -0.05 at one stop is -0.1, magnified twice -0.2, of which grey is half.
    CHECK(count(page, 0.4f) == doctest::Approx(all).epsilon(0.05));
}

TEST_CASE("the comparison's environments are known") {
    REQUIRE(environmentCharts().size() == 2);
    CHECK(environmentCharts().front().name == "environment-landscape");
    CHECK(comparedMap("studio").width == 2 * comparedMap("studio").height);
    CHECK_THROWS_AS(comparedMap("moon"), std::invalid_argument);
}

TEST_SUITE_END();
