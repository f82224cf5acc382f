#include "view.hpp"

#include "shapes.hpp"
#include "stage.hpp"

namespace render {
namespace {

std::shared_ptr<const Material> grey(float reflectance) {
    return std::make_shared<Material>(pellicle::BsdfBuilder("lambert").set("reflectance", reflectance));
}

std::shared_ptr<const Mesh> share(Mesh mesh) { return std::make_shared<Mesh>(std::move(mesh)); }

std::unique_ptr<World> committed(std::unique_ptr<World> world) {
    world->commit();
    return world;
}

/// Two squares.
Views pair(std::function<std::vector<View>(const Subject &)> make) {
    return {{V2f(1), V2f(1)}, std::move(make)};
}

std::vector<View> sphereAndMeshOf(const std::shared_ptr<const Material> &material, const Subject &mesh,
                                  Floor floor) {
    std::vector<View> views;
    views.push_back({"sphere", stage(nullptr, material, floor), stageCamera()});
    views.push_back({mesh.name, stage(mesh.mesh, material, floor), stageCamera()});
    return views;
}

std::vector<View> bubbleAndFrameOf(const std::shared_ptr<const Material> &material) {
    auto bubble = std::make_unique<World>();
    bubble->add(Sphere{V3f(0), 1}, material);

    // Turned so that the camera sees the soft box on the left in it.
    const float turn = radians(-29);
    const V3f normal(std::sin(turn), 0, std::cos(turn));
    auto frame = std::make_unique<World>();
    frame->add(share(disc(V3f(0), normal, 1)), material);
    frame->add(share(ring(V3f(0), normal, 1.02f, 0.06f)), grey(0.03f));

    const Camera camera(V3f(0, 0, 8), V3f(0), 17);
    std::vector<View> views;
    views.push_back({"bubble", committed(std::move(bubble)), camera});
    views.push_back({"frame", committed(std::move(frame)), camera});
    return views;
}

std::vector<View> dishOf(const std::shared_ptr<const Material> &material) {
    const auto world = [&] {
        auto dish = std::make_unique<World>();
        dish->add(share(square(60)), grey(0.01f));
        dish->add(share(disc(V3f(0, 0.06f, 0), V3f(0, 1, 0), 1)), material);
        dish->add(share(ring(V3f(0, 0.06f, 0), V3f(0, 1, 0), 1.03f, 0.1f)), grey(0.02f));
        return committed(std::move(dish));
    };
    const auto camera = [](float elevation, float fieldOfView) {
        const V3f target(0, 0.06f, 0);
        const V3f eye(0, std::sin(radians(elevation)), std::cos(radians(elevation)));
        return Camera(target + eye * 8, target, fieldOfView);
    };
    std::vector<View> views;
    views.push_back({"above", world(), camera(60, 16)});
    views.push_back({"side", world(), camera(32, 16)});
    return views;
}

std::vector<View> waferAndMeshOf(const std::shared_ptr<const Material> &material, const Subject &mesh,
                                 Floor floor) {
    const float lean = radians(42);
    std::vector<View> views;
    views.push_back({"wafer",
                     stage(share(disc(V3f(0, 0.92f, 0), V3f(0, std::sin(lean), std::cos(lean)), 1.2f)),
                           material, floor),
                     stageCamera()});
    views.push_back({mesh.name, stage(mesh.mesh, material, floor), stageCamera()});
    return views;
}

} // namespace

Views sphereAndMesh(MakeMaterial material, Floor floor) {
    return pair([=](const Subject &mesh) { return sphereAndMeshOf(material(), mesh, floor); });
}

Views bubbleAndFrame(MakeMaterial material) {
    return pair([=](const Subject &) { return bubbleAndFrameOf(material()); });
}

Views dish(MakeMaterial material) {
    return pair([=](const Subject &) { return dishOf(material()); });
}

Views waferAndMesh(MakeMaterial material, Floor floor) {
    return pair([=](const Subject &mesh) { return waferAndMeshOf(material(), mesh, floor); });
}

} // namespace render
