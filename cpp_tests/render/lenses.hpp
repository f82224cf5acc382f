// Coats of a glass lens.
#pragma once

#include <pellicle.hpp>

namespace render {

/// Schott's BK7 in air, with nothing on it, a quarter wave of magnesium fluoride, or three layers. White is D65, and all
/// films answer from both sides.
pellicle::FilmBuilder bareLens();
pellicle::FilmBuilder singleCoat();
pellicle::FilmBuilder broadBandCoat();

} // namespace render
