// What coats do for a lens, measured in pictures of one: light meets a film from without and from within.

#include "hue.hpp"
#include "lenses.hpp"
#include "shapes.hpp"
#include "statistics.hpp"

#include <doctest/doctest.h>

using namespace render;

namespace {

/// Up to a part of the number; doctest adds 1 to it otherwise.
doctest::Approx within(float expected, float part) { return doctest::Approx(expected).epsilon(part).scale(0); }

/// What the lens sends to a camera on its axis, of white light of radiance 1 from the hemisphere before it or from that
/// behind it.
enum class LightFrom { front, back };

RgbEstimate onAxis(const pellicle::Film &film, LightFrom from) {
    World world;
    world.add(std::make_shared<Mesh>(facing(lens(0.95f, 2.1f, 0.06f), 0, V3f(0))),
              std::make_shared<Material>(pellicle::BsdfBuilder("film").film(film)));
    world.commit();
    const Environment light(drawLatLong(64, [=](const V3f &direction) {
        return Rgb((direction.z > 0) == (from == LightFrom::front) ? 1.0f : 0.0f);
    }));
    RenderSettings settings;
    settings.width = settings.height = 8;
    settings.samplesPerPixel = 16;
    settings.path.maxBounces = 32;
    return pictureMean(4, [&](std::uint32_t seed) {
        settings.seed = seed;
        return renderPicture(world, light, Camera(V3f(0, 0, 12), V3f(0), 0.2f), settings);
    });
}

/// What both faces reflect and transmit together at normal incidence: a geometric series of the light between them.
struct Faces {
    Rgb reflectance, transmittance;
};
Faces bothFaces(const pellicle::Film &film) {
    const pellicle::FilmColors out = film.eval(1), in = film.eval(1, 0, PELLICLE_SIDE_BASE);
    Faces faces;
    for (int c = 0; c < 3; ++c) {
        const float through = out.transmittance[c] * in.transmittance[c], back = in.reflectance[c];
        faces.reflectance[c] = out.reflectance[c] + through * back / (1 - back * back);
        faces.transmittance[c] = through / (1 - back * back);
    }
    return faces;
}

} // namespace

TEST_SUITE_BEGIN("lens_claims");

TEST_CASE("a coated lens reflects less than a bare one, by the factor that its film predicts, and is clearer") {
    const auto measured = [](const pellicle::FilmBuilder &coat) {
        const pellicle::Film film = coat.create();
        const RgbEstimate reflected = onAxis(film, LightFrom::front), transmitted = onAxis(film, LightFrom::back);
        const Faces faces = bothFaces(film);
        Faces found;
        for (int c = 0; c < 3; ++c) {
            CAPTURE(c);
            MESSAGE(reflected[c].mean, " and ", transmitted[c].mean, " +- ", transmitted[c].standardError);
            found.reflectance[c] = static_cast<float>(reflected[c].mean);
            found.transmittance[c] = static_cast<float>(transmitted[c].mean);
            CHECK(found.reflectance[c] == within(faces.reflectance[c], 0.01f));
            CHECK(found.transmittance[c] == within(faces.transmittance[c], 0.001f));
        }
        return found;
    };
    // Two faces of reflectance R reflect 2 R / (1 + R); R is 4.24 % of bare glass (index 1.519 at 550 nm) and 1.25 % behind
    // a quarter wave of index 1.38.
    const Faces bare = measured(bareLens()), single = measured(singleCoat()), three = measured(broadBandCoat());
    CHECK(bare.reflectance.y == within(0.0813f, 0.01f));
    CHECK(single.reflectance.y == within(0.0247f, 0.05f));
    CHECK(three.reflectance.y < single.reflectance.y / 2);
    CHECK(bare.transmittance.y == within(1 - 0.0813f, 0.001f));
    CHECK(single.transmittance.y > bare.transmittance.y + 0.05f);
    CHECK(three.transmittance.y > single.transmittance.y);
    const double purple = perceived(single.reflectance).hue, cyan = perceived(three.reflectance).hue;
    MESSAGE("hues ", purple, " and ", cyan);
    CHECK((hues::violet.contains(purple) || hues::blueViolet.contains(purple)));
    CHECK(hues::blueGreen.contains(cyan));
}

TEST_SUITE_END();
