// The gallery's scenes, as data: a new one is added in scenes.cpp or film_scenes.cpp and nowhere else.
#pragma once

#include "lighting.hpp"
#include "material.hpp"
#include "view.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace render {

struct Scene {
    std::string name;                                          ///< of its files, and for --scene
    std::string caption;                                       ///< under its pictures; lines end in \n
    std::function<std::shared_ptr<const Material>()> material; ///< of the object
    float exposure; ///< stops; part of the scene because materials differ in brightness
    Views views = sphereAndMesh();
    Lighting lighting = Lighting::studio;
    int effort = 1; ///< how many times as many samples: for light that is chosen rarely
    int maxBounces = 5;
};

/// The paper's figures.
const std::vector<Scene> &scenes();

/// Surfaces with real thin films.
const std::vector<Scene> &filmScenes();

} // namespace render
