// Films: nanoseconds per colour beside plain C++ that a renderer would hold instead, and the errors
// against full wave optics, of the clipped colours.

#include "film.hpp"
#include "contender.hpp"
#include "plain_film.hpp"

#include <pellicle.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <functional>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace {

using Vec3 = std::array<float, 3>;
using Color = std::function<Vec3(float cos_theta, float thickness_nm)>;

constexpr float greatest_nm = 1000.0f;
constexpr float fixed_nm = 350.0f;
constexpr std::size_t error_points = 500;

struct Points {
    std::vector<float> cos_theta, thickness_nm;
};

struct Row {
    pellicle::Film film; // whose reference is the truth
    Color color;
    std::size_t baseline; // the row that ratios are against
};

// Rows and their contenders, side by side.
struct Suite {
    const Points &points;
    std::vector<Contender> contenders;
    std::vector<Row> rows;

    // A row that is timed call by call; `call` stores a colour.
    template <class Call>
    void add(const std::string &name, const pellicle::Film &film, bool is_baseline, const Call &call) {
        const std::size_t baseline = is_baseline ? rows.size() : rows.back().baseline;
        const Points &points = this->points;
        contenders.push_back({name, count, [&points, call] {
                                  float sum = 0.0f, value[3];
                                  for (std::size_t i = 0; i < count; ++i) {
                                      call(points.cos_theta[i], points.thickness_nm[i], value);
                                      sum += value[0] + value[1] + value[2];
                                  }
                                  return sum;
                              }, {}});
        const Color color = [call](float cos_theta, float thickness_nm) {
            Vec3 value{};
            call(cos_theta, thickness_nm, value.data());
            return value;
        };
        rows.push_back({film, color, baseline});
    }

    void add_single(const std::string &name, const pellicle::Film &film, bool is_baseline = false) {
        add(name, film, is_baseline, [film, raw = film.raw()](float cos_theta, float thickness_nm, float *value) {
            pellicle_film_reflectance(raw, cos_theta, thickness_nm, value);
        });
    }

    void add_batch(const std::string &name, const pellicle::Film &film) {
        const auto batch = [film](const float *cos_theta, const float *thickness_nm, std::size_t size, Vec3 *value) {
            PellicleFilmBatchArgs args{};
            args.count = size;
            args.cos_theta = {cos_theta, sizeof(float), sizeof(float)};
            args.thickness_nm = {thickness_nm, sizeof(float), sizeof(float)};
            args.reflectance = {value->data(), sizeof(Vec3), sizeof(float)};
            film.reflectance_batch(args);
        };
        const Points &points = this->points;
        contenders.push_back({name, count, [&points, batch] {
                                  static std::vector<Vec3> values(count);
                                  batch(points.cos_theta.data(), points.thickness_nm.data(), count, values.data());
                                  return values[0][0];
                              }, {}});
        const Color color = [batch](float cos_theta, float thickness_nm) {
            Vec3 value{};
            batch(&cos_theta, &thickness_nm, 1, &value);
            return value;
        };
        rows.push_back({film, color, rows.back().baseline});
    }
};

Points random_points() {
    Points points;
    std::mt19937 random(2);
    std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
    for (std::size_t i = 0; i < count; ++i) {
        points.cos_theta.push_back(uniform(random));
        points.thickness_nm.push_back(greatest_nm * uniform(random));
    }
    return points;
}

Vec3 clipped_reference(const pellicle::Film &film, float cos_theta, float thickness_nm) {
    Vec3 rgb = film.reference(cos_theta, thickness_nm);
    for (float &channel : rgb) channel = std::clamp(channel, 0.0f, 1.0f);
    return rgb;
}

// A film whose thickness varies, on a base.
struct Stack {
    const char *name;
    float eta, base_eta, base_k;

    pellicle::FilmBuilder builder() const {
        pellicle::FilmBuilder builder(pellicle::Medium::constant(base_eta, base_k));
        return builder.layer(pellicle::Medium::constant(eta), 0.0f, greatest_nm);
    }
};

void add_lookup(Suite &suite, const std::string &name, const pellicle::Film &film) {
    const auto truth = [&film](float cos_theta, float thickness_nm) {
        return clipped_reference(film, cos_theta, thickness_nm);
    };
    const auto table = std::make_shared<plain::Bilinear>(greatest_nm, truth);
    suite.add(name + ": plain bilinear look-up, 64 x 256", film, true,
              [table](float cos_theta, float thickness_nm, float *value) {
                  table->at(cos_theta, thickness_nm, value);
              });
}

void add_planned(Suite &suite, const std::string &name, const pellicle::Film &film) {
    const PellicleFilmPlan plan = film.plan();
    const std::string size = std::to_string(plan.bytes) + " bytes";
    suite.add_single(name + ": film_reflectance, " + plan.method + " of " + size, film);
    suite.add_batch(name + ": film_reflectance_batch", film);
}

