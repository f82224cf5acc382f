// Normal maps: frames, what a flat one does, and what tilted ones do to the light.

#include "box.hpp"
#include "footprint.hpp"
#include "normal_map.hpp"
#include "shapes.hpp"
#include "statistics.hpp"

#include <doctest/doctest.h>

#include <ostream>
#include <random>

using namespace render;

namespace {

Pattern constantNormal(const V3f &n) {
    return {3, [n](const SurfacePoint &, float *direction) {
                for (int axis = 0; axis < 3; ++axis) direction[axis] = n[axis];
            }};
}

Pattern ripples() {
    return {3, [](const SurfacePoint &point, float *direction) {
                direction[0] = 1.2f * std::sin(40 * point.uv.x);
                direction[1] = 1.2f * std::sin(31 * point.uv.y);
                direction[2] = 1;
            }};
}

/// Faces +z, u along +x and v along +y.
Mesh wall(float half) {
    Mesh mesh;
    mesh.positions = {{-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    const V3f n(0, 0, 1);
    mesh.normals = {{n, n, n}, {n, n, n}};
    mesh.uvs = {{V2f(0, 0), V2f(1, 0), V2f(1, 1)}, {V2f(0, 0), V2f(1, 1), V2f(0, 1)}};
    return mesh;
}

std::shared_ptr<Material> white() {
    return std::make_shared<Material>(pellicle::BsdfBuilder("lambert").set("reflectance", 1));
}

/// The mean of a small picture of the wall's middle, straight from the front.
RgbEstimate seenOnWall(const V3f &mapped, const Environment &environment, Technique technique) {
    auto material = white();
    material->mapNormals(constantNormal(mapped));
    World world;
    world.add(std::make_shared<Mesh>(wall(2)), material);
    world.commit();
    RenderSettings settings;
    settings.width = settings.height = 8;
    settings.samplesPerPixel = 256;
    settings.path.technique = technique;
    // Narrow, so that all see the wall at a right angle.
    const Camera camera(V3f(0, 0, 5), V3f(0), 1);
    return pictureMean(8, [&](std::uint32_t seed) {
        settings.seed = seed;
        return renderPicture(world, environment, camera, settings);
    });
}

V3f tilted(float degrees) { return {std::sin(radians(degrees)), 0, std::cos(radians(degrees))}; }

} // namespace

TEST_SUITE_BEGIN("normal_maps");

TEST_CASE("tangent frames are orthonormal and follow u and v") {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> uniform(-1, 1);
    const auto vector = [&] { return V3f(uniform(random), uniform(random), uniform(random)); };
    for (int i = 0; i < 5000; ++i) {
        SurfacePoint point;
        point.geometricNormal = vector().normalized();
        point.shading = frameAround((point.geometricNormal + vector() * 0.5f).normalized());
        // A triangle in the surface with texture coordinates that are neither upright nor of its scale;
        // every other one is mirrored.
        const Frame plane = frameAround(point.geometricNormal);
        const std::array<V3f, 3> positions{V3f(0), plane.tangent * 1e-2f,
                                           plane.tangent * 3e-3f + plane.bitangent * 1e-2f};
        const float scale = std::exp(4 * uniform(random)), mirror = i % 2 ? -1.0f : 1.0f;
        const std::array<V2f, 3> uvs{V2f(0.2f, 0.7f), V2f(0.2f, 0.7f) + V2f(scale * mirror, 0.3f * scale),
                                     V2f(0.2f, 0.7f) + V2f(-0.2f * scale * mirror, scale)};
        const TextureTangents tangents = textureTangents(positions, uvs);
        point.alongU = tangents.alongU;
        point.alongV = tangents.alongV;
        // Their meaning: they lead from one corner to the others.
        for (int corner = 1; corner < 3; ++corner) {
            const V2f step = uvs[corner] - uvs[0];
            REQUIRE((tangents.alongU * step.x + tangents.alongV * step.y - positions[corner]).length() <
                    1e-5f);
        }
        const Frame frame = tangentFrame(point);
        REQUIRE(std::fabs(frame.tangent.length() - 1) < 1e-5f);
        REQUIRE(std::fabs(frame.bitangent.length() - 1) < 1e-5f);
        REQUIRE(std::fabs(dot(frame.tangent, frame.bitangent)) < 1e-5f);
        REQUIRE(std::fabs(dot(frame.tangent, frame.normal)) < 1e-5f);
        REQUIRE(std::fabs(dot(frame.bitangent, frame.normal)) < 1e-5f);
        REQUIRE(dot(frame.tangent, point.alongU) > 0);
        REQUIRE(dot(frame.bitangent, point.alongV) > 0);
        REQUIRE(mappedNormal(point, V3f(0, 0, 1)) == point.shading.normal);
    }
}

TEST_CASE("without texture coordinates the frame is the shading frame") {
    SurfacePoint point;
    point.shading = frameAround(V3f(0.6f, 0, 0.8f));
    CHECK(tangentFrame(point).tangent == point.shading.tangent);
}

TEST_CASE("a flat map changes no pixel") {
    auto bunny = std::make_shared<Mesh>(readObj(BUNNY));
    standOnFloor(*bunny);
    const auto rendered = [&](bool mapped) {
        auto material = std::make_shared<Material>(
            pellicle::BsdfBuilder("phong").set("diffuse", 0.4f).set("specular", 0.5f).set("exponent", 40));
        if (mapped) material->mapNormals(constantNormal(V3f(0, 0, 1)));
        World world;
        world.add(std::make_shared<Mesh>(placed(roundedBox(0.7f, 0.2f), 30, V3f(-1.2f, 0.7f, 0))), material);
        world.add(Sphere{V3f(1.2f, 0.7f, 0.5f), 0.7f}, material);
        world.add(std::make_shared<Mesh>(placed(*bunny, 0, V3f(0, 0, -1))), material);
        world.commit();
        RenderSettings settings;
        settings.width = settings.height = 64;
        settings.samplesPerPixel = 4;
        const Environment sky(drawLatLong(8, [](const V3f &d) { return Rgb(1 + d.y, 1 + d.x, 1.5f); }));
        return renderPicture(world, sky, Camera(V3f(0, 1, 6), V3f(0, 0.8f, 0), 36), settings);
    };
    const Picture plain = rendered(false), flat = rendered(true);
    int different = 0;
    for (std::size_t i = 0; i < plain.pixels.size(); ++i)
        different += plain.pixels[i].radiance != flat.pixels[i].radiance;
    CHECK(different == 0);
}

TEST_CASE("the viewer's mirror image stays above the surface") {
    std::mt19937 random(9);
    std::uniform_real_distribution<float> uniform(-1, 1);
    const auto direction = [&] {
        V3f v;
        do v = V3f(uniform(random), uniform(random), uniform(random));
        while (v.length() > 1 || v.length() < 0.01f);
        return v.normalized();
    };
    const V3f geometric(0, 0, 1);
    for (int i = 0; i < 20000; ++i) {
        V3f toViewer = direction(), normal = direction();
        toViewer.z = std::fabs(toViewer.z);
        normal.z = std::fabs(normal.z);
        const V3f kept = keepReflectionAbove(normal, geometric, geometric, toViewer);
        REQUIRE(std::fabs(kept.length() - 1) < 1e-5f);
        const auto image = [&](const V3f &n) { return n * (2 * dot(toViewer, n)) - toViewer; };
        REQUIRE(image(kept).z > std::min(0.0099f, 0.5f * toViewer.z));
        REQUIRE(dot(kept, toViewer) > 0);
        if (image(normal).z > 0.0101f) REQUIRE(kept == normal);
    }
}

TEST_CASE("furnace: a tilted white wall loses the light that its surface hides") {
    // A Lambertian surface's light is distributed as the cosine to its normal; a plane tilted by an
    // angle hides (1 - cos angle) / 2 of it. Beyond 45 degrees the viewer's mirror image would be hidden
    // too: there the normal is turned back until the image is 0.01 above, which from straight in front
    // means a cosine of sqrt((1 + 0.01) / 2), less the shortening of the raised direction: by bisecting
    // the viewer and the direction of height 0.01 beside the one that was too low.
    const Environment room = Environment::constant(Rgb(1));
    for (const float degrees : {0.0f, 30.0f, 44.0f}) {
        CAPTURE(degrees);
        const double expected = (1 + std::cos(radians(degrees))) / 2;
        for (const Technique technique : {Technique::combined, Technique::light, Technique::bsdf}) {
            const RgbEstimate seen = seenOnWall(tilted(degrees), room, technique);
            CHECK(seen[1].standardError < 2e-3);
            CHECK(agree(seen[1], {expected, 1e-4}));
        }
    }
    const V3f image(std::sin(radians(140)), 0, std::cos(radians(140)));
    const V3f raised = V3f(image.x, 0, 0.01f).normalized();
    const double cosine = std::sqrt((1 + raised.z) / 2);
    CHECK(agree(seenOnWall(tilted(70), room, Technique::combined)[1], {(1 + cosine) / 2, 1e-4}));
}

TEST_CASE("normals lean along u and v") {
    const auto seen = [&](const V3f &mapped, const V3f &from) {
        const Environment side(
            drawLatLong(32, [&](const V3f &d) { return Rgb(dot(d, from) > 0.5f ? 1.0f : 0.0f); }));
        return seenOnWall(mapped, side, Technique::combined)[1].mean;
    };
    CHECK(seen(V3f(0.5f, 0, 1), V3f(1, 0, 0)) > 1.5 * seen(V3f(0.5f, 0, 1), V3f(-1, 0, 0)));
    CHECK(seen(V3f(0, 0.5f, 1), V3f(0, 1, 0)) > 1.5 * seen(V3f(0, 0.5f, 1), V3f(0, -1, 0)));
}

TEST_CASE("furnace: a rippled white mesh is never brighter than the room") {
    auto material = white();
    material->mapNormals(ripples());
    World world;
    world.add(std::make_shared<Mesh>(placed(roundedBox(0.9f, 0.3f), 30, V3f(0))), material);
    world.commit();
    const Environment room = Environment::constant(Rgb(1));
    RenderSettings settings;
    settings.width = settings.height = 32;
    settings.samplesPerPixel = 64;
    RgbEstimate byTechnique[3];
    for (const Technique technique : {Technique::combined, Technique::light, Technique::bsdf}) {
        settings.path.technique = technique;
        byTechnique[static_cast<int>(technique)] = pictureMean(8, [&](std::uint32_t seed) {
            settings.seed = seed;
            return renderPicture(world, room, Camera(V3f(0, 2, 5), V3f(0), 30), settings);
        });
    }
    for (const RgbEstimate &mean : byTechnique) {
        CHECK(mean[1].mean <= 1 + 4 * mean[1].standardError);
        CHECK(mean[1].mean > 0.8); // nothing black
        CHECK(agree(mean[1], byTechnique[0][1]));
    }
}

TEST_CASE("ambient light is what the material returns of it, everywhere") {
    auto material = white();
    material->reflectAmbient(Rgb(0.5f, 0.25f, 0.125f));
    World world;
    world.add(std::make_shared<Mesh>(wall(2)), material);
    world.setAmbient(Rgb(0.8f, 0.4f, 0.2f));
    world.commit();
    RenderSettings settings;
    settings.width = settings.height = 4;
    settings.samplesPerPixel = 1;
    const Picture picture =
        renderPicture(world, Environment::constant(Rgb(0)), Camera(V3f(0, 0, 5), V3f(0), 10), settings);
    for (const Pixel &pixel : picture.pixels) {
        CHECK(pixel.radiance.x == doctest::Approx(0.4f));
        CHECK(pixel.radiance.y == doctest::Approx(0.1f));
        CHECK(pixel.radiance.z == doctest::Approx(0.025f));
    }
}

TEST_SUITE_END();
