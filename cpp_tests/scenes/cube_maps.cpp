// Light from six images: orientation and files.

#include "cube_map.hpp"
#include "environment.hpp"
#include "landscape.hpp"
#include "noise.hpp"
#include "temporary.hpp"

#include <OpenImageIO/imagebuf.h>
#include <doctest/doctest.h>

#include <algorithm>
#include <ostream>
#include <random>
#include <stdexcept>

using namespace render;

namespace {

Rgb smooth(const V3f &d) {
    return {1 + 0.5f * d.x, 1 + 0.3f * d.y * d.y - 0.2f * d.z, 1 + 0.4f * d.x * d.z + 0.3f * d.y};
}

/// Uncorrelated texels: the hardest for edges.
CubeMap mottled(int size) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> uniform(0, 1);
    CubeMap map{size, {}};
    for (auto &face : map.faces)
        for (int i = 0; i < size * size; ++i)
            face.push_back(Rgb(uniform(random), uniform(random), uniform(random)));
    return map;
}

std::vector<V3f> directions(int count) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> uniform(-1, 1);
    std::vector<V3f> list;
    while (static_cast<int>(list.size()) < count) {
        const V3f d(uniform(random), uniform(random), uniform(random));
        if (d.length() > 0.1f && d.length() < 1) list.push_back(d.normalized());
    }
    return list;
}

float difference(const Rgb &a, const Rgb &b) {
    return std::max({std::fabs(a.x - b.x), std::fabs(a.y - b.y), std::fabs(a.z - b.z)});
}

float largestError(int size) {
    const LatLongLight light(unrolled(drawCube(size, smooth)));
    float largest = 0;
    for (const V3f &d : directions(20000))
        largest = std::max(largest, difference(light.radiance(d), smooth(d)));
    return largest;
}

} // namespace

TEST_SUITE_BEGIN("cube_maps");

TEST_CASE("faces lie as OpenGL's table 8.19 says, with z turned over") {
    for (const V3f &d : directions(2000)) {
        const float x = d.x, y = d.y, z = -d.z;
        const float ax = std::fabs(x), ay = std::fabs(y), az = std::fabs(z);
        int face;
        float sc, tc, ma;
        if (ax >= ay && ax >= az)
            face = x > 0 ? 0 : 1, sc = x > 0 ? -z : z, tc = -y, ma = ax;
        else if (ay >= az)
            face = y > 0 ? 2 : 3, sc = x, tc = y > 0 ? z : -z, ma = ay;
        else
            face = z > 0 ? 4 : 5, sc = z > 0 ? x : -x, tc = -y, ma = az;
        const CubePoint point = cubePoint(d);
        REQUIRE(point.face == face);
        REQUIRE((point.st - V2f((sc / ma + 1) / 2, (tc / ma + 1) / 2)).length() < 1e-5f);
        REQUIRE((cubeDirection(point) - d).length() < 1e-5f);
    }
}

TEST_CASE("a smooth map is the function, over edges and corners too") {
    // At a face's edge the outermost texel's value is half a texel aside, a texel is 2 / size wide, the function's
    // slope is at most 0.7 per channel, and a latitude-longitude texel is half as wide.
    for (const int size : {32, 128}) CHECK(largestError(size) < 0.7f * 1.5f / static_cast<float>(size) + 1e-3f);
    CHECK(difference(LatLongLight(unrolled(drawCube(1, [](const V3f &) { return Rgb(0.25f, 0.5f, 2); })))
                         .radiance(V3f(0.6f, 0, 0.8f)),
                     Rgb(0.25f, 0.5f, 2)) < 1e-6f);
}

