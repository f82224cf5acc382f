#include "turns.hpp"

#include <algorithm>
#include <ctime>

double processor_time() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return double(time.tv_sec) * 1e9 + double(time.tv_nsec);
}

double time_once(const Work &work, const Size &size) {
    const double start = processor_time();
    for (std::size_t i = 0; i < size.repetitions; ++i) work(0, size.count);
    return (processor_time() - start) / double(size.count * size.repetitions);
}

double median(std::vector<double> numbers) {
    std::nth_element(numbers.begin(), numbers.begin() + std::ptrdiff_t(numbers.size() / 2), numbers.end());
    return numbers[numbers.size() / 2];
}

std::vector<double> take_turns(const std::vector<std::function<double()>> &contenders) {
    std::vector<std::vector<double>> times(contenders.size());
    for (int turn = 0; turn <= turn_count; ++turn)
        for (std::size_t i = 0; i < contenders.size(); ++i) {
            const double time = contenders[i]();
            if (turn > 0) times[i].push_back(time);
        }
    std::vector<double> medians;
    for (const auto &of_one : times) medians.push_back(median(of_one));
    return medians;
}
