// Every way in which the library evaluates a film, for tests that hold for all of them.
#pragma once

#include "airy.hpp"

#include <pellicle.hpp>

#include <string>
#include <vector>

namespace films {

// A film of one layer whose thickness varies in [0, max_nm], its media without dispersion.
pellicle::FilmBuilder builder(const airy::Stack &stack, float max_nm);

// The stack with the indices that such a film gets, which are rounded to single precision.
airy::Stack as_given(const airy::Stack &stack);

// A film by one method, at one tolerance.
struct Evaluated {
    std::string name;
    pellicle::Film film;
    // The greatest error allowed; 1, the greatest that can be asked for, of methods that are taken whatever
    // they do: these only have to give numbers in [0, 1].
    double tolerance;

    // The error allowed of a colour: the tolerance, and what rounding and the table of matching functions
    // (5 nm in the library) add.
    double allowed() const { return tolerance + 6e-5; }
};

// The film by the method that the library chooses and by all that can be asked for, at tolerances from 1e-2 to
// 2e-4. Methods that cannot hold a tolerance must refuse it.
std::vector<Evaluated> by_every_method(const pellicle::FilmBuilder &builder);

// Only by those that the library chooses.
std::vector<Evaluated> by_chosen_methods(const pellicle::FilmBuilder &builder);

airy::Rgb reflectance(const pellicle::Film &film, double cos_theta, double thickness_nm);

// The film's colours are numbers in [0, 1] and within its tolerance of the truth, at all these angles and
// thicknesses.
void check(const std::vector<Evaluated> &films, const airy::Stack &stack, const std::vector<double> &cosines,
           const std::vector<double> &thicknesses_nm);

} // namespace films
