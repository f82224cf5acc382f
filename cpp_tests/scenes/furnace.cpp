// A sphere in a uniformly white room shows its directional albedo. The renderer must find what a
// plain quadrature of pellicle's eval() finds, whichever way it samples.

#include "statistics.hpp"

#include <doctest/doctest.h>

#include <ostream>

using namespace render;

namespace {

constexpr float distance = 5, fieldOfView = 30;
constexpr int size = 32;

using Albedo = std::array<double, 3>;

/// Midpoint rule over the hemisphere, uniform in solid angle.
Albedo quadrature(const pellicle::Bsdf &bsdf, const V3f &wo) {
    constexpr int cosines = 96, azimuths = 192;
    Albedo sum{};
    for (int i = 0; i < cosines; ++i) {
        const float z = (static_cast<float>(i) + 0.5f) / cosines, r = std::sqrt(1 - z * z);
        for (int j = 0; j < azimuths; ++j) {
            const float phi = 2 * pi * (static_cast<float>(j) + 0.5f) / azimuths;
            const V3f wi(r * std::cos(phi), r * std::sin(phi), z);
            const auto value = bsdf.value(&wo.x, &wi.x);
            for (int c = 0; c < 3; ++c) sum[c] += value[c];
        }
    }
    for (double &channel : sum) channel *= 2 * pi / (cosines * azimuths);
    return sum;
}

/// The picture's mean: 1 where the room is seen, the albedo on the sphere's disc, which is
/// integrated over in polar coordinates around the picture's centre.
Albedo expectedMean(const pellicle::Bsdf &bsdf, double &largestAlbedo) {
    constexpr int radii = 32, azimuths = 24;
    // The sphere's outline on a plane at distance 1, and half that picture's side.
    const float outline = 1 / std::sqrt(distance * distance - 1), half = std::tan(radians(fieldOfView) / 2);
    Albedo mean{1, 1, 1};
    for (int i = 0; i < radii; ++i) {
        const float rho = outline * std::sqrt((static_cast<float>(i) + 0.5f) / radii);
        for (int j = 0; j < azimuths; ++j) {
            const float phi = 2 * pi * (static_cast<float>(j) + 0.5f) / azimuths;
            const V3f ray = V3f(rho * std::cos(phi), rho * std::sin(phi), -1).normalized();
            // From (0, 0, distance) to the unit sphere around the origin.
            const float along = -ray.z * distance;
            const float t = along - std::sqrt(std::max(0.0f, along * along - distance * distance + 1));
            const V3f normal = (V3f(0, 0, distance) + ray * t).normalized();
            const Albedo albedo = quadrature(bsdf, frameAround(normal).toLocal(-ray));
            const double share = pi * outline * outline / (4.0 * half * half) / (radii * azimuths);
            for (int c = 0; c < 3; ++c) {
                mean[c] += share * (albedo[c] - 1);
                largestAlbedo = std::max(largestAlbedo, albedo[c]);
            }
        }
    }
    return mean;
}

RgbEstimate renderedMean(const pellicle::BsdfBuilder &bsdf, Technique technique) {
    World world;
    world.add(Sphere{V3f(0), 1}, std::make_shared<Material>(bsdf));
    world.commit();
    const Environment white = Environment::constant(Rgb(1));
    const Camera camera(V3f(0, 0, distance), V3f(0), fieldOfView);
    RenderSettings settings;
    settings.width = settings.height = size;
    settings.samplesPerPixel = 32;
    settings.path.technique = technique;
    return pictureMean(16, [&](std::uint32_t seed) {
        settings.seed = seed;
        return renderPicture(world, white, camera, settings);
    });
}

void checkFurnace(const pellicle::BsdfBuilder &bsdf, bool conserves) {
    double largestAlbedo = 0;
    const Albedo expected = expectedMean(bsdf.create(), largestAlbedo);
    if (conserves) CHECK(largestAlbedo <= 1.0001); // the quadrature's own error
    for (const Technique technique : {Technique::combined, Technique::light, Technique::bsdf}) {
        CAPTURE(static_cast<int>(technique));
        const RgbEstimate rendered = renderedMean(bsdf, technique);
        for (int c = 0; c < 3; ++c) {
            CAPTURE(c);
            CAPTURE(rendered[c].mean);
            CAPTURE(rendered[c].standardError);
            CAPTURE(expected[c]);
            CHECK(rendered[c].standardError < 2e-3); // else agreement would mean nothing
            // Float sums of a picture's samples are good to 2e-6; that matters where every sample is
            // the same and the error is 0.
            CHECK(agree(rendered[c], {expected[c], 1e-6}));
            if (conserves) CHECK(rendered[c].mean <= 1 + 4 * rendered[c].standardError + 4e-6);
        }
    }
}

pellicle::BsdfBuilder layered(const char *variant, float deviation) {
    return pellicle::BsdfBuilder("layered")
        .choose("variant", variant)
        .set("eta", {1.4f, 1.45f, 1.6f})
        .set("exponent_reflection", 12)
        .set("exponent_transmission", 25)
        .set("thickness_nm", 180)
        .set("base_normal", {std::sin(radians(deviation)), 0, std::cos(radians(deviation))})
        .set("specular_weight", 0.6f)
        .set("diffuse_weight", 0.4f);
}

} // namespace

TEST_SUITE_BEGIN("furnace");

TEST_CASE("a perfectly white sphere disappears") {
    checkFurnace(pellicle::BsdfBuilder("lambert").set("reflectance", 1), true);
}

TEST_CASE("furnace: lambert") {
    checkFurnace(pellicle::BsdfBuilder("lambert").set("reflectance", {0.8f, 0.5f, 0.2f}), true);
}

TEST_CASE("furnace: phong") {
    checkFurnace(
        pellicle::BsdfBuilder("phong").set("diffuse", 0.3f).set("specular", 0.6f).set("exponent", 20), true);
}

TEST_CASE("furnace: layered, energy, parallel boundaries") { checkFurnace(layered("energy", 0), true); }

TEST_CASE("furnace: layered, energy, deviated") { checkFurnace(layered("energy", 14), true); }

TEST_CASE("furnace: layered, paper, deviated") { checkFurnace(layered("paper", 14), false); }

TEST_SUITE_END();
