// Contenders that take turns, each timed by the processor time of the thread that does the work: other
// programs on the machine then disturb caches and clock rate only.
#pragma once

#include "row.hpp"

#include <functional>
#include <string>
#include <vector>

constexpr int turn_count = 9;

// How many elements a run covers: `count` of them, `repetitions` times.
struct Size {
    const char *name;
    std::size_t count, repetitions;
};

constexpr Size large{"2^20 elements, once", element_count, 1};
constexpr Size tile{"4,096 elements in cache, again and again", tile_count, 32};

// Of this thread, in nanoseconds.
double processor_time();

// Nanoseconds per element of one run.
double time_once(const Work &work, const Size &size);

double median(std::vector<double> numbers);

// Medians of `turn_count` rounds, after one that does not count; in each all contenders run once, each giving its
// nanoseconds.
std::vector<double> take_turns(const std::vector<std::function<double()>> &contenders);
