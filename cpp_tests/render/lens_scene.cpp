// A lens of glass three times: bare, with a quarter wave on it, and with three layers.

#include "lenses.hpp"
#include "scenes.hpp"
#include "shapes.hpp"

#include <algorithm>

namespace render {
namespace {

std::shared_ptr<const Mesh> share(Mesh mesh) { return std::make_shared<Mesh>(std::move(mesh)); }

pellicle::FilmBuilder onGlass() { return pellicle::FilmBuilder("BK7").ambient("air").white("D65").transmittance(); }

// The lens.

constexpr float aperture = 0.95f, sphere = 2.1f, edge = 0.06f;
constexpr float spacing = 2.4f, height = 1.08f, turn = -14;

void addLens(World &world, float x, const pellicle::FilmBuilder &coat,
             const std::shared_ptr<const Material> &mount) {
    const V3f centre(x, height, 0), axis(std::sin(radians(turn)), 0, std::cos(radians(turn)));
    world.add(share(facing(lens(aperture, sphere, edge), turn, centre)),
              std::make_shared<Material>(pellicle::BsdfBuilder("film").film(coat.create())));
    world.add(share(ring(centre, axis, aperture + 0.02f, 0.13f)), mount);
}

// The chart behind, and the table.

/// So far behind that little of its light comes through the lenses: caustics would be grainy.
constexpr float distance = 5.5f;

Mesh chart() {
    constexpr float half = 14, high = 12;
    return gridMesh({1, 1}, [=](float u, float v) { return V3f(lerp(-half, half, u), high * v, -distance); });
}

/// Lines ten to a unit, and a wide one in five.
Pattern ruled() {
    constexpr float ground = 0.03f, fine = 0.13f, wide = 0.4f;
    const auto line = [](float x, float period, float width) {
        const float away = std::fabs(x / period - std::round(x / period)) * period;
        return 1 - smoothstep(0.8f * width, width, away);
    };
    const auto lines = [line](const V3f &p, float period, float width) {
        return std::max(line(p.x, period, width), line(p.y, period, width));
    };
    return {3, [=](const SurfacePoint &point, float *rgb) {
                const V3f &p = point.position;
                const float ink = std::max(wide * lines(p, 0.75f, 0.028f), fine * lines(p, 0.15f, 0.011f));
                std::fill_n(rgb, 3, std::max(ground, ink));
            }};
}

std::vector<View> lenses(const Subject &) {
    auto world = std::make_unique<World>();
    world->add(share(chart()), std::make_shared<Material>(pellicle::BsdfBuilder("lambert"),
                                                          std::vector<VaryingParameter>{{"reflectance", 0, 1, ruled()}}));
    world->add(share(square(30)),
               std::make_shared<Material>(
                   pellicle::BsdfBuilder("lambert").set("reflectance", 0.012f)));
    const auto mount = std::make_shared<Material>(
        pellicle::BsdfBuilder("metallic_roughness").set("base_color", 0.02f).set("roughness", 0.4f));
    addLens(*world, -spacing, bareLens(), mount);
    addLens(*world, 0, singleCoat(), mount);
    addLens(*world, spacing, broadBandCoat(), mount);
    world->commit();
    std::vector<View> views;
    views.push_back({"", std::move(world), Camera(V3f(0, 1.9f, 15), V3f(0, 1.06f, 0), 11)});
    return views;
}

} // namespace

// H. Macleod, "Thin-Film Optical Filters", chapter "Antireflection coatings": a quarter wave at 550 nm of an index near the
// root of the glass's; and three layers, low, high and medium, whose thicknesses leave a weak blue-green.
pellicle::FilmBuilder bareLens() { return onGlass(); }

pellicle::FilmBuilder singleCoat() { return onGlass().layer("MgF2", 100); }

pellicle::FilmBuilder broadBandCoat() {
    return onGlass().layer("MgF2", 86).layer("Ta2O5", 111).layer("Al2O3", 52);
}

Chapter lensChapter() {
    Scene scene{"lens", "A lens of BK7, bare and coated\nseen through both its faces", {{V2f(5.1f, 2)}, lenses}, 2.2f,
                Lighting::window, 4, 16};
    scene.labels.columns = {"bare", "MgF2, 100 nm", "MgF2, Ta2O5, Al2O3: 86, 111, 52 nm"};
    return {"lens", 1, {std::move(scene)}};
}

} // namespace render
