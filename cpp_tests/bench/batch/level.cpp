#include "level.hpp"

#include <cstdlib>
#include <stdexcept>
#include <sys/wait.h>
#include <unistd.h>

namespace {

constexpr int request_end = 3, answer_end = 4; // of the child

struct Request {
    std::size_t row, count, repetitions;
};

template <class T> bool receive(int from, T &message) {
    char *bytes = reinterpret_cast<char *>(&message);
    for (std::size_t done = 0; done < sizeof message;) {
        const ssize_t got = read(from, bytes + done, sizeof message - done);
        if (got <= 0) return false;
        done += std::size_t(got);
    }
    return true;
}

template <class T> bool send(int to, const T &message) {
    return write(to, &message, sizeof message) == ssize_t(sizeof message);
}

} // namespace

std::vector<std::string> levels_here() {
    std::vector<std::string> levels = {"sse2"};
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) levels.push_back("avx2");
    if (levels.size() == 2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl"))
        levels.push_back("avx512");
    return levels;
}

LowerLevel::LowerLevel(const std::string &level) {
    int down[2], up[2];
    if (pipe(down) != 0 || pipe(up) != 0) throw std::runtime_error("no pipe for a child");
    child = fork();
    if (child < 0) throw std::runtime_error("no child for level " + level);
    if (child == 0) {
        // Above all numbers that are in use, so that neither overwrites the other; then in their places.
        const int low = dup2(down[0], 100), high = dup2(up[1], 101);
        for (int end = 3; end < 100; ++end) close(end);
        if (dup2(low, request_end) < 0 || dup2(high, answer_end) < 0) _exit(1);
        close(low);
        close(high);
        execl("/proc/self/exe", "pellicle_bench_batch", serve_argument, level.c_str(),
              static_cast<char *>(nullptr));
        _exit(1);
    }
    close(down[0]);
    close(up[1]);
    requests = down[1];
    answers = up[0];
}

LowerLevel::~LowerLevel() {
    close(requests); // ends the child
    close(answers);
    waitpid(child, nullptr, 0);
}

bool LowerLevel::is_ready() {
    char agrees = 0;
    return receive(answers, agrees) && agrees == 1;
}

double LowerLevel::time_once(std::size_t row, const Size &size) {
    double nanoseconds = 0;
    if (!send(requests, Request{row, size.count, size.repetitions}) || !receive(answers, nanoseconds))
        throw std::runtime_error("a child has ended");
    return nanoseconds;
}

int serve_level(const std::vector<Row> &rows, Outputs &outputs) {
    char all_agree = 1;
    for (const Row &row : rows)
        if (!agree(row, compare(row, {plain_way, single_way}, outputs, element_count))) all_agree = 0;
    if (!send(answer_end, all_agree) || all_agree == 0) return 1;
    Request request{};
    while (receive(request_end, request)) {
        const Size size{"", request.count, request.repetitions};
        if (!send(answer_end, time_once(rows.at(request.row).work[batch_way], size))) return 1;
    }
    return 0;
}
