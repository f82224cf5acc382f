// The picture that a visitor sees first: thin films on metal, glass, water and soap, in the evening.

#include "scenes.hpp"
#include "shapes.hpp"
#include "stacks.hpp"

#include <algorithm>

namespace render {
namespace {

using SharedMaterial = std::shared_ptr<const Material>;

std::shared_ptr<const Mesh> share(Mesh mesh) { return std::make_shared<Mesh>(std::move(mesh)); }

Mesh moved(Mesh mesh, const V3f &offset) {
    for (V3f &position : mesh.positions) position += offset;
    return mesh;
}

/// Moved, its lowest point to the height of `offset`.
Mesh standing(Mesh mesh, const V3f &offset) {
    float lowest = mesh.positions.front().y;
    for (const V3f &position : mesh.positions) lowest = std::min(lowest, position.y);
    return moved(std::move(mesh), offset - V3f(0, lowest, 0));
}

/// Linear between the points (x, y), which ascend in x; constant beyond.
float curve(const std::vector<V2f> &points, float x) {
    if (x <= points.front().x) return points.front().y;
    for (std::size_t i = 1; i < points.size(); ++i)
        if (x <= points[i].x)
            return lerp(points[i - 1].y, points[i].y, (x - points[i - 1].x) / (points[i].x - points[i - 1].x));
    return points.back().y;
}

/// A number per point from its place on the object.
Pattern byPlace(std::function<float(const V3f &place)> thickness) {
    return {1, [=](const SurfacePoint &point, float *number) { *number = thickness(point.objectPosition); }};
}

float noise(const V3f &place, int octaves) { return fractalNoise01(place, octaves).value; }

/// Satin metal under a film.
SharedMaterial satin(const Stack &stack, float alpha, float thicknessMax, Pattern thickness) {
    return std::make_shared<Material>(
        pellicle::BsdfBuilder("microfacet").choose("fresnel", "film").set("alpha", alpha).film(
            stack.film(thicknessMax).create()),
        std::vector<VaryingParameter>{{"thickness_nm", 0, thicknessMax, std::move(thickness)}});
}

/// Reflects and transmits, from both sides.
SharedMaterial transparent(pellicle::Medium layer, pellicle::Medium base, float thicknessMax, Pattern thickness) {
    const pellicle::Film film = pellicle::FilmBuilder(std::move(base))
                                    .layer(std::move(layer), 0, thicknessMax)
                                    .white("D65")
                                    .transmittance()
                                    .create();
    return std::make_shared<Material>(
        pellicle::BsdfBuilder("film").film(film),
        std::vector<VaryingParameter>{{"thickness_nm", 0, thicknessMax, std::move(thickness)}});
}

/// N-BK7 at 587.6 nm (Schott's data sheet); the renderer does not split light into its colours.
pellicle::Medium glass() { return pellicle::Medium::constant(1.5168f); }

// Anodised titanium: the oxide grows with the voltage, from gold at the foot to pink at the lip.

Mesh vase() {
    return turned({{0.0f, 0.02f}, {0.2f, 0.0f}, {0.34f, 0.0f}, {0.40f, 0.06f}, {0.56f, 0.28f}, {0.68f, 0.58f},
                   {0.64f, 0.90f}, {0.44f, 1.20f}, {0.25f, 1.46f}, {0.19f, 1.72f}, {0.22f, 1.94f}, {0.33f, 2.08f},
                   {0.34f, 2.10f}, {0.32f, 2.105f}, {0.21f, 1.98f}, {0.17f, 1.72f}, {0.15f, 1.5f}});
}

SharedMaterial vaseMaterial() {
    return satin(anodisedTitanium(), 0.06f, 150, byPlace([](const V3f &place) {
        const float wave = 0.16f * (noise(place * V3f(1.1f, 0.7f, 1.1f), 3) - 0.5f);
        return curve({{0, 14}, {0.3f, 24}, {0.9f, 42}, {1.3f, 66}, {1.7f, 96}, {2.1f, 122}}, place.y + wave);
    }));
}

// Tempered steel: a knot that was heated at its top.

Mesh knot(float size, float tube) {
    const auto curve = [](float t) {
        const float r = 2 + std::cos(3 * t);
        return V3f(-r * std::sin(2 * t), r * std::cos(2 * t), 1.35f * std::sin(3 * t));
    };
    return gridMesh({900, 72, true, true}, [&](float u, float v) {
        const float t = 2 * pi * u, h = 0.01f;
        const V3f before = curve(t - h), here = curve(t), after = curve(t + h);
        const V3f along = (after - before).normalized(), inwards = before + after - here * 2;
        const V3f side = cross(along, inwards).normalized(), normal = cross(side, along);
        const float angle = -2 * pi * v;
        return here * size + (normal * std::cos(angle) + side * std::sin(angle)) * tube;
    });
}

// Glass.

SharedMaterial metal(const char *name, float alpha) {
    return std::make_shared<Material>(pellicle::BsdfBuilder("microfacet")
                                          .choose("fresnel", "conductor")
                                          .choose("metal", name)
                                          .set("alpha", alpha));
}

std::shared_ptr<const Material> black(float reflectance, float roughness) {
    return std::make_shared<Material>(
        pellicle::BsdfBuilder("metallic_roughness").set("base_color", reflectance).set("roughness", roughness));
}

/// A camera's lens that lies on the ground: a barrel with three elements, each with a quarter wave of magnesium
/// fluoride for another colour. `front` is the middle of the barrel's front.
void addCameraLens(World &world, const V3f &front, float degrees) {
    const auto add = [&](Mesh mesh, const SharedMaterial &material) {
        world.add(share(facing(std::move(mesh), degrees, front)), material);
    };
    add(turned({{0.0f, -1.2f}, {0.55f, -1.2f}, {0.57f, -1.18f}, {0.57f, -1.0f}, {0.58f, -0.97f}, {0.66f, -0.93f},
                {0.66f, -0.9f}, {0.66f, -0.42f}, {0.66f, -0.38f}, {0.72f, -0.28f}, {0.72f, -0.22f}, {0.72f, -0.04f},
                {0.715f, 0.0f}, {0.70f, 0.02f}, {0.67f, 0.02f}, {0.65f, 0.0f}, {0.64f, -0.06f}}),
        black(0.025f, 0.36f));
    // The focus ring is knurled.
    add(gridMesh({720, 24, true, false},
                 [](float u, float v) {
                     const float edge = smoothstep(0, 0.06f, v) * smoothstep(0, 0.06f, 1 - v);
                     const float groove = smoothstep(-0.5f, 0.5f, std::sin(2 * pi * 90 * u));
                     const float radius = 0.655f + 0.025f * edge * lerp(0.35f, 1, groove), angle = -2 * pi * u;
                     return V3f(radius * std::cos(angle), lerp(-0.86f, -0.5f, v), radius * std::sin(angle));
                 }),
        black(0.03f, 0.5f));
    add(turned({{0.645f, -0.03f}, {0.60f, -0.16f}, {0.585f, -0.3f}, {0.5f, -0.5f}, {0.4f, -0.8f}, {0.2f, -0.95f},
                {0.0f, -0.96f}}),
        std::make_shared<Material>(pellicle::BsdfBuilder("lambert").set("reflectance", 0.002f)));
    const V3f axis(std::sin(radians(degrees)), 0, std::cos(radians(degrees)));
    world.add(share(ring(front - axis * 0.33f, axis, 0.698f, 0.022f)), metal("Au", 0.1f));

    struct Element {
        float aperture, curvature, place, thickness;
    };
    for (const Element &element : {Element{0.60f, 0.95f, -0.22f, 84}, Element{0.42f, 0.62f, -0.60f, 125}}) {
        add(moved(lens(element.aperture, element.curvature, 0.05f), V3f(0, element.place, 0)),
            transparent("MgF2", glass(), 140, byPlace([=](const V3f &) { return element.thickness; })));
    }
}

// The scene.

SharedMaterial slate() {
    return std::make_shared<Material>(
        pellicle::BsdfBuilder("metallic_roughness").set("base_color", {0.012f, 0.013f, 0.015f}),
        std::vector<VaryingParameter>{{"roughness", 0, 1, byPlace([](const V3f &place) {
            return lerp(0.10f, 0.24f, noise(place * 1.7f + V3f(4.2f), 4));
        })}});
}

/// A flat shape with a wavy outline.
Mesh puddle(const V3f &centre, float width, float depth, float seed) {
    return gridMesh({360, 8, true, false}, [&](float u, float v) {
        const float angle = 2 * pi * u;
        const V3f direction(std::cos(angle), 0, std::sin(angle));
        const float wavy = 0.72f + 0.56f * (noise(direction * 0.9f + V3f(seed), 4) - 0.5f);
        return centre + V3f(direction.x * width, 0, -direction.z * depth) * (wavy * v);
    });
}

std::vector<View> heroView(const Subject &) {
    auto world = std::make_unique<World>();
    world->add(share(disc(V3f(0), V3f(0, 1, 0), 5.4f)), slate());

    world->add(share(moved(vase(), V3f(-2.0f, 0, -0.5f))), vaseMaterial());

    world->add(share(standing(knot(0.27f, 0.175f), V3f(0.05f, 0, -0.35f))),
               satin(temperedSteel(), 0.05f, 90, byPlace([](const V3f &place) {
                   const float heat = (place - V3f(0.75f, 2.0f, 0.0f)).length() / 2.2f;
                   const float uneven = 0.10f * (noise(place * 1.6f, 3) - 0.5f);
                   return lerp(74, 15, std::clamp(heat + uneven, 0.0f, 1.0f));
               })));

    const SharedMaterial soapWall = transparent("water", pellicle::Medium::constant(1), 900, byPlace([](const V3f &place) {
        const V3f stirred = place * 1.15f + V3f(noise(place * 0.9f + V3f(7), 2), 0, noise(place * 0.9f + V3f(3), 2)) * 1.1f;
        const float swirl = noise(V3f(stirred.x, 2.4f * stirred.y, stirred.z), 4);
        return std::clamp(lerp(560, 110, (place.y + 1) / 2) + 380 * (swirl - 0.5f), 10.0f, 890.0f);
    }));
    world->add(Sphere{V3f(1.2f, 2.0f, -1.3f), 0.60f}, soapWall);
    world->add(Sphere{V3f(-0.92f, 2.2f, -1.6f), 0.36f}, soapWall);
    world->add(Sphere{V3f(-0.5f, 1.85f, 0.5f), 0.17f}, soapWall);

    addCameraLens(*world, V3f(2.05f, 0.73f, -0.15f), -27);

    world->add(Sphere{V3f(-0.95f, 0.34f, 1.35f), 0.34f},
               transparent("TiO2", glass(), 320, byPlace([](const V3f &place) {
                   return lerp(120, 300, (place.y + 1) / 2);
               })));

    // A pearl or three.
    const auto pearl = std::make_shared<Material>(
        pellicle::BsdfBuilder("layered")
            .set("eta", {1.53f, 1.54f, 1.56f})
            .set("exponent_reflection", 400)
            .set("exponent_transmission", 60)
            .set("base", {0.92f, 0.89f, 0.86f})
            .set("specular_weight", 0.22f)
            .set("diffuse_weight", 0.78f),
        std::vector<VaryingParameter>{{"thickness_nm", 150, 420, noiseBetween(255, 320, NoiseField{0.7f, 2})}});
    for (const V3f &at : {V3f(1.05f, 0.2f, 1.7f), V3f(1.42f, 0.14f, 1.95f), V3f(0.74f, 0.11f, 2.0f)})
        world->add(Sphere{at, at.y}, pearl);

    world->add(share(puddle(V3f(-0.3f, 0.002f, 1.5f), 3.4f, 1.9f, 2.3f)),
               std::make_shared<Material>(
                   pellicle::BsdfBuilder("film").film(oilOnWater().film(900).create()),
                   std::vector<VaryingParameter>{{"thickness_nm", 0, 900, byPlace([](const V3f &place) {
                       const V3f push(noise(place * 0.8f + V3f(11), 3), 0, noise(place * 0.8f + V3f(5), 3));
                       return lerp(90, 820, noise(place * 0.45f + push * 1.3f, 4));
                   })}}));

    world->commit();
    std::vector<View> views;
    views.push_back({"", std::move(world),
                     Camera(V3f(0.1f, 2.45f, 7.4f), V3f(0.1f, 0.92f, 0), 26.3f, 0.035f, 7.3f)});
    return views;
}

} // namespace

Chapter heroChapter() {
    return {"hero", 1, {{"hero", "Thin films", {{V2f(5, 2.8125f)}, heroView}, 0.7f, Lighting::evening, 4, 16, true}}};
}

} // namespace render
