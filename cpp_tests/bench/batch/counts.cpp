// Cost by the number of elements in a call: what a call costs by itself, and what leaving the caches costs.

#include "bsdfs.hpp"
#include "table.hpp"

#include <algorithm>
#include <cstdio>
#include <string>

namespace {

constexpr std::size_t greatest_count = 10'000'000;

struct Memory {
    Planes wo{3, greatest_count}, wi{3, greatest_count}, value{3, greatest_count};
};

// The same random elements again and again.
void fill(Memory &memory, const Elements &elements) {
    for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t i = 0; i < greatest_count; ++i) {
            memory.wo[c][i] = elements.wo.planes[c][i % element_count];
            memory.wi[c][i] = elements.wi.planes[c][i % element_count];
        }
}

Work batch(const pellicle::Bsdf &bsdf, Memory &memory) {
    return [bsdf, &memory](std::size_t first, std::size_t count) {
        const auto read = [&](const Planes &planes) {
            return PellicleConstView{planes[0] + first, sizeof(float), planes.bytes()};
        };
        PellicleEvalBatchArgs args{};
        args.count = count;
        args.wo = read(memory.wo);
        args.wi = read(memory.wi);
        args.value = {memory.value[0] + first, sizeof(float), memory.value.bytes()};
        bsdf.eval_batch(args);
    };
}

Work single(const pellicle::Bsdf &bsdf, const Elements &elements) {
    return [bsdf, &elements](std::size_t first, std::size_t) {
        float value[3];
        pellicle_bsdf_eval(bsdf.raw(), elements.wo.packed[first].data(), elements.wi.packed[first].data(), nullptr,
                           nullptr, value, nullptr, nullptr);
    };
}

// As `work`, but every call takes the next piece of the first tile; a call that needs more takes what it needs.
Work moving(const Work &work, std::size_t count) {
    const std::size_t tiles = std::max<std::size_t>(1, tile_count / count);
    return [work, tiles, count, next = std::size_t(0)](std::size_t, std::size_t) mutable {
        work(next % tiles * count, count);
        ++next;
    };
}

} // namespace

void print_counts(const Elements &elements) {
    Memory memory;
    fill(memory, elements);
    const struct {
        const char *name;
        pellicle::Bsdf bsdf;
    } kinds[] = {{"layered, paper", bsdfs::layered().create()}, {"ggx, conductor", bsdfs::conductor()}};

    std::printf("\n### Elements per call\n\n"
                "ns per element; calls of up to 4,096 elements run through a tile of so many.\n\n"
                "| elements |");
    for (const auto &kind : kinds) std::printf(" %s |", kind.name);
    std::printf("\n|---|---:|---:|\n");
    const auto print = [&](const char *name, std::size_t count, auto work_of) {
        const Size size{"", count, std::max<std::size_t>(1, (std::size_t(1) << 16) / count)};
        std::vector<std::function<double()>> contenders;
        for (const auto &kind : kinds)
            contenders.push_back([work = moving(work_of(kind.bsdf), count), size] { return time_once(work, size); });
        std::printf("| %s |", name);
        for (const double median : take_turns(contenders)) std::printf(" %.2f |", median);
        std::printf("\n");
        std::fflush(stdout);
    };
    print("single call", 1, [&](const pellicle::Bsdf &bsdf) { return single(bsdf, elements); });
    for (const std::size_t count : {1, 2, 4, 8, 16, 64, 256, 4096, 100'000, 1'000'000, 10'000'000})
        print(std::to_string(count).c_str(), count, [&](const pellicle::Bsdf &bsdf) { return batch(bsdf, memory); });
}
