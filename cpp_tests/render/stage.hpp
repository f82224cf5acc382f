// Where every object of the gallery is shown: on a dark floor, in the studio's light.
#pragma once

#include "camera.hpp"
#include "world.hpp"

namespace render {

/// A sphere of radius 1 on the floor, if `mesh` is null; otherwise the mesh, which must already
/// stand on the floor (standOnFloor). The world is committed.
std::unique_ptr<World> stage(std::shared_ptr<const Mesh> mesh, std::shared_ptr<const Material> material);

Camera stageCamera();

} // namespace render
