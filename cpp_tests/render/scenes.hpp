// The gallery's scenes, as data: a new one is added to one of these lists and nowhere else.
#pragma once

#include "lighting.hpp"
#include "view.hpp"

#include <string>
#include <vector>

namespace render {

/// What is written above the rows, inside, and below the columns of a picture of many objects.
struct Labels {
    std::vector<std::string> columns, rows;
};

struct Scene {
    std::string name;    ///< of its files, and for --scene
    std::string caption; ///< under its pictures; lines end in \n
    Views views;
    float exposure; ///< stops; part of the scene because materials differ in brightness
    Lighting lighting = Lighting::studio;
    float effort = 1; ///< how many times as many samples: for light that is chosen rarely
    int maxBounces = 5;
    bool photograph = false; ///< shown with a tone curve; otherwise nothing is but clipped
    Labels labels{};
};

/// Scenes that are shown together, in as many columns; their pictures have one shape.
struct Chapter {
    std::string name; ///< of its sheet's file
    int columns;
    std::vector<Scene> scenes;
};

/// The picture of the first page.
Chapter heroChapter();

/// The paper's figures.
const std::vector<Scene> &scenes();

/// Surfaces with real thin films.
const std::vector<Scene> &filmScenes();

/// A lens without a coat, and with two.
Chapter lensChapter();

/// A film whose thickness varies within a pixel: by its mean, by mean and deviation, and the truth.
Chapter minifiedFilmChapter();

/// Rough surfaces: grids of spheres, and rows of them.
std::vector<Chapter> microfacetChapters();

/// Phong's terms, image textures and environment maps.
std::vector<Chapter> textureChapters();

/// All of the above, in the order of the contact sheet.
const std::vector<Chapter> &chapters();

/// Throws std::runtime_error if there is none.
const Scene &sceneNamed(const std::string &name);

} // namespace render
