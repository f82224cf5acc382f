// The library's levels of SIMD. Every lower level is a process of its own: a child that runs what the parent
// asks for and answers with its time. So levels take turns like any other contenders.
#pragma once

#include "row.hpp"
#include "turns.hpp"

#include <string>
#include <sys/types.h>
#include <vector>

// What this processor has of "sse2", "avx2" and "avx512", the best last.
std::vector<std::string> levels_here();

// Runs the batch of row number `row` at a lower level, in a child.
class LowerLevel {
public:
    // Starts the child; it builds its rows and compares them with the plain formulas meanwhile.
    explicit LowerLevel(const std::string &level);
    ~LowerLevel();
    LowerLevel(const LowerLevel &) = delete;
    LowerLevel &operator=(const LowerLevel &) = delete;

    // Waits for the child; whether its rows agree.
    bool is_ready();

    // Nanoseconds per element.
    double time_once(std::size_t row, const Size &size);

private:
    pid_t child;
    int requests, answers; // ends of pipes
};

// What the child does: answers requests until there are no more. Returns the exit status.
int serve_level(const std::vector<Row> &rows, Outputs &outputs);

// The argument that makes a child; the name of its level follows.
constexpr char serve_argument[] = "--serve-level";
