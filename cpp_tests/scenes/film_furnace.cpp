// What a film without loss does not reflect it transmits: in a uniformly white room it cannot be seen.

#include "shapes.hpp"
#include "stacks.hpp"
#include "statistics.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <ostream>

using namespace render;

namespace {

/// Both colours are clipped and each is good to the film's tolerance of 2e-3; light meets the film
/// twice as a rule, at the rim more often.
constexpr double lost = 0.01;

const pellicle::Medium air = "air";

std::shared_ptr<const Material> film(const pellicle::Medium &base, float thickness) {
    const auto compiled =
        pellicle::FilmBuilder(base).ambient(air).layer("water", 0, 500).transmittance().create();
    return std::make_shared<Material>(
        pellicle::BsdfBuilder("film").film(compiled).set("thickness_nm", thickness));
}

void checkInvisible(const World &world, const Camera &camera) {
    const Environment white = Environment::constant(Rgb(1));
    RenderSettings settings;
    settings.width = settings.height = 24;
    settings.samplesPerPixel = 16;
    settings.path.maxBounces = 200;
    const RgbEstimate mean = pictureMean(8, [&](std::uint32_t seed) {
        settings.seed = seed;
        return renderPicture(world, white, camera, settings);
    });
    for (int c = 0; c < 3; ++c) {
        CAPTURE(c);
        MESSAGE(mean[c].mean, " +- ", mean[c].standardError);
        CHECK(mean[c].standardError < 3e-3); // else agreement would mean nothing
        CHECK(mean[c].mean <= 1 + 4 * mean[c].standardError + 1e-5);
        CHECK(mean[c].mean >= 1 - 4 * mean[c].standardError - lost);
    }
}

} // namespace

TEST_SUITE_BEGIN("film_furnace");

TEST_CASE("furnace: a bubble disappears") {
    World world;
    world.add(Sphere{V3f(0), 1}, film(air, 300));
    world.commit();
    checkInvisible(world, Camera(V3f(0, 0, 8), V3f(0), 17));
}

TEST_CASE("furnace: the rim of a bubble disappears") {
    World world;
    world.add(Sphere{V3f(0), 1}, film(air, 120));
    world.commit();
    // Half the picture is the bubble's outermost hundredth, the other half is behind it.
    checkInvisible(world, Camera(V3f(0, 0, 8), V3f(1.0078f, 0, 0), 0.14f));
}

TEST_CASE("furnace: a flat film disappears from both sides") {
    World world;
    world.add(std::make_shared<Mesh>(disc(V3f(0), V3f(0.6f, 0, 0.8f), 1)), film(air, 450));
    world.commit();
    checkInvisible(world, Camera(V3f(0, 0, 8), V3f(0), 12));
    checkInvisible(world, Camera(V3f(0, 0, -8), V3f(0), 12));
}

// Light that enters is compressed, light that leaves spreads again: radiance is 1 again outside.
TEST_CASE("furnace: a coated ball of glass disappears") {
    World world;
    world.add(Sphere{V3f(0), 1}, film(pellicle::Medium::constant(1.5168f), 100));
    world.commit();
    checkInvisible(world, Camera(V3f(0, 0, 8), V3f(0), 17));
}

TEST_CASE("furnace: a coated ball of glass that disperses disappears") {
    World world;
    world.add(Sphere{V3f(0), 1}, film("BK7", 100));
    world.commit();
    checkInvisible(world, Camera(V3f(0, 0, 8), V3f(0), 17));
}

TEST_SUITE_END();
