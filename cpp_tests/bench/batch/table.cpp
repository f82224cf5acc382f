#include "table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace {

constexpr std::size_t greatest_level_count = 3;

void print_time(double nanoseconds) {
    if (std::isnan(nanoseconds))
        std::printf(" - |");
    else
        std::printf(" %.2f |", nanoseconds);
}

// Medians of a row; NaN: there is none.
struct Times {
    double of_way[way_count];
    double of_level[greatest_level_count];
};

Times times(const std::vector<Row> &rows, std::size_t number, const Size &size, const LowerLevels &lower_levels) {
    const Row &row = rows[number];
    std::vector<std::function<double()>> contenders;
    std::vector<double *> places;
    Times found;
    std::fill(std::begin(found.of_way), std::end(found.of_way), NAN);
    std::fill(std::begin(found.of_level), std::end(found.of_level), NAN);
    for (int way = 0; way < way_count; ++way)
        if (row.work[way]) {
            contenders.push_back([&row, way, &size] { return time_once(row.work[way], size); });
            places.push_back(&found.of_way[way]);
        }
    for (std::size_t level = 0; level < lower_levels.size(); ++level) {
        contenders.push_back([&, level] { return lower_levels[level]->time_once(number, size); });
        places.push_back(&found.of_level[level]);
    }
    const std::vector<double> medians = take_turns(contenders);
    for (std::size_t i = 0; i < places.size(); ++i) *places[i] = medians[i];
    found.of_level[lower_levels.size()] = found.of_way[batch_way];
    return found;
}

} // namespace

void print_batches(const std::vector<Row> &rows, const Size &size, const LowerLevels &lower_levels) {
    std::printf("\n### %s\n\n"
                "| ns per element | plain | vectorised | single | batch sse2 | avx2 | avx512 | of structures | copy | "
                "intrinsics | plain / batch | vectorised / batch | single / batch | batch - copy | "
                "error of what is allowed |\n"
                "|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n",
                size.name);
    for (std::size_t number = 0; number < rows.size(); ++number) {
        const Row &row = rows[number];
        const Times found = times(rows, number, size, lower_levels);
        const double batch = found.of_way[batch_way];
        const double vectorised = std::fmin(found.of_way[bits256_way], found.of_way[bits512_way]);
        std::printf("| %s |", row.name.c_str());
        for (const double time : {found.of_way[plain_way], vectorised, found.of_way[single_way], found.of_level[0],
                                  found.of_level[1], found.of_level[2], found.of_way[packed_way],
                                  found.of_way[copy_way], found.of_way[intrinsic_way],
                                  found.of_way[plain_way] / batch, vectorised / batch,
                                  found.of_way[single_way] / batch, batch - found.of_way[copy_way]})
            print_time(time);
        std::printf(" %s |\n", row.error_bound.c_str());
        std::fflush(stdout);
    }
}

void print_differences(const std::vector<Row> &rows, const std::vector<Differences> &differences) {
    std::printf("\n### Differences\n\n"
                "Over all %zu elements, over the greatest value: of plain, single and structures from the batch, of "
                "vectorised from plain.\n\n"
                "| kind | plain, rms | allowed | max | allowed | vectorised, max | single, max | structures, max |\n"
                "|---|---:|---:|---:|---:|---:|---:|---:|\n",
                element_count);
    for (std::size_t number = 0; number < rows.size(); ++number) {
        const Differences &of_row = differences[number];
        std::printf("| %s |", rows[number].name.c_str());
        if (of_row[plain_way])
            std::printf(" %.1e | %.0e | %.1e | %.0e |", of_row[plain_way]->rms, rows[number].allowed_rms,
                        of_row[plain_way]->max, rows[number].allowed);
        else
            std::printf(" - | - | - | - |");
        double vectorised = -1;
        for (const Way way : {bits256_way, bits512_way})
            if (of_row[way]) vectorised = std::max(vectorised, of_row[way]->max);
        if (vectorised < 0)
            std::printf(" - |");
        else
            std::printf(" %.1e |", vectorised);
        std::printf(" %.1e | %.1e |\n", of_row[single_way]->max, of_row[packed_way]->max);
    }
}
