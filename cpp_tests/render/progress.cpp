#include "progress.hpp"

#include <unistd.h>

#include <cmath>
#include <cstdio>

namespace render {

Progress::Progress(double totalWork) : total_(totalWork), terminal_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
    if (terminal_) std::fputs("\r\033[K", stderr);
}

void Progress::label(std::string text) {
    const std::lock_guard lock(mutex_);
    label_ = std::move(text);
    print();
}

void Progress::advance(double work) {
    const std::lock_guard lock(mutex_);
    done_ += work;
    if (terminal_ && Clock::now() - printed_ > std::chrono::milliseconds(200)) print();
}

void Progress::print() {
    printed_ = Clock::now();
    const double done = done_ / total_;
    const double elapsed = std::chrono::duration<double>(printed_ - start_).count();
    char left[32] = "";
    if (done > 0.01) {
        const long seconds = std::lround(elapsed / done - elapsed);
        std::snprintf(left, sizeof left, ", %ld:%02ld left", seconds / 60, seconds % 60);
    }
    std::fprintf(stderr, "%s%3.0f %%%s  %s%s", terminal_ ? "\r\033[K" : "", 100 * done, left, label_.c_str(),
                 terminal_ ? "" : "\n");
    std::fflush(stderr);
}

} // namespace render
