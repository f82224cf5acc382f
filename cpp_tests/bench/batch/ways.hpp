// The ways that all rows of a kind have alike, and views of the elements.
#pragma once

#include "elements.hpp"
#include "row.hpp"
#include "vectorised.hpp"

#include <pellicle.hpp>

#include <string>
#include <vector>

namespace ways {

// In the plain formulas' type.
template <class Direction> Direction direction(const Vec3 &v) {
    return {v[0], v[1], v[2]};
}

vectorised::In in(const Elements &elements, const float *varying, std::size_t first);
vectorised::Out out(Outputs &outputs, std::size_t first);

// What the library does for values, one call each and in batches. `varying`: one number per element, or NULL.
void add_values(Row &row, const pellicle::Bsdf &bsdf, const Elements &elements, Outputs &outputs,
                const float *varying);
void add_reflectances(Row &row, const pellicle::Film &film, const Elements &elements, Outputs &outputs,
                      bool varies);
void add_samples(Row &row, const pellicle::Bsdf &bsdf, const Elements &elements, Outputs &outputs);

// Reads `in` numbers of every element and writes `out`.
void add_copy(Row &row, const std::vector<const float *> &in, Outputs &outputs, std::size_t out);

// Which error a film was found to have at its creation, and which was allowed.
std::string error_bound(const pellicle::Film &film);

} // namespace ways
