// Three ways to the reflection of an environment: each against what is known without it.

#include "environment_ways.hpp"

#include "glossy_metal.hpp"
#include "temporary.hpp"

#include <doctest/doctest.h>

#include <ostream>

using namespace render;

namespace {

/// Uneven and smooth, brighter towards the upper left.
Rgb glow(const V3f &direction) {
    const float lamp = std::exp(6 * (dot(direction, V3f(-0.6f, 0.64f, 0.48f)) - 1));
    return Rgb(0.3f) + Rgb(4, 3, 2) * lamp + Rgb(0, 0.1f, 0.2f) * (1 + direction.x);
}

/// One bright texel in front of the sphere.
LatLongMap lantern() {
    LatLongMap map = drawLatLong(16, glow);
    map.texels[4 * map.width + 27] = Rgb(300, 200, 100);
    return map;
}

V3f someDirection(int i) {
    const float y = 1 - 2 * (static_cast<float>(i) + 0.5f) / 50, phi = 2.4f * static_cast<float>(i);
    const float s = std::sqrt(1 - y * y);
    return {s * std::cos(phi), y, s * std::sin(phi)};
}

double greatestDifference(const std::vector<Rgb> &a, const std::vector<Rgb> &b) {
    double greatest = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (int c = 0; c < 3; ++c) greatest = std::max(greatest, std::fabs(static_cast<double>(a[i][c]) - b[i][c]));
    return greatest;
}

} // namespace

TEST_SUITE_BEGIN("environment ways");

TEST_CASE("a texture's levels and parts are found, where the map has them") {
    const TemporaryDirectory directory;
    const LatLongMap map = drawLatLong(32, glow);
    const LatLongLight light(map);
    const LatLongTexture levels(mipLevels(map), Layout::levels, directory / "levels.exr");
    for (int i = 0; i < 50; ++i) {
        const V3f direction = someDirection(i);
        for (int c = 0; c < 3; ++c)
            CHECK(levels.radiance(direction, 0, 0)[c] == doctest::Approx(light.radiance(direction)[c]).epsilon(1e-4));
    }

    std::vector<LatLongMap> coloured;
    for (int level = 0; level < 4; ++level) {
        const int height = 8 >> level;
        coloured.push_back({2 * height, height, std::vector<Rgb>(2 * height * height, Rgb(static_cast<float>(level)))});
    }
    const LatLongTexture mip(coloured, Layout::levels, directory / "coloured.exr");
    const LatLongTexture parts(coloured, Layout::parts, directory / "coloured.tif");
    for (int level = 0; level < 4; ++level) {
        CHECK(mip.radiance(V3f(0, 0.6f, 0.8f), 0, static_cast<float>(level)).x == doctest::Approx(level));
        CHECK(parts.radiance(V3f(0, 0.6f, 0.8f), level, 0).y == doctest::Approx(level));
    }
    const float between = mip.radiance(V3f(1, 0, 0), 0, 1.5f).x;
    CHECK(between > 1.2f);
    CHECK(between < 1.8f);
}

TEST_CASE("smaller sizes have the map's mean") {
    const std::vector<LatLongMap> levels = mipLevels(lantern());
    REQUIRE(levels.size() == 5);
    REQUIRE(levels.back().height == 1);
    const auto mean = [](const LatLongMap &map) {
        double sum = 0;
        for (int row = 0; row < map.height; ++row) {
            const double solidAngle = std::cos(M_PI * row / map.height) - std::cos(M_PI * (row + 1) / map.height);
            for (int column = 0; column < map.width; ++column)
                sum += map.texels[row * map.width + column].x * solidAngle / (2 * map.width);
        }
        return sum;
    };
    for (const LatLongMap &level : levels) CHECK(mean(level) == doctest::Approx(mean(levels.front())).epsilon(1e-5));
    CHECK_THROWS_AS(mipLevels(LatLongMap{6, 3, std::vector<Rgb>(18)}), std::invalid_argument);
}

