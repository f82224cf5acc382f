// What the scenes of rough surfaces are to show, measured in their pictures.

#include "spheres_seen.hpp"
#include "stacks.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <ostream>
#include <string>

using namespace render;

namespace {

Environment white() { return Environment::constant(Rgb(1)); }

/// Reflects the room from so far above that no tail of a highlight reaches the floor.
bool facesUp(const Seen &pixel) { return pixel.cosine > 0.8f && pixel.normal.y > 0.7f; }

/// Near the outline, above, where nothing but the room is reflected.
bool isUpperRim(const Seen &pixel) {
    return pixel.cosine > 0.25f && pixel.cosine < 0.4f && pixel.normal.y > 0.9f;
}

float schlick(float f0, float cosine) { return f0 + (1 - f0) * std::pow(1 - cosine, 5.0f); }

/// Fresnel's equations, unpolarised, from vacuum into the index `eta`.
float fresnel(float eta, float cosine) {
    const float transmitted = std::sqrt(1 - (1 - cosine * cosine) / (eta * eta));
    const float s = (cosine - eta * transmitted) / (cosine + eta * transmitted);
    const float p = (eta * cosine - transmitted) / (eta * cosine + transmitted);
    return (s * s + p * p) / 2;
}

/// The mean of a function of the cosine over the same pixels.
float meanOf(const std::vector<Seen> &pixels, const std::function<bool(const Seen &)> &of,
             const std::function<float(float)> &function) {
    float sum = 0, count = 0;
    for (const Seen &pixel : pixels) {
        if (!of(pixel)) continue;
        sum += function(pixel.cosine);
        ++count;
    }
    return sum / count;
}

} // namespace

TEST_SUITE_BEGIN("microfacet_claims");

// N. Hoffman's table of F0 (the lecture; docs/media.md compares it with the library's spectra).
TEST_CASE("metals have the colours of the lecture's table") {
    struct Metal {
        const char *name;
        Rgb f0;
        /// What docs/media.md finds between the sources, and 0.023: single reflection at alpha 0.1 loses 1.5 %,
        /// and the tail of the highlight meets the floor and the neighbours.
        float tolerance;
    };
    const std::array<Metal, 11> table{{{"titanium", {0.542f, 0.497f, 0.449f}, 0.117f},
                                       {"chromium", {0.549f, 0.556f, 0.554f}, 0.024f},
                                       {"iron", {0.562f, 0.565f, 0.578f}, 0.107f},
                                       {"nickel", {0.660f, 0.609f, 0.526f}, 0.061f},
                                       {"platinum", {0.673f, 0.637f, 0.585f}, 0.029f},
                                       {"copper", {0.955f, 0.638f, 0.538f}, 0.062f},
                                       {"palladium", {0.733f, 0.697f, 0.652f}, 0.023f},
                                       {"zinc", {0.664f, 0.824f, 0.850f}, 0.023f},
                                       {"gold", {1.022f, 0.782f, 0.344f}, 0.075f},
                                       {"aluminium", {0.913f, 0.922f, 0.924f}, 0.029f},
                                       {"silver", {0.972f, 0.960f, 0.915f}, 0.086f}}};
    const SpheresSeen spheres("metals", white(), 1, 11, 128, 32);
    std::array<float, 11> warmth;
    for (int i = 0; i < 11; ++i) {
        const Rgb seen = meanRadiance(spheres.at(0, i), facesUp);
        MESSAGE(std::string(table[i].name), ": ", seen.x, " ", seen.y, " ", seen.z);
        for (int c = 0; c < 3; ++c) {
            CAPTURE(c);
            CHECK(std::fabs(seen[c] - std::min(table[i].f0[c], 1.0f)) < table[i].tolerance);
        }
        warmth[i] = seen.x / seen.z;
    }
    // From the warmest to the coldest. Titanium and iron are left out: their sources disagree on it.
    constexpr int nickel = 3, platinum = 4, copper = 5, palladium = 6, zinc = 7, gold = 8, aluminium = 9,
                  silver = 10;
    const std::array order{gold, copper, nickel, platinum, palladium, silver, aluminium, zinc};
    for (std::size_t i = 1; i < order.size(); ++i) {
        CAPTURE(table[order[i]].name);
        CHECK(warmth[order[i]] < warmth[order[i - 1]]);
    }
}

