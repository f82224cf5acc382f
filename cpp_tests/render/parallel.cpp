#include "parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace render {

void parallelFor(int count, int threads, const std::function<void(int)> &body) {
    std::atomic<int> next{0};
    std::exception_ptr failure;
    std::mutex mutex;
    const auto work = [&] {
        try {
            for (int i; (i = next++) < count;) body(i);
        } catch (...) {
            const std::lock_guard lock(mutex);
            failure = std::current_exception();
            next = count;
        }
    };
    const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
    std::vector<std::thread> workers(threads > 0 ? threads : cores);
    for (std::thread &worker : workers) worker = std::thread(work);
    for (std::thread &worker : workers) worker.join();
    if (failure) std::rethrow_exception(failure);
}

} // namespace render
