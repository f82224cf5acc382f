// A row of the table: the ways to do the same thing.
#pragma once

#include "elements.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

// Elements [first, first + count).
using Work = std::function<void(std::size_t first, std::size_t count)>;

enum Way {
    plain_way,     // plain C++, array of structures
    bits256_way,   // the same formula vectorised by the compiler, structure of arrays
    bits512_way,   //
    intrinsic_way, // a look-up by hand
    single_way,    // one call of the library per element, array of structures
    batch_way,     // structure of arrays
    packed_way,    // batch, array of structures
    copy_way,      // reads and writes as much
    way_count
};

struct Row {
    std::string name;
    std::array<Work, way_count> work; // empty: there is none
    bool is_sampling = false;         // results are Sampled, else values
    // Of the plain formula from the library, over the greatest value: at most, and in root mean square.
    double allowed = 0, allowed_rms = 0;
    std::string error_bound = "-"; // what the library promises
};

// Between results, over the greatest value there is; of samples the worst of direction, density and weight.
// Infinite if a result is missing or is not a number.
struct Difference {
    double max, rms;
};

// Of the ways asked for, over all elements: of the vectorised ways from the plain one, as they are the same formula;
// of the others from the batch. None if the row lacks the way.
using Differences = std::array<std::optional<Difference>, way_count>;
Differences compare(const Row &row, const std::vector<Way> &ways, Outputs &outputs, std::size_t count);

// The ways that must agree.
extern const std::vector<Way> compared_ways;

// Whether those that were compared do; says on stderr which do not.
bool agree(const Row &row, const Differences &differences);

// All rows; they refer to both arguments.
std::vector<Row> all_rows(const Elements &elements, Outputs &outputs);

// Whether the intrinsics find what the same spline in plain C++ finds; says on stderr if not.
bool spline_agrees(const Elements &elements, Outputs &outputs);

void add_bsdf_rows(std::vector<Row> &rows, const Elements &elements, Outputs &outputs);
void add_film_rows(std::vector<Row> &rows, const Elements &elements, Outputs &outputs);
void add_sample_rows(std::vector<Row> &rows, const Elements &elements, Outputs &outputs);
