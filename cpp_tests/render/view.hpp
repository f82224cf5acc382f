// What a scene's pictures show.
#pragma once

#include "camera.hpp"
#include "stage.hpp"
#include "world.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace render {

/// A mesh that stands on the floor (standOnFloor), and its name.
struct Subject {
    std::string name;
    std::shared_ptr<const Mesh> mesh;
    std::filesystem::path directory{}; ///< for the images that scenes make and read
};

/// One picture. The world is committed.
struct View {
    std::string name; ///< its part of the file's name; empty: the scene's is enough
    std::unique_ptr<World> world;
    Camera camera;
};

/// A scene's pictures, and what they need before they are made.
struct Views {
    std::vector<V2f> extents; ///< width and height of each, in units of the program's --size
    std::function<std::vector<View>(const Subject &mesh)> make; ///< as many as there are extents
};

/// Called for scenes that are rendered and for no others: films take time to compile.
using MakeMaterial = std::function<std::shared_ptr<const Material>()>;

/// The sphere and the mesh, each on the stage.
Views sphereAndMesh(MakeMaterial material, Floor floor = {});

/// A floating sphere, and a vertical film in a wire ring: for what is thin and transparent.
Views bubbleAndFrame(MakeMaterial material);

/// A dish filled to the rim, from above and from the side.
Views dish(MakeMaterial material);

/// A round slice that leans towards the camera, and the mesh on the stage.
Views waferAndMesh(MakeMaterial material, Floor floor);

} // namespace render
