// pellicle_environment: time and error of three ways to the reflection of an environment, as a table.

#include "environment_ways.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <limits>
#include <memory>
#include <stdexcept>

namespace render {
namespace {

struct Arguments {
    std::filesystem::path out = "docs/environment.csv", maps = "out/maps";
    int size = 40, threads = 0;
};

constexpr int truthPairs = 256, truthRepetitions = 8;
/// Seeds of their own for what is compared with the truth.
constexpr std::uint32_t seed = 1000;

/// Of one thread, by every fifth pixel; the least of some repetitions, as others share the machine.
double nanosecondsPerPixel(const Reflection &way, const std::vector<SpherePixel> &pixels) {
    using Clock = std::chrono::steady_clock;
    constexpr int repetitions = 3;
    constexpr std::size_t step = 5;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < repetitions; ++i) {
        const Clock::time_point start = Clock::now();
        Rgb sum(0);
        std::size_t count = 0;
        for (; count * step < pixels.size(); ++count) sum += way(pixels[count * step]);
        const double time = std::chrono::duration<double, std::nano>(Clock::now() - start).count();
        if (!std::isfinite(sum.x)) throw std::runtime_error("a reflection is not finite");
        least = std::min(least, time / static_cast<double>(count));
    }
    return least;
}

class Table {
public:
    Table(const Arguments &arguments, std::FILE *file)
        : arguments_(arguments),
          file_(file),
          pixels_(spherePixels(arguments.size)),
          albedo_(arguments.threads) {
        std::fprintf(file_, "environment,roughness,method,samples,relative_rms,bias,truth_standard_error,"
                            "ns_per_pixel,importance_ns_for_same_error\n");
    }

    void add(const std::string &name) {
        const PreparedEnvironment environment(name, comparedMap(name), arguments_.maps, arguments_.threads);
        for (int i = 0; i <= PrefilteredEnvironment::steps; ++i)
            addRoughness(environment, static_cast<float>(i) / PrefilteredEnvironment::steps);
    }

private:
    struct Entry {
        const char *method;
        int samples;
        Reflection way;
    };

    void addRoughness(const PreparedEnvironment &environment, float roughness) {
        const Truth expected =
            truth(environment, roughness, truthPairs, truthRepetitions, pixels_, arguments_.threads);
        std::vector<Entry> entries;
        // A pair is one sample of the BSDF and one of the light.
        for (const int pairs : {64, 4, 16, 256})
            entries.push_back({"importance", pairs, importanceWay(environment, roughness, pairs, seed)});
        for (const int samples : {4, 16, 64})
            entries.push_back({"filtered", samples, filteredWay(environment, roughness, samples)});
        entries.push_back({"split_sum", 1, splitSumWay(environment, albedo_, roughness)});

        // The first is the measure of the others: its error falls with the root of its time.
        double measure = 0;
        for (const Entry &entry : entries) {
            const Deviation error = deviation(evaluated(entry.way, pixels_, arguments_.threads), expected);
            const double ns = nanosecondsPerPixel(entry.way, pixels_);
            if (&entry == &entries.front()) measure = error.rms * error.rms * ns;
            std::fprintf(file_, "%s,%.1f,%s,%d,%.3e,%.3e,%.3e,%.0f,", environment.name().c_str(),
                         static_cast<double>(roughness), entry.method, entry.samples, error.rms, error.bias,
                         error.noise, ns);
            // A mirror has no noise to compare with.
            if (roughness > 0) std::fprintf(file_, "%.0f", measure / (error.rms * error.rms));
            std::fputc('\n', file_);
        }
    }

    const Arguments &arguments_;
    std::FILE *file_;
    std::vector<SpherePixel> pixels_;
    AlbedoTable albedo_;
};

void writeTable(const Arguments &arguments) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE *)> file(std::fopen(arguments.out.c_str(), "w"), std::fclose);
    if (!file) throw std::runtime_error("cannot write " + arguments.out.string());
    Table table(arguments, file.get());
    for (const char *name : {"landscape", "studio"}) table.add(name);
    if (std::fflush(file.get()) != 0) throw std::runtime_error("cannot write " + arguments.out.string());
}

} // namespace
} // namespace render

int main(int argc, char **argv) {
    render::Arguments arguments;
    CLI::App app{"Compares importance sampling, filtered sampling and the split sum of an environment's reflection."};
    app.add_option("--out", arguments.out, "The table")->capture_default_str();
    app.add_option("--maps", arguments.maps, "Directory for the environments' images; made if missing")
        ->capture_default_str();
    app.add_option("--size", arguments.size, "Pixels across the sphere")->check(CLI::Range(4, 1024))->capture_default_str();
    app.add_option("--threads", arguments.threads, "Threads for what is not timed; 0: one per core")
        ->check(CLI::Range(0, 1024));
    CLI11_PARSE(app, argc, argv);
    try {
        render::writeTable(arguments);
        return 0;
    } catch (const std::exception &error) {
        std::fprintf(stderr, "pellicle_environment: %s\n", error.what());
        return 1;
    }
}