TEST_CASE("a function as a cube and as a latitude-longitude map gives the same light") {
    const auto mist = [](const V3f &d) { return Rgb(fractalNoise01(d * 2, 2).value); };
    const Environment cube(unrolled(drawCube(96, mist))), latLong(drawLatLong(128, mist));
    double mean = 0, apart = 0;
    const std::vector<V3f> all = directions(20000);
    for (const V3f &d : all) {
        mean += cube.radiance(d).x / static_cast<double>(all.size());
        apart += std::fabs(cube.radiance(d).x - latLong.radiance(d).x) / static_cast<double>(all.size());
    }
    CHECK(mean > 0.3);
    CHECK(apart < 0.004 * mean);
}

TEST_CASE("six files make a cube, five do not") {
    const TemporaryDirectory directory;
    const CubeMap map = mottled(4);
    const std::string prefix = directory / "sky.";
    writeCubeMap(map, prefix);
    const CubeMap read = readCubeMap(prefix);
    CHECK(read.size == 4);
    CHECK(read.faces == map.faces);

    const std::filesystem::path face = prefix + "py.exr";
    std::filesystem::copy_file(face, prefix + "py.copy.exr");
    CHECK_NOTHROW(readCubeMap(prefix));
    std::filesystem::copy_file(face, prefix + "py.hdr");
    CHECK_THROWS_AS(readCubeMap(prefix), std::runtime_error);
    std::filesystem::remove(prefix + "py.hdr");
    std::filesystem::remove(face);
    CHECK_THROWS_AS(readCubeMap(prefix), std::runtime_error);
    OIIO::ImageBuf wide(OIIO::ImageSpec(8, 4, 3, OIIO::TypeFloat));
    REQUIRE(wide.write(face.string()));
    CHECK_THROWS_AS(readCubeMap(prefix), std::runtime_error);
    CHECK_THROWS_AS(readCubeMap("/no/such/place/"), std::runtime_error);
}

TEST_CASE("the clear sky is the paper's, and the sun is as bright as suns are") {
    const ClearSky sky(V3f(0.6f, 0.75f, 0.3f), 2.6f);
    // Computed with Python's floats from the paper's tables, in units of 10 kcd/m^2.
    const auto check = [&](const V3f &direction, const Rgb &expected) {
        CHECK(difference(sky.radiance(direction.normalized()), expected) < 2e-4f);
    };
    check(V3f(0, 1, 0), Rgb(0.421936f, 0.669580f, 1.318823f));
    check(V3f(-0.3f, 0.5f, -0.8f), Rgb(0.308907f, 0.589786f, 1.121131f));
    check(V3f(0.5f, 0.8f, 0.4f), Rgb(1.507374f, 1.876548f, 2.888917f));
    // Direct sunlight: 70 to 110 klx.
    CHECK(10 * luminance(sky.sunIrradiance()) > 70);
    CHECK(10 * luminance(sky.sunIrradiance()) < 110);
    CHECK(sky.sunIrradiance().x > sky.sunIrradiance().z);
}

TEST_CASE("the landscape's disc gives the sun's irradiance") {
    const Landscape landscape;
    double expected = 0, drawn = 0;
    V3f brightest(0);
    const CubeMap map = drawCube(512, landscape);
    for (int face = 0; face < 6; ++face) {
        for (int i = 0; i < 512 * 512; ++i) {
            const Rgb &texel = map.faces[face][i];
            REQUIRE(std::isfinite(texel.x + texel.y + texel.z));
            REQUIRE(std::min({texel.x, texel.y, texel.z}) >= 0);
            if (luminance(texel) < 1000) continue;
            const CubePoint point{
                face, V2f(static_cast<float>(i % 512) + 0.5f, static_cast<float>(i / 512) + 0.5f) / 512.0f};
            const V2f xy = point.st * 2 - V2f(1);
            const double squared = 1 + xy.x * xy.x + xy.y * xy.y;
            drawn += luminance(texel) * 4 / (squared * std::sqrt(squared)) / (512 * 512);
            brightest = cubeDirection(point);
        }
    }
    expected = luminance(ClearSky(brightest, 2.6f).sunIrradiance());
    CHECK(drawn == doctest::Approx(expected).epsilon(0.05));
}

TEST_SUITE_END();
