// A line that tells how far the work is and how long the rest will take.
#pragma once

#include <chrono>
#include <mutex>
#include <string>

namespace render {

/// Written to standard error: rewritten in place on a terminal, otherwise once per label.
class Progress {
public:
    explicit Progress(double totalWork);
    ~Progress();

    /// What is worked on now.
    void label(std::string text);

    /// Work done since the last call, in the unit of `totalWork`. Any thread may call this.
    void advance(double work);

private:
    using Clock = std::chrono::steady_clock;
    void print();

    const double total_;
    const bool terminal_;
    const Clock::time_point start_ = Clock::now();
    Clock::time_point printed_;
    double done_ = 0;
    std::string label_;
    std::mutex mutex_;
};

} // namespace render
