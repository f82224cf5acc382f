// Image textures: what look-ups return, and how much of an image a pixel sees.

#include "camera.hpp"
#include "maps.hpp"
#include "shapes.hpp"
#include "temporary.hpp"
#include "texture.hpp"
#include "world.hpp"

#include <OpenImageIO/imagebuf.h>
#include <doctest/doctest.h>

#include <algorithm>
#include <ostream>
#include <random>
#include <stdexcept>

using namespace render;

namespace {

/// Rows from the top.
std::filesystem::path writeImage(const std::string &file, int width, int height, int channels,
                                 const std::vector<float> &numbers, OIIO::TypeDesc type) {
    OIIO::ImageBuf image(OIIO::ImageSpec(width, height, channels, OIIO::TypeFloat));
    image.set_pixels(image.roi(), OIIO::TypeFloat, numbers.data());
    REQUIRE(image.write(file, type));
    return file;
}

std::array<float, 3> lookUp(const Texture &texture, const V2f &uv, float repetitions = 1,
                            std::array<V2f, 2> footprint = {V2f(0), V2f(0)}) {
    SurfacePoint point;
    point.uv = uv;
    point.footprint = footprint;
    std::array<float, 3> result{};
    texture.lookUp(point, repetitions, 3, result.data());
    return result;
}

std::vector<float> checkers(int size) {
    std::vector<float> numbers;
    for (int i = 0; i < size * size; ++i) numbers.push_back(static_cast<float>((i % size + i / size) % 2));
    return numbers;
}

} // namespace

TEST_SUITE_BEGIN("textures");

TEST_CASE("look-ups are bilinear between texels, v runs upwards, and images repeat themselves") {
    const TemporaryDirectory directory;
    // 4 x 2 texels: red counts columns, green rows from the top.
    std::vector<float> numbers;
    for (int row = 0; row < 2; ++row)
        for (int column = 0; column < 4; ++column)
            for (const float x : {0.125f * static_cast<float>(column), 0.5f * static_cast<float>(row), 0.75f})
                numbers.push_back(x);
    const Texture texture(writeImage(directory / "grid.tif", 4, 2, 3, numbers, OIIO::TypeFloat),
                          Encoding::linear);

    const auto upperLeft = lookUp(texture, V2f(0.125f, 0.75f));
    CHECK(upperLeft[0] == doctest::Approx(0).epsilon(1e-4));
    CHECK(upperLeft[1] == doctest::Approx(0).epsilon(1e-4));
    CHECK(upperLeft[2] == doctest::Approx(0.75f));
    const auto lowerRight = lookUp(texture, V2f(0.875f, 0.25f));
    CHECK(lowerRight[0] == doctest::Approx(0.375f).epsilon(1e-4));
    CHECK(lowerRight[1] == doctest::Approx(0.5f).epsilon(1e-4));
    // A third of the way from column 1 to column 2, half-way between the rows.
    const auto between = lookUp(texture, V2f(0.375f + 0.25f / 3, 0.5f));
    CHECK(between[0] == doctest::Approx(0.125f + 0.125f / 3).epsilon(1e-3));
    CHECK(between[1] == doctest::Approx(0.25f).epsilon(1e-3));
    for (const V2f &uv : {V2f(3.125f, 0.75f), V2f(-0.875f, 5.75f), V2f(0.125f, -3.25f)})
        CHECK(lookUp(texture, uv) == upperLeft);
    CHECK(lookUp(texture, V2f(0.4375f, 0.125f), 2) == lowerRight);
}

TEST_CASE("colours are decoded, other numbers are not") {
    const TemporaryDirectory directory;
    const auto file = writeImage(directory / "grey.png", 2, 2, 1,
                                 {0.737255f, 0.737255f, 0.737255f, 0.737255f}, OIIO::TypeUInt8);
    // 188 of 255 in sRGB is half of white (IEC 61966-2-1).
    const auto colour = lookUp(Texture(file, Encoding::sRgb), V2f(0.5f));
    CHECK(colour[0] == doctest::Approx(0.5029f).epsilon(2e-3));
    CHECK(colour[2] == colour[0]); // one channel stands for three
    CHECK(lookUp(Texture(file, Encoding::linear), V2f(0.5f))[0] ==
          doctest::Approx(188.0f / 255).epsilon(1e-3));
}

