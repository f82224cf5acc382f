#include "row.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace {

const char *const names[way_count] = {"plain",  "vectorised (256 bits)", "vectorised (512 bits)", "intrinsics",
                                      "single", "batch",                 "batch of structures",   "copy"};

bool writes_planes(Way way) {
    return way == batch_way || way == bits256_way || way == bits512_way;
}

using Result = std::array<float, sampled_floats>;

// Of element i.
Result result(const Row &row, Way way, const Outputs &outputs, std::size_t i) {
    Result found{};
    if (writes_planes(way)) {
        const std::size_t floats = row.is_sampling ? sampled_floats : 3;
        for (std::size_t c = 0; c < floats; ++c) found[c] = outputs.planes[c][i];
    } else if (row.is_sampling) {
        const Sampled &s = outputs.samples[i];
        found = {s.wi[0], s.wi[1], s.wi[2], s.pdf, s.weight[0], s.weight[1], s.weight[2]};
    } else {
        const Vec3 &value = outputs.values[i];
        found = {value[0], value[1], value[2]};
    }
    return found;
}

// Direction, density and weight have scales of their own.
constexpr std::size_t group_of[sampled_floats] = {0, 0, 0, 1, 2, 2, 2};

Difference difference(const std::vector<Result> &found, const std::vector<Result> &expected) {
    double greatest[3] = {}, farthest[3] = {}, squares[3] = {};
    std::size_t numbers[3] = {};
    for (std::size_t i = 0; i < found.size(); ++i)
        for (std::size_t c = 0; c < sampled_floats; ++c) {
            if (!std::isfinite(found[i][c]) || !std::isfinite(expected[i][c])) return {INFINITY, INFINITY};
            const std::size_t group = group_of[c];
            const double apart = std::fabs(double(found[i][c]) - expected[i][c]);
            greatest[group] = std::max(greatest[group], std::fabs(double(found[i][c])));
            farthest[group] = std::max(farthest[group], apart);
            squares[group] += apart * apart;
            ++numbers[group];
        }
    if (greatest[0] == 0) return {INFINITY, INFINITY};
    Difference worst{};
    for (std::size_t group = 0; group < 3; ++group)
        if (greatest[group] > 0) {
            worst.max = std::max(worst.max, farthest[group] / greatest[group]);
            worst.rms = std::max(worst.rms, std::sqrt(squares[group] / double(numbers[group])) / greatest[group]);
        }
    return worst;
}

// The library's own calls, and two texts of one formula, may differ in rounding only.
constexpr double rounding_of_calls = 1e-5, rounding_of_texts = 1e-4;

} // namespace

const std::vector<Way> compared_ways = {plain_way, bits256_way, bits512_way, single_way, packed_way};

Differences compare(const Row &row, const std::vector<Way> &ways, Outputs &outputs, std::size_t count) {
    const auto results_of = [&](Way way) {
        outputs.forget();
        row.work[way](0, count);
        std::vector<Result> results(count);
        for (std::size_t i = 0; i < count; ++i) results[i] = result(row, way, outputs, i);
        return results;
    };
    const std::vector<Result> batch = results_of(batch_way);
    std::vector<Result> plain;
    if (row.work[plain_way]) plain = results_of(plain_way);
    Differences differences;
    for (const Way way : ways) {
        if (!row.work[way]) continue;
        if (way == plain_way)
            differences[way] = difference(plain, batch);
        else
            differences[way] = difference(results_of(way), way == bits256_way || way == bits512_way ? plain : batch);
    }
    return differences;
}

bool agree(const Row &row, const Differences &differences) {
    bool all = true;
    const auto check = [&](Way way, const char *what, double found, double allowed) {
        if (found <= allowed) return;
        std::fprintf(stderr, "%s: %s differs by %.1e of the greatest value (%s); allowed is %.1e\n", row.name.c_str(),
                     names[way], found, what, allowed);
        all = false;
    };
    for (const Way way : compared_ways) {
        if (!differences[way]) continue;
        const bool is_vectorised = way == bits256_way || way == bits512_way;
        const double texts = is_vectorised ? rounding_of_texts : rounding_of_calls;
        check(way, "max", differences[way]->max, way == plain_way ? row.allowed : texts);
        if (way == plain_way) check(way, "rms", differences[way]->rms, row.allowed_rms);
    }
    return all;
}

std::vector<Row> all_rows(const Elements &elements, Outputs &outputs) {
    std::vector<Row> rows;
    add_bsdf_rows(rows, elements, outputs);
    add_film_rows(rows, elements, outputs);
    add_sample_rows(rows, elements, outputs);
    return rows;
}
