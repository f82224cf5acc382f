// What is timed, and how: all contenders take turns within one process, so that noise of the machine
// hits them alike.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

constexpr std::size_t count = 300'000;
constexpr int runs = 9;

struct Contender {
    std::string name;
    std::size_t calls;
    std::function<float()> run; // all calls once; the sum keeps the compiler from leaving them out
    std::vector<double> nanoseconds;

    double median() const {
        std::vector<double> sorted = nanoseconds;
        std::nth_element(sorted.begin(), sorted.begin() + sorted.size() / 2, sorted.end());
        return sorted[sorted.size() / 2];
    }
};

inline void measure(std::vector<Contender> &contenders) {
    volatile float keep = 0.0f;
    // One round more than counted: the first one warms up.
    for (int run = 0; run <= runs; ++run)
        for (Contender &contender : contenders) {
            const auto start = std::chrono::steady_clock::now();
            keep = keep + contender.run();
            const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - start;
            if (run > 0) contender.nanoseconds.push_back(time.count() / static_cast<double>(contender.calls));
        }
}
