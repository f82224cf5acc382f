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

// The paper behind.

constexpr float back = 1.15f, bend = 0.9f; ///< the distance of its upright part from the lenses, the radius of its bend

/// A sheet that lies on the table and rises behind the lenses.
Mesh paper() {
    constexpr float front = 9, high = 6, half = 14;
    const float arc = bend * pi / 2, length = front + arc + high;
    return gridMesh({1, 160}, [=](float u, float v) {
        const float x = lerp(-half, half, u), along = v * length;
        if (along < front) return V3f(x, 0, front - back + bend - along);
        if (along > front + arc) return V3f(x, bend + along - front - arc, -back);
        const float angle = (along - front) / bend;
        return V3f(x, bend * (1 - std::cos(angle)), -back + bend * (1 - std::sin(angle)));
    });
}

/// Lines ten to a unit, every tenth a wide one, on the upright part; below it they fade.
Pattern ruled() {
    constexpr float paperGrey = 0.055f, ink = 0.42f, fine = 0.16f;
    const auto line = [](float x, float period, float width) {
        const float away = std::fabs(x / period - std::round(x / period)) * period;
        return 1 - smoothstep(0.7f * width, width, away);
    };
    return {3, [=](const SurfacePoint &point, float *rgb) {
                const V3f &p = point.position;
                const float wide = std::max(line(p.x, 0.5f, 0.014f), line(p.y, 0.5f, 0.014f));
                const float narrow = std::max(line(p.x, 0.1f, 0.006f), line(p.y, 0.1f, 0.006f));
                const float drawn = std::max(ink * wide, fine * narrow) * smoothstep(0.05f, bend, p.y);
                std::fill_n(rgb, 3, std::max(paperGrey, drawn));
            }};
}

std::vector<View> lenses(const Subject &) {
    auto world = std::make_unique<World>();
    world->add(share(paper()), std::make_shared<Material>(pellicle::BsdfBuilder("lambert"),
                                                          std::vector<VaryingParameter>{{"reflectance", 0, 1, ruled()}}));
    const auto mount = std::make_shared<Material>(
        pellicle::BsdfBuilder("metallic_roughness").set("base_color", 0.02f).set("roughness", 0.4f));
    addLens(*world, -spacing, bareLens(), mount);
    addLens(*world, 0, singleCoat(), mount);
    addLens(*world, spacing, broadBandCoat(), mount);
    world->commit();
    std::vector<View> views;
    views.push_back({"", std::move(world), Camera(V3f(0, 1.9f, 15), V3f(0, 1.02f, 0), 10.2f)});
    return views;
}

} // namespace

// H. Macleod, "Thin-Film Optical Filters", section "Antireflection coatings": quarter waves at 550 nm of an index near the
// root of the glass's; and quarter, half, quarter.
pellicle::FilmBuilder bareLens() { return onGlass(); }

pellicle::FilmBuilder singleCoat() { return onGlass().layer("MgF2", 100); }

pellicle::FilmBuilder broadBandCoat() {
    return onGlass().layer("MgF2", 95).layer("Ta2O5", 126).layer("Al2O3", 80);
}

Chapter lensChapter() {
    Scene scene{"lens", "A lens of BK7, bare and coated\nseen through both its faces", {{V2f(5.1f, 2)}, lenses}, 2.2f,
                Lighting::window, 4, 16};
    scene.labels.columns = {"bare", "MgF2, 100 nm", "MgF2, Ta2O5 and Al2O3"};
    return {"lens", 1, {std::move(scene)}};
}

} // namespace render
