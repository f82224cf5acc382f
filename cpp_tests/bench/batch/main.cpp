// Batches: what a call with many elements costs, beside one call each, plain C++, the same formulas vectorised by
// the compiler, and copying. Prints Markdown. Fails only if results disagree, never on time.

#include "bsdfs.hpp"
#include "table.hpp"

#include <pellicle.hpp>

#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

void print_introduction(const std::vector<std::string> &levels) {
    double load = 0;
    getloadavg(&load, 1);
    std::printf("\n## Batches\n\n"
                "pellicle %s; this processor's best level is %s. The load of the machine was %.1f at the start.\n\n"
                "Medians of %d runs, one thread, in ns of processor time per element; all contenders take turns. "
                "Values alone are computed, no densities.\n\n"
                "- plain: scalar C++ with the standard library's functions, g++ -O3 -march=native, array of "
                "structures.\n"
                "- vectorised: the same formula as a loop over structures of arrays, g++ -Ofast -march=native, glibc's "
                "vector functions, no NaN handling; the faster of vectors of 256 and 512 bits. g++ vectorises all of "
                "these loops.\n"
                "- single: one call per element. Batches are over structures of arrays, at each level, and over arrays "
                "of structures at the best.\n"
                "- Each lower level runs in a process of its own, which takes its turn with the rest.\n"
                "- copy: reads and writes as many numbers.\n"
                "- intrinsics: a quadratic spline over 40 x 60 control points by hand, with AVX-512.\n"
                "- Plain films are linear in tables of 64 x 256, or 64, entries, which are further from the truth than "
                "the library (the table of films); their looking up is what is compared.\n",
                pellicle_version_string(), levels.back().c_str(), load, turn_count);
}

int run() {
    const std::vector<std::string> levels = levels_here();
    LowerLevels lower_levels;
    for (std::size_t i = 0; i + 1 < levels.size(); ++i)
        lower_levels.push_back(std::make_unique<LowerLevel>(levels[i]));
    const Elements elements(element_count);
    Outputs outputs(element_count);
    const std::vector<Row> rows = all_rows(elements, outputs);
    std::vector<Differences> differences;
    bool all_agree = spline_agrees(elements, outputs);
    for (const Row &row : rows) {
        differences.push_back(compare(row, compared_ways, outputs, element_count));
        all_agree = agree(row, differences.back()) && all_agree;
    }
    for (std::size_t i = 0; i < lower_levels.size(); ++i)
        if (!lower_levels[i]->is_ready()) {
            std::fprintf(stderr, "level %s: results differ, or its process has ended\n", levels[i].c_str());
            all_agree = false;
        }
    if (!all_agree) return 1;

    print_introduction(levels);
    print_batches(rows, large, lower_levels);
    print_batches(rows, tile, lower_levels);
    print_threads(rows);
    print_counts(elements);
    print_differences(rows, differences);
    return 0;
}

} // namespace

int main(int argc, char **argv) {
    if (argc == 3 && std::strcmp(argv[1], serve_argument) == 0) {
        bsdfs::simd_level = argv[2];
        const Elements elements(element_count);
        Outputs outputs(element_count);
        return serve_level(all_rows(elements, outputs), outputs);
    }
    return run();
}