TEST_CASE("without Fresnel there is no bright outline") {
    const SpheresSeen spheres("fresnel", white(), 1, 5, 160, 32);
    const std::array<std::function<float(float)>, 5> expected{
        [](float) { return 0.04f; }, [](float cosine) { return schlick(0.04f, cosine); },
        [](float cosine) { return fresnel(1.5f, cosine); }, [](float) { return 0.172f; },
        [](float cosine) { return fresnel(2.42f, cosine); }};
    for (int i = 0; i < 5; ++i) {
        CAPTURE(i);
        const std::vector<Seen> &pixels = spheres.at(0, i);
        const float centre = meanRadiance(pixels, facesUp).y, rim = meanRadiance(pixels, isUpperRim).y;
        const float expectedRim = meanOf(pixels, isUpperRim, expected[i]);
        MESSAGE("centre ", centre, ", rim ", rim, ", by formula ", expectedRim);
        CHECK(centre == doctest::Approx(meanOf(pixels, facesUp, expected[i])).epsilon(0.02));
        // Masking takes 2 % there, and facets are turned by a few degrees.
        CHECK(rim == doctest::Approx(expectedRim).epsilon(0.04));
    }
}

// M. Oren and S. Nayar, "Generalization of Lambert's Reflectance Model", SIGGRAPH 1994: the full moon
// is as bright at its limb as in its middle. With the light behind the viewer both polar angles are
// equal, and their eq. 30 to 33 have no C3 and no azimuth. Burley's is (1 + (F - 1)(1 - cos)^5)^2 with
// F = 0.5 + 2 roughness.
TEST_CASE("rough matt surfaces look flatter than Lambert's") {
    const V3f toCamera(0, std::sin(radians(14)), std::cos(radians(14)));
    const Environment lamp(drawLatLong(256, [&](const V3f &direction) {
        return Rgb(dot(direction, toCamera) > std::cos(radians(3)) ? 300.0f : 0.0f);
    }));
    const SpheresSeen spheres("diffuse", lamp, 1, 5, 160, 32);
    const auto orenNayar = [](float sigma) {
        const float s = sigma * sigma, c1 = 1 - 0.5f * s / (s + 0.33f), c2 = 0.45f * s / (s + 0.09f);
        return [=](float cosine) {
            const float angle = 2 * std::acos(cosine) / pi;
            return c1 * cosine + c2 * (1 - cosine * cosine) +
                   0.17f * 0.7f * s / (s + 0.13f) * (1 - angle * angle) * cosine;
        };
    };
    const auto disney = [](float roughness) {
        return [=](float cosine) {
            const float f = 1 + (2 * roughness - 0.5f) * std::pow(1 - cosine, 5.0f);
            return cosine * f * f;
        };
    };
    const std::array<std::function<float(float)>, 5> expected{
        [](float cosine) { return cosine; }, orenNayar(0.3f), orenNayar(0.6f), disney(0.5f), disney(1)};
    // On one side: lit by the lamp and by nothing else.
    const auto isCentre = [](const Seen &pixel) { return pixel.cosine > 0.99f; };
    const auto isRim = [](const Seen &pixel) {
        return pixel.cosine > 0.25f && pixel.cosine < 0.4f && pixel.normal.y > 0.3f;
    };
    std::array<float, 5> flatness;
    for (int i = 0; i < 5; ++i) {
        CAPTURE(i);
        const std::vector<Seen> &pixels = spheres.at(0, i);
        flatness[i] = meanRadiance(pixels, isRim).y / meanRadiance(pixels, isCentre).y;
        const float formula = meanOf(pixels, isRim, expected[i]) / meanOf(pixels, isCentre, expected[i]);
        MESSAGE("rim over centre ", flatness[i], ", by formula ", formula);
        CHECK(flatness[i] == doctest::Approx(formula).epsilon(0.04));
    }
    CHECK(flatness[0] < 0.4f);
    CHECK(flatness[1] > 1.4f * flatness[0]);
    CHECK(flatness[2] > 1.2f * flatness[1]);
    CHECK(flatness[4] > flatness[3]);
}

