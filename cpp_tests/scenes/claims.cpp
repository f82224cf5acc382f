// What the paper says must be seen, as measurements (X. Granier and W. Heidrich, "A Simple Layered
// RGB BRDF Model", Pacific Graphics 2002, sections 4.3 and 6).

#include "statistics.hpp"

#include <doctest/doctest.h>

#include <ostream>

using namespace render;

namespace {

/// A sphere that fills most of the picture.
Picture renderSphere(std::shared_ptr<const Material> material, const Environment &environment,
                     std::uint32_t seed) {
    World world;
    world.add(Sphere{V3f(0), 1}, std::move(material));
    world.commit();
    RenderSettings settings;
    settings.width = settings.height = 48;
    settings.samplesPerPixel = 16;
    settings.seed = seed;
    return renderPicture(world, environment, Camera(V3f(0, 0, 6), V3f(0), 21), settings);
}

/// Mean colour of a sphere in white light.
Rgb colourOf(std::shared_ptr<const Material> material) {
    const Picture picture = renderSphere(std::move(material), Environment::constant(Rgb(1)), 1);
    Rgb sum(0);
    float pixels = 0;
    for (const Pixel &pixel : picture.pixels) {
        if (pixel.distance < 5) continue; // the outline, mixed with the background
        sum += pixel.radiance;
        ++pixels;
    }
    return sum / pixels;
}

struct Layer {
    std::array<float, 3> eta;
    float exponent, deviation, thickness;
};

/// The colours of a highlight, in degrees on the sphere: the mean angle between the centroids of R, G
/// and B, and the root mean square width of one colour.
struct Highlight {
    double separation, width;
};

Highlight highlightOf(const Layer &layer, std::uint32_t seed) {
    const auto material = std::make_shared<Material>(
        pellicle::BsdfBuilder("layered")
            .choose("variant", "paper")
            .set("eta", {layer.eta[0], layer.eta[1], layer.eta[2]})
            .set("exponent_reflection", layer.exponent)
            .set("exponent_transmission", layer.exponent)
            .set("thickness_nm", layer.thickness)
            .set("base_normal", {std::sin(radians(layer.deviation)), 0, std::cos(radians(layer.deviation))})
            .set("specular_weight", 1)
            .set("diffuse_weight", 0));
    // One compact light in a dark room: the texels around the direction to the camera.
    LatLongMap map{64, 32, std::vector<Rgb>(64 * 32, Rgb(0))};
    for (const int column : {0, 63})
        for (const int row : {15, 16}) map.texels[static_cast<std::size_t>(row) * 64 + column] = Rgb(100);
    const Picture picture = renderSphere(material, Environment(map), seed);

    std::array<V3f, 3> centroid{V3f(0), V3f(0), V3f(0)};
    for (const Pixel &pixel : picture.pixels)
        for (int c = 0; c < 3; ++c) centroid[c] += pixel.normal * pixel.radiance[c];
    for (V3f &direction : centroid) direction.normalize();
    const auto angle = [](const V3f &a, const V3f &b) {
        return 180 / pi * std::atan2(cross(a, b).length(), dot(a, b));
    };
    double squares = 0, weights = 0;
    for (const Pixel &pixel : picture.pixels) {
        for (int c = 0; c < 3; ++c) {
            const double deviation = angle(pixel.normal, centroid[c]);
            squares += pixel.radiance[c] * deviation * deviation;
            weights += pixel.radiance[c];
        }
    }
    return {(angle(centroid[0], centroid[1]) + angle(centroid[1], centroid[2]) +
             angle(centroid[2], centroid[0])) /
                3,
            std::sqrt(squares / weights)};
}

struct HighlightEstimate {
    Estimate separation, separationOverWidth;
};
HighlightEstimate measure(const Layer &layer) {
    std::vector<double> separations, ratios;
    for (std::uint32_t seed = 1; seed <= 6; ++seed) {
        const Highlight highlight = highlightOf(layer, seed);
        separations.push_back(highlight.separation);
        ratios.push_back(highlight.separation / highlight.width);
    }
    return {estimate(separations), estimate(ratios)};
}

constexpr std::array<float, 3> figure5{1.5f, 1.6f, 1.8f};

/// The diffuse part of figure 5, in which the paper shows the colours of thickness.
std::shared_ptr<const Material> diffusePart(float thicknessMin, float thicknessMax) {
    return std::make_shared<Material>(
        pellicle::BsdfBuilder("layered")
            .choose("variant", "paper")
            .set("eta", {figure5[0], figure5[1], figure5[2]})
            .set("specular_weight", 0)
            .set("diffuse_weight", 0.5f),
        std::vector<VaryingParameter>{{"thickness_nm", thicknessMin, thicknessMax,
                                       noiseBetween(thicknessMin, thicknessMax, NoiseField{})}});
}

bool clearlyBelow(const Estimate &a, const Estimate &b) {
    return a.mean + 4 * std::hypot(a.standardError, b.standardError) < b.mean;
}

} // namespace

TEST_SUITE_BEGIN("claims");

TEST_CASE("a thin layer is red, thicker ones are blue and green") {
    const Rgb thin = colourOf(diffusePart(1, 30)), medium = colourOf(diffusePart(79, 106)),
              thick = colourOf(diffusePart(146, 200));
    CHECK(thin.x > 1.01f * thin.y);
    CHECK(thin.y > 1.01f * thin.z);
    CHECK(medium.z > 1.5f * medium.x);
    CHECK(medium.z > 1.5f * medium.y);
    CHECK(thick.y > 1.2f * thick.x);
    CHECK(thick.y > 1.2f * thick.z);
}

TEST_CASE("colours separate more the more the boundaries deviate") {
    Estimate previous{-1, 0};
    for (const float deviation : {0.0f, 4.0f, 8.0f, 14.0f}) {
        const Estimate separation = measure({figure5, 130, deviation, 90}).separation;
        MESSAGE("deviation ", deviation, ": ", separation.mean, " +- ", separation.standardError, " degrees");
        CHECK(clearlyBelow(previous, separation));
        previous = separation;
    }
}

TEST_CASE("colours separate only if indices differ") {
    const Estimate different = measure({figure5, 130, 14, 90}).separation;
    // Without thickness nothing interferes and the prism acts alone.
    const Estimate prism = measure({{1.6f, 1.6f, 1.6f}, 130, 14, 0}).separation;
    CHECK(agree(prism, {0, 1e-5}));
    // Interference weighs the near and the far side of a highlight differently in each colour, which
    // moves the centroids by hundredths of a degree.
    const Estimate film = measure({{1.6f, 1.6f, 1.6f}, 130, 14, 90}).separation;
    MESSAGE("different indices: ", different.mean, ", equal: ", film.mean, " +- ", film.standardError);
    CHECK(film.mean < 0.005 * different.mean);
}

TEST_CASE("low exponents blur the separation") {
    Estimate previous{0, 0};
    for (const float exponent : {5.0f, 20.0f, 130.0f}) {
        const Estimate ratio = measure({figure5, exponent, 14, 90}).separationOverWidth;
        MESSAGE("exponent ", exponent, ": ", ratio.mean, " +- ", ratio.standardError);
        CHECK(clearlyBelow(previous, ratio));
        previous = ratio;
    }
}

TEST_SUITE_END();
