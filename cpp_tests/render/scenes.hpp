// The gallery's scenes, as data: a new scene is added in scenes.cpp and nowhere else.
#pragma once

#include "material.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace render {

struct Scene {
    std::string name;                                          ///< of its files, and for --scene
    std::string caption;                                       ///< under its pictures; lines end in \n
    std::function<std::shared_ptr<const Material>()> material; ///< of the object
    float exposure; ///< stops; part of the scene because `paper` and `energy` differ in brightness
};

const std::vector<Scene> &scenes();

} // namespace render
