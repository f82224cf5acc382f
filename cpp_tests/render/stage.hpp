// Where objects of the gallery are shown: on a floor.
#pragma once

#include "camera.hpp"
#include "world.hpp"

namespace render {

/// The floor's albedo in the middle and far away.
struct Floor {
    float centre = 0.2f, rim = 0.03f;
};

/// Adds a floor whose paint fades from its centre to its rim between two distances from the axis.
void addFloor(World &world, Floor floor, float from, float to);

/// A sphere of radius 1 on the floor, if `mesh` is null; otherwise the mesh, which must already
/// stand on the floor (standOnFloor). The world is committed.
std::unique_ptr<World> stage(std::shared_ptr<const Mesh> mesh, std::shared_ptr<const Material> material,
                             Floor floor = {});

Camera stageCamera();

} // namespace render