TEST_CASE("wide footprints see the mean, of light and not of codes") {
    const TemporaryDirectory directory;
    const auto file = writeImage(directory / "checkers.png", 64, 64, 1, checkers(64), OIIO::TypeUInt8);
    const Texture colours(file, Encoding::sRgb), numbers(file, Encoding::linear);
    std::mt19937 random(2);
    std::uniform_real_distribution<float> uniform(0, 1);
    for (int i = 0; i < 100; ++i) {
        const V2f uv(uniform(random), uniform(random));
        const std::array<V2f, 2> round{V2f(0.25f, 0), V2f(0, 0.25f)}, flat{V2f(0.2f, 0), V2f(0, 0.06f)};
        for (const auto &footprint : {round, flat}) {
            CHECK(lookUp(colours, uv, 1, footprint)[0] == doctest::Approx(0.5f).epsilon(0.02));
            CHECK(lookUp(numbers, uv, 1, footprint)[0] == doctest::Approx(0.5f).epsilon(0.02));
        }
    }
    // In full detail they are as black and white as they are.
    CHECK(lookUp(numbers, V2f(0.5f / 64, 1 - 0.5f / 64))[0] == 0);
    CHECK(lookUp(numbers, V2f(1.5f / 64, 1 - 0.5f / 64))[0] == 1);
}

TEST_CASE("what cannot be read is refused") {
    CHECK_THROWS_AS(Texture("/no/such.png", Encoding::linear), std::runtime_error);
}

TEST_CASE("a footprint is as far as the next pixel's ray hits") {
    World world;
    world.add(std::make_shared<Mesh>(square(20)),
              std::make_shared<Material>(pellicle::BsdfBuilder("lambert")));
    world.commit();
    const Camera camera(V3f(0.3f, 2, 5), V3f(0.1f, 0, 1), 30);
    const V2i resolution(200, 200);
    // Along the view's vertical plane, where the ellipse's axes are the picture's.
    const auto uvAt = [&](float x, float y) {
        return world.intersect(camera.ray(V2f(x, y), resolution))->point.uv;
    };
    const auto hit = world.intersect(camera.ray(V2f(100, 100), resolution));
    const float across = (uvAt(100.5f, 100) - uvAt(99.5f, 100)).length();
    const float along = (uvAt(100, 100.5f) - uvAt(100, 99.5f)).length();
    CHECK(hit->point.footprint[0].length() == doctest::Approx(across).epsilon(0.01));
    CHECK(hit->point.footprint[1].length() == doctest::Approx(along).epsilon(0.01));
    CHECK(std::fabs(hit->point.footprint[0].dot(uvAt(100, 100.5f) - uvAt(100, 99.5f))) <
          0.05f * across * along);
    // Scattered rays read full detail.
    CHECK(world.intersect({V3f(0, 2, 5), V3f(0, -0.6f, -0.8f)})->point.footprint[0] == V2f(0));
}

TEST_CASE("the slabs repeat without a seam") {
    std::mt19937 random(6);
    std::uniform_real_distribution<float> uniform(0, 1);
    constexpr float little = 1e-5f;
    for (int i = 0; i < 2000; ++i) {
        const float x = uniform(random);
        CHECK(std::fabs(stoneSlabs(V2f(little, x)).height - stoneSlabs(V2f(1 - little, x)).height) < 1e-3f);
        CHECK(std::fabs(stoneSlabs(V2f(x, little)).height - stoneSlabs(V2f(x, 1 - little)).height) < 1e-3f);
    }
}

TEST_SUITE_END();
