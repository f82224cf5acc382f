#include "stage.hpp"

#include "shapes.hpp"

namespace render {

// The light being infinitely far away it falls on the whole floor alike; a painted vignette gives the
// background its depth.
void addFloor(World &world, Floor floor, float from, float to) {
    auto paint = std::make_shared<Material>(
        pellicle::BsdfBuilder("lambert"),
        std::vector<VaryingParameter>{{"reflectance", 0, 1, fadingGrey(floor.centre, floor.rim, from, to)}});
    world.add(std::make_shared<Mesh>(square(60)), std::move(paint));
}

std::unique_ptr<World> stage(std::shared_ptr<const Mesh> mesh, std::shared_ptr<const Material> material,
                             Floor floor) {
    auto world = std::make_unique<World>();
    addFloor(*world, floor, 0.5f, 11.0f);
    if (mesh)
        world->add(std::move(mesh), std::move(material));
    else
        world->add(Sphere{V3f(0, 1, 0), 1}, std::move(material));
    world->commit();
    return world;
}

/// Looks down just enough to keep the floor's horizon out of the picture.
Camera stageCamera() { return {V3f(0, 3.3f, 8.6f), V3f(0, 0.92f, 0), 19}; }

} // namespace render