// The method "harmonics" with three terms: the plan takes the fewest that hold the tolerance and says
// how many, so tolerances are tried.
std::optional<pellicle::Film> three_harmonics(pellicle::FilmBuilder builder) {
    const char reason[] = "3 harmonics,";
    for (float tolerance = 1.0f; tolerance > 1e-4f; tolerance *= 0.9f) {
        try {
            const pellicle::Film film = builder.method("harmonics").tolerance(tolerance).create();
            if (std::strncmp(film.plan().reason, reason, sizeof reason - 1) == 0) return film;
        } catch (const pellicle::Error &) {
            return std::nullopt; // no number of terms holds it
        }
    }
    return std::nullopt;
}

void add_three_harmonics(Suite &suite, const Stack &stack, bool is_baseline) {
    if (const auto three = three_harmonics(stack.builder()))
        suite.add_single(std::string(stack.name) + ": film_reflectance, harmonics, 3 terms", *three, is_baseline);
    else
        std::fprintf(stderr, "%s: no tolerance gives harmonics with 3 terms\n", stack.name);
}

void add_plain_harmonics(Suite &suite, const Stack &stack) {
    const plain::Film film{{stack.eta, stack.eta, stack.eta},
                           {stack.base_eta, stack.base_eta, stack.base_eta},
                           {stack.base_k, stack.base_k, stack.base_k}};
    const auto sensitivity = std::make_shared<plain::Sensitivity>();
    suite.add(std::string(stack.name) + ": plain harmonics, 3 terms", stack.builder().create(), true,
              [film, sensitivity](float cos_theta, float thickness_nm, float *value) {
                  plain::harmonics(film, *sensitivity, cos_theta, thickness_nm, value);
              });
}

struct Error {
    double rms, max;
};

Error error(const Row &row, const Points &points) {
    double sum = 0.0, max = 0.0;
    for (std::size_t i = 0; i < error_points; ++i) {
        const float cos_theta = points.cos_theta[i], thickness_nm = points.thickness_nm[i];
        const Vec3 found = row.color(cos_theta, thickness_nm);
        const Vec3 truth = clipped_reference(row.film, cos_theta, thickness_nm);
        for (int c = 0; c < 3; ++c) {
            const double difference = std::fabs(double(found[c]) - truth[c]);
            sum += difference * difference;
            max = std::max(max, difference);
        }
    }
    return {std::sqrt(sum / (3.0 * error_points)), max};
}

} // namespace

bool bench_films() {
    const Points points = random_points();
    Suite suite{points, {}, {}};

    const Stack stacks[] = {{"soap", 1.33f, 1.0f, 0.0f},
                            {"1.5 on 1.33", 1.5f, 1.33f, 0.0f},
                            {"1.38 on 1.52", 1.38f, 1.52f, 0.0f},
                            {"2.4 on 1.5", 2.4f, 1.5f, 0.0f},
                            {"1.5 on 1.5 + 3i", 1.5f, 1.5f, 3.0f},
                            {"2.4 on 2.9 + 3.1i", 2.4f, 2.9f, 3.1f}};
    for (const Stack &stack : {stacks[0], stacks[5]}) {
        const pellicle::Film film = stack.builder().create();
        add_lookup(suite, stack.name, film);
        add_planned(suite, stack.name, film);
    }
    pellicle::FilmBuilder fixed(pellicle::Medium::constant(1.0f));
    add_planned(suite, "soap of 350 nm", fixed.layer(pellicle::Medium::constant(1.33f), fixed_nm).create());
    for (const Stack &stack : {stacks[1], stacks[4]}) {
        add_plain_harmonics(suite, stack);
        add_three_harmonics(suite, stack, false);
    }
    for (const Stack &stack : stacks) {
        add_three_harmonics(suite, stack, true);
        add_planned(suite, stack.name, stack.builder().create());
    }
    measure(suite.contenders);

    std::printf("\nFilms in vacuum, 0 to %.0f nm; median of %d runs over %zu random cosines and thicknesses;\n"
                "errors of the clipped colours against full wave optics, at %zu of them\n\n"
                "| what | ns per call | against the row that starts the group | RMS error | max error |\n"
                "|---|---:|---:|---:|---:|\n",
                greatest_nm, runs, count, error_points);
    bool all_hold = true;
    for (std::size_t i = 0; i < suite.rows.size(); ++i) {
        const Row &row = suite.rows[i];
        const Contender &contender = suite.contenders[i];
        const Error found = error(row, points);
        std::printf("| %s | %.1f | %.2f | %.1e | %.1e |\n", contender.name.c_str(), contender.median(),
                    contender.median() / suite.contenders[row.baseline].median(), found.rms, found.max);
        all_hold = all_hold && (row.baseline == i || found.max <= row.film.plan().tolerance);
    }
    return all_hold;
}
