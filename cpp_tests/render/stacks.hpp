// The thin films of the gallery: layers and bases, as data.
#pragma once

#include <pellicle.hpp>

#include <string>
#include <vector>

namespace render {

struct Stack {
    std::string name;           ///< as part of file names
    std::string title;          ///< what it is
    pellicle::Medium layer, base;
    float chartExposure;        ///< stops: the faint ones would be lost beside metals

    /// The layer's thickness varies from 0 to `thicknessMax`, nm. White is D65, as pictures are sRGB.
    pellicle::FilmBuilder film(float thicknessMax) const {
        return pellicle::FilmBuilder(base).layer(layer, 0, thicknessMax).white("D65");
    }
};

/// A wall of water in air.
const Stack &soap();
const Stack &oilOnWater();
/// Anodised: the oxide is taken to be rutile.
const Stack &anodisedTitanium();
/// Tempered: the oxide is taken to be magnetite.
const Stack &temperedSteel();
const Stack &coatedGlass();
const Stack &oxidisedSilicon();

/// All of the above.
std::vector<Stack> stacks();

} // namespace render