TEST_CASE("a constant environment stays the same when prefiltered") {
    const Rgb radiance(0.5f, 2, 7);
    for (const float roughness : {0.1f, 0.5f, 1.0f}) {
        const LatLongMap map = prefiltered(Environment::constant(radiance), roughness, 8, 16);
        REQUIRE(map.texels.size() == 128);
        CHECK(greatestDifference(map.texels, std::vector<Rgb>(128, radiance)) < 1e-5 * 7);
    }
}

TEST_CASE("a prefiltered texel is the mean over the facing lobe, by quadrature") {
    const LatLongMap map = lantern();
    const LatLongLight light(map);
    const float roughness = 0.6f;
    const LatLongMap result = prefiltered(Environment(map), roughness, 4, 1 << 14);
    // GGX seen from the normal has the density D(h) (n.h) / (4 (h.wi)) = D(h) / 4 of wi, as n.h = h.wi.
    const double alpha2 = std::pow(roughness, 4);
    for (const int row : {1, 2}) {
        const int column = 6;
        const V3f normal = latLongDirection((column + 0.5f) / 8, std::cos(pi * (static_cast<float>(row) + 0.5f) / 4));
        double sum = 0, weights = 0;
        constexpr int rows = 1024, columns = 2048;
        for (int y = 0; y < rows; ++y) {
            for (int x = 0; x < columns; ++x) {
                const V3f wi = latLongDirection((static_cast<float>(x) + 0.5f) / columns,
                                                1 - 2 * (static_cast<float>(y) + 0.5f) / rows);
                const double cosine = dot(normal, wi);
                if (cosine <= 0) continue;
                const double nh2 = (1 + cosine) / 2, bottom = nh2 * (alpha2 - 1) + 1;
                const double weight = alpha2 / (bottom * bottom) * cosine;
                sum += weight * light.radiance(wi).x;
                weights += weight;
            }
        }
        CHECK(result.texels[row * 8 + column].x == doctest::Approx(sum / weights).epsilon(0.01));
    }
}

TEST_CASE("the albedo table gives what a white furnace returns") {
    const AlbedoTable table;
    double greatest = 0, greatestGrazing = 0;
    for (int i = 0; i < 60; ++i) {
        const float cosine = 0.02f + 0.98f * std::fmod(0.618f * static_cast<float>(i), 1.0f);
        const float roughness = 0.05f + 0.95f * (static_cast<float>(i) + 0.5f) / 60;
        const V3f wo(std::sqrt(1 - cosine * cosine), 0, cosine);
        const auto albedo = glossyMetal(roughness, Rgb(1, 0, 0.5f), Rgb(0, 1, 0.5f)).albedo(&wo.x);
        const V2f factors = table.at(cosine, roughness);
        for (const double difference :
             {albedo[0] - factors.x, albedo[1] - factors.y, albedo[2] - (factors.x + factors.y) / 2})
            (cosine < 0.1f ? greatestGrazing : greatest) =
                std::max(cosine < 0.1f ? greatestGrazing : greatest, std::fabs(difference));
    }
    CAPTURE(greatest);
    CAPTURE(greatestGrazing);
    CHECK(greatest < 2e-3);
    CHECK(greatestGrazing < 1.2e-2); // near-mirrors bend where the cosine is about alpha

    // The same through the ways themselves.
    const TemporaryDirectory directory;
    const PreparedEnvironment white("white", drawLatLong(16, [](const V3f &) { return Rgb(1); }), directory / "maps");
    const std::vector<SpherePixel> pixels = spherePixels(12);
    for (const float roughness : {0.2f, 0.7f}) {
        const Truth expected = truth(white, roughness, 256, 8, pixels);
        REQUIRE(deviation(expected.mean, expected).noise < 1e-3);
        CHECK(greatestDifference(evaluated(splitSumWay(white, table, roughness), pixels), expected.mean) < 8e-3);
    }
}

