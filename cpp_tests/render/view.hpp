// What a scene's pictures show.
#pragma once

#include "camera.hpp"
#include "stage.hpp"
#include "world.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace render {

/// A mesh that stands on the floor (standOnFloor), and its name.
struct Subject {
    std::string name;
    std::shared_ptr<const Mesh> mesh;
};

/// One picture. The world is committed.
struct View {
    std::string name; ///< its part of the file's name
    std::unique_ptr<World> world;
    Camera camera;
};

/// The views of a scene, made of its material and of the user's mesh.
using Views =
    std::function<std::vector<View>(const std::shared_ptr<const Material> &material, const Subject &mesh)>;

/// The sphere and the mesh, each on the stage.
Views sphereAndMesh(Floor floor = {});

/// A floating sphere, and a vertical film in a wire ring: for what is thin and transparent.
std::vector<View> bubbleAndFrame(const std::shared_ptr<const Material> &material, const Subject &mesh);

/// A dish filled to the rim, from above and from the side.
std::vector<View> dish(const std::shared_ptr<const Material> &material, const Subject &mesh);

/// A round slice that leans towards the camera, and the mesh on the stage.
Views waferAndMesh(Floor floor);

} // namespace render
