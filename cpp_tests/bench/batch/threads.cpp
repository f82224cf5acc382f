// Two threads against one: what batches share is nothing but memory and its caches.

#include "table.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <thread>

namespace {

// Where each thread works, and how often.
struct Shares {
    std::size_t threads, count, repetitions;
};

// Nanoseconds per element of all threads, from the moment when all are there until the last has finished.
struct Times {
    double wall;      // by the clock, in which other programs have their share
    double processor; // of the thread that used most
};

Times time_once(const Work &work, const Shares &shares) {
    using Clock = std::chrono::steady_clock;
    std::atomic<std::size_t> waiting{shares.threads};
    std::vector<Clock::time_point> starts(shares.threads), ends(shares.threads);
    std::vector<double> processor(shares.threads);
    std::vector<std::thread> threads;
    for (std::size_t t = 0; t < shares.threads; ++t)
        threads.emplace_back([&, t] {
            work(t * shares.count, shares.count); // caches are warm
            --waiting;
            while (waiting > 0) std::this_thread::yield();
            starts[t] = Clock::now();
            const double start = processor_time();
            for (std::size_t i = 0; i < shares.repetitions; ++i) work(t * shares.count, shares.count);
            processor[t] = processor_time() - start;
            ends[t] = Clock::now();
        });
    for (std::thread &thread : threads) thread.join();
    const std::chrono::duration<double, std::nano> wall = *std::max_element(ends.begin(), ends.end()) -
                                                          *std::min_element(starts.begin(), starts.end());
    const double elements = double(shares.threads * shares.count * shares.repetitions);
    return {wall.count() / elements, *std::max_element(processor.begin(), processor.end()) / elements};
}

void print(const Row &row, const char *name, const Shares &one, const Shares &two) {
    std::vector<std::vector<double>> walls(4), processors(4);
    for (int turn = 0; turn < turn_count; ++turn) {
        std::size_t contender = 0;
        for (const Way way : {batch_way, copy_way})
            for (const Shares &shares : {one, two}) {
                const Times times = time_once(row.work[way], shares);
                walls[contender].push_back(times.wall);
                processors[contender++].push_back(times.processor);
            }
    }
    std::printf("| %s, %s |", row.name.c_str(), name);
    for (const std::size_t first : {0, 2}) {
        const double wall[2] = {median(walls[first]), median(walls[first + 1])};
        const double processor[2] = {median(processors[first]), median(processors[first + 1])};
        std::printf(" %.2f | %.2f | %.2f | %.2f |", wall[0], wall[1], wall[0] / wall[1], processor[0] / processor[1]);
    }
    std::printf("\n");
    std::fflush(stdout);
}

} // namespace

void print_threads(const std::vector<Row> &rows) {
    std::printf("\n### Threads\n\n"
                "ns per element of all threads, by the clock, and how much faster two are: by the clock, and by the "
                "processor time of the slower thread, in which programs beside this one do not count. Each thread has "
                "a tile of %zu elements of its own, or half of 2^20.\n\n"
                "| kind | batch, 1 thread | 2 threads | faster by | by processor time | copy, 1 thread | 2 threads | "
                "faster by | by processor time |\n"
                "|---|---:|---:|---:|---:|---:|---:|---:|---:|\n",
                tile_count);
    for (const Row &row : rows) {
        bool is_shown = false;
        for (const char *name : {"lambert", "layered, paper", "ggx, conductor", "film: soap"})
            is_shown = is_shown || row.name == name;
        if (!is_shown) continue;
        print(row, "in cache", {1, tile_count, 64}, {2, tile_count, 64});
        print(row, "2^20", {1, element_count, 1}, {2, element_count / 2, 1});
    }
}
