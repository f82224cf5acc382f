// The exercise's 25 spheres in a uniformly white room, with a white base colour.

#include "statistics.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <ostream>

using namespace render;

namespace {

/// Smith's Lambda for GGX (E. Heitz, "Understanding the Masking-Shadowing Function in Microfacet-Based
/// BRDFs", JCGT 3(2), 2014, eq. 72).
double lambda(double alpha, double cosine) {
    const double tangent2 = (1 - cosine * cosine) / (cosine * cosine);
    return (std::sqrt(1 + alpha * alpha * tangent2) - 1) / 2;
}

/// What single reflection by GGX's facets returns if they are perfect mirrors: the integral over normals
/// of G2 |wo.h| / (n.o n.h), height-correlated (eq. 99), the normals distributed as in B. Walter et al.,
/// "Microfacet Models for Refraction through Rough Surfaces", EGSR 2007, eq. 35 and 36.
double singleReflection(double alpha, double cosine) {
    constexpr int radii = 256, azimuths = 256;
    const double sine = std::sqrt(1 - cosine * cosine);
    double sum = 0;
    for (int i = 0; i < radii; ++i) {
        const double u = (i + 0.5) / radii;
        const double normal = 1 / std::sqrt(1 + alpha * alpha * u / (1 - u));
        const double across = std::sqrt(1 - normal * normal);
        for (int j = 0; j < azimuths; ++j) {
            const double phi = 2 * static_cast<double>(pi) * (j + 0.5) / azimuths;
            const double half = sine * across * std::cos(phi) + cosine * normal;
            const double reflected = 2 * half * normal - cosine;
            if (half <= 0 || reflected <= 0) continue;
            const double hidden = lambda(alpha, cosine) + lambda(alpha, std::min(reflected, 1.0));
            sum += half / (cosine * normal * (1 + hidden));
        }
    }
    return sum / (radii * azimuths);
}

/// The mean over a sphere's disc, seen from far away.
double singleReflectionOfSphere(double alpha) {
    constexpr int cosines = 32;
    double sum = 0;
    for (int i = 0; i < cosines; ++i) {
        const double squared = (i + 0.5) / cosines; // uniform on the disc
        sum += singleReflection(alpha, std::sqrt(squared));
    }
    return sum / cosines;
}

} // namespace

TEST_SUITE_BEGIN("metallic_furnace");

// Dielectrics return everything, metals what single reflection leaves, and others are between in
// proportion: 1 - metallic (1 - E), within the model's documented 1e-3.
TEST_CASE("furnace: the 25 spheres return all but what single reflection by metals loses") {
    const Environment room = Environment::constant(Rgb(1));
    // A square around the sphere, from far away.
    constexpr float distance = 200, side = 2.1f;
    const Camera camera(V3f(0, 0, distance), V3f(0), 2 * std::atan(side / 2 / distance) * 180 / pi);
    const double covered = static_cast<double>(pi) / (side * side);
    for (const float roughness : {0.0f, 0.25f, 0.5f, 0.75f, 1.0f}) {
        const double single = singleReflectionOfSphere(std::max(1e-4f, roughness * roughness));
        for (const float metallic : {0.0f, 0.25f, 0.5f, 0.75f, 1.0f}) {
            World world;
            world.add(Sphere{V3f(0), 1}, std::make_shared<Material>(pellicle::BsdfBuilder("metallic_roughness")
                                                                        .set("base_color", 1)
                                                                        .set("metallic", metallic)
                                                                        .set("roughness", roughness)));
            world.commit();
            RenderSettings settings;
            settings.width = settings.height = 32;
            settings.samplesPerPixel = 64;
            const RgbEstimate mean = pictureMean(4, [&](std::uint32_t seed) {
                settings.seed = seed;
                return renderPicture(world, room, camera, settings);
            });
            CAPTURE(metallic);
            CAPTURE(roughness);
            const double returned = 1 - (1 - mean[1].mean) / covered;
            const double error = mean[1].standardError / covered;
            const double expected = 1 - metallic * (1 - single);
            MESSAGE("metallic ", metallic, ", roughness ", roughness, ": ", returned, " +- ", error,
                    ", expected ", expected);
            CHECK(error < 2e-3); // else agreement would mean nothing
            CHECK(std::fabs(returned - expected) < 1e-3 + 4 * error);
        }
    }
}

TEST_SUITE_END();