// "Bloby highlights: Beckmann, Phong, Blinn-Phong. Sharp highlights: GGX" (the lecture).
TEST_CASE("GGX has a sharp highlight with a long tail") {
    // One compact lamp in the direction of the camera, in the dark.
    LatLongMap map{64, 32, std::vector<Rgb>(64 * 32, Rgb(0))};
    for (const int column : {0, 63})
        for (const int row : {15, 16}) map.texels[static_cast<std::size_t>(row) * 64 + column] = Rgb(100);
    const Environment lamp(map);
    const auto tail = [&](const char *distribution) {
        const auto bsdf =
            pellicle::BsdfBuilder("microfacet").choose("distribution", distribution).set("alpha", 0.3f);
        World world;
        world.add(Sphere{V3f(0), 1}, std::make_shared<Material>(bsdf));
        world.commit();
        RenderSettings settings;
        settings.width = settings.height = 48;
        settings.samplesPerPixel = 64;
        const Picture picture = renderPicture(world, lamp, Camera(V3f(0, 0, 100), V3f(0), 1.2f), settings);
        double peak = 0, peaks = 0, far = 0, fars = 0;
        for (const Pixel &pixel : picture.pixels) {
            if (pixel.normal.z > 0.99f) peak += pixel.radiance.y, ++peaks;
            // 40 to 50 degrees
            if (pixel.normal.z > 0.643f && pixel.normal.z < 0.766f) far += pixel.radiance.y, ++fars;
        }
        const double ratio = far / fars / (peak / peaks);
        MESSAGE(std::string(distribution), ": ", ratio);
        return ratio;
    };
    const double ggx = tail("ggx");
    for (const char *blob : {"beckmann", "blinn_phong", "sgd"}) CHECK(ggx > 5 * tail(blob));
}

TEST_CASE("reflections blur with roughness") {
    const Environment room = environmentOf(Lighting::window, {});
    for (const char *name : {"spheres", "film-spheres"}) {
        const SpheresSeen spheres(name, room, 5, 5, 96, 64);
        for (int row = 0; row < 5; ++row) {
            CAPTURE(name);
            CAPTURE(row);
            std::array<double, 5> contrasts;
            std::string text;
            for (int column = 0; column < 5; ++column) {
                contrasts[column] = contrast(spheres.at(row, column));
                text += std::to_string(contrasts[column]) + " ";
            }
            MESSAGE(std::string(name), " row ", row, ": ", text);
            for (int column = 1; column < 5; ++column) CHECK(contrasts[column] < 0.97 * contrasts[column - 1]);
        }
    }
}

TEST_CASE("a film on a hardly rough surface has the smooth film's colour") {
    const Environment room = environmentOf(Lighting::window, {});
    const std::array<std::pair<Stack, float>, 3> films{
        {{anodisedTitanium(), 45}, {oxidisedSilicon(), 270}, {{"", "", "PMMA", "Au", 0}, 350}}};
    for (const auto &[stack, thickness] : films) {
        CAPTURE(stack.title);
        const pellicle::Film film = stack.film(thickness).create();
        const auto colour = [&](pellicle::BsdfBuilder bsdf) {
            World world;
            world.add(Sphere{V3f(0), 1},
                      std::make_shared<Material>(bsdf.film(film).set("thickness_nm", thickness)));
            world.commit();
            RenderSettings settings;
            settings.width = settings.height = 64;
            settings.samplesPerPixel = 64;
            const Picture picture = renderPicture(world, room, Camera(V3f(0, 0, 100), V3f(0), 0.8f), settings);
            Rgb sum(0);
            for (const Pixel &pixel : picture.pixels) sum += pixel.radiance;
            return sum / static_cast<float>(picture.pixels.size());
        };
        const Rgb smooth = colour(pellicle::BsdfBuilder("film"));
        for (const float alpha : {0.0f, 1e-3f}) {
            CAPTURE(alpha);
            const Rgb rough =
                colour(pellicle::BsdfBuilder("microfacet").choose("fresnel", "film").set("alpha", alpha));
            for (int c = 0; c < 3; ++c) {
                CAPTURE(c);
                MESSAGE("smooth ", smooth[c], ", alpha ", alpha, ": ", rough[c]);
                CHECK(rough[c] == doctest::Approx(smooth[c]).epsilon(0.01));
            }
        }
    }
}

TEST_SUITE_END();
