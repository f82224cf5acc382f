// The tables, as Markdown.
#pragma once

#include "level.hpp"
#include "row.hpp"
#include "turns.hpp"

#include <memory>
#include <vector>

using LowerLevels = std::vector<std::unique_ptr<LowerLevel>>;

// All rows at one size.
void print_batches(const std::vector<Row> &rows, const Size &size, const LowerLevels &lower_levels);

// How far the results of the ways are apart.
void print_differences(const std::vector<Row> &rows, const std::vector<Differences> &differences);

// Two threads against one.
void print_threads(const std::vector<Row> &rows);

// Cost by the number of elements in a call.
void print_counts(const Elements &elements);
