// Coats of a glass lens.
#pragma once

#include <pellicle.hpp>

namespace render {

/// Schott's BK7 in air, with nothing on it, a quarter wave of magnesium fluoride, or three layers: a quarter, a half and a
/// quarter wave. All are followed from both sides; white is D65.
pellicle::FilmBuilder bareLens();
pellicle::FilmBuilder singleCoat();
pellicle::FilmBuilder broadBandCoat();

} // namespace render