TEST_CASE("the split sum tends to the mirror's image") {
    const TemporaryDirectory directory;
    const AlbedoTable table;
    const LatLongMap map = drawLatLong(16, glow);
    const PreparedEnvironment environment("glow", map, directory / "maps");
    const LatLongLight light(map);
    const std::vector<SpherePixel> pixels = spherePixels(20);
    std::vector<Rgb> mirrored;
    for (const SpherePixel &pixel : pixels) {
        const float cosine = pixel.frame.normal.z;
        const Rgb fresnel = goldF0 + (Rgb(1) - goldF0) * std::pow(1 - cosine, 5.0f);
        mirrored.push_back(light.radiance(pixel.frame.normal * (2 * cosine) - V3f(0, 0, 1)) * fresnel);
    }
    const auto error = [&](float roughness) {
        return greatestDifference(evaluated(splitSumWay(environment, table, roughness), pixels), mirrored);
    };
    const double none = error(0), little = error(0.02f), more = error(0.1f);
    CAPTURE(none);
    CAPTURE(little);
    CAPTURE(more);
    CHECK(none < 0.02); // that of the table, at the outline
    CHECK(little < 0.4 * more);
    CHECK(more < 0.2);
}

TEST_CASE("filtered sampling converges to the truth") {
    const TemporaryDirectory directory;
    const PreparedEnvironment environment("glow", drawLatLong(16, glow), directory / "maps");
    const std::vector<SpherePixel> pixels = spherePixels(12);
    for (const float roughness : {0.3f, 0.7f}) {
        const Truth expected = truth(environment, roughness, 256, 8, pixels);
        const auto error = [&](int samples) {
            return deviation(evaluated(filteredWay(environment, roughness, samples), pixels), expected).rms;
        };
        const double few = error(16), many = error(4096);
        CAPTURE(few);
        CAPTURE(many);
        CHECK(many < 0.2 * few);
        CHECK(many < 4e-3);
    }
}

TEST_CASE("the truth of a pixel is the integral over the map") {
    const TemporaryDirectory directory;
    const LatLongMap map = lantern();
    const PreparedEnvironment environment("lantern", map, directory / "maps");
    const LatLongLight light(map);
    const std::vector<SpherePixel> all = spherePixels(9);
    for (const std::size_t index : {std::size_t{20}, all.size() / 2}) {
        const SpherePixel &pixel = all[index];
        const float roughness = 0.5f;
        const pellicle::Bsdf bsdf = glossyMetal(roughness, goldF0, Rgb(1));
        const V3f wo = pixel.frame.toLocal(sphereToViewer);
        double integral = 0;
        constexpr int rows = 1024, columns = 2048;
        for (int y = 0; y < rows; ++y) {
            for (int x = 0; x < columns; ++x) {
                const V3f direction = latLongDirection((static_cast<float>(x) + 0.5f) / columns,
                                                       1 - 2 * (static_cast<float>(y) + 0.5f) / rows);
                const V3f wi = pixel.frame.toLocal(direction);
                if (wi.z > 0) integral += bsdf.value(&wo.x, &wi.x)[1] * light.radiance(direction).y;
            }
        }
        integral *= 4 * M_PI / (static_cast<double>(rows) * columns);
        const Truth estimate = truth(environment, roughness, 1024, 16, {pixel});
        const double standardError = std::sqrt(estimate.variance[0].y);
        CHECK(standardError < 4e-3 * integral);
        CHECK(std::fabs(estimate.mean[0].y - integral) < 4 * standardError + 1e-4 * integral);
    }
}

TEST_CASE("deviations are relative to the truth") {
    const Truth expected{{Rgb(1), Rgb(3)}, {Rgb(0.05f), Rgb(0.15f)}};
    const Deviation result = deviation({Rgb(2), Rgb(3)}, expected);
    CHECK(result.rms == doctest::Approx(std::sqrt(0.1 - 0.02)));
    CHECK(result.bias == doctest::Approx(0.25));
    CHECK(result.noise == doctest::Approx(std::sqrt(0.02)));
}

TEST_SUITE_END();
