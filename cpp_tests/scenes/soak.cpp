// pellicle_soak: renders scenes again and again for some minutes, with everything made anew each time, and
// fails if pictures change, if pellicle holds a byte more after a round than after the first, or, in long runs, if the
// process's memory grows. Run by `./x check soak`, not by ctest.

#include "held_memory.hpp"
#include "mesh.hpp"
#include "render.hpp"
#include "scenes.hpp"
#include "statistics.hpp"

#include <CLI/CLI.hpp>

#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <exception>
#include <fstream>
#include <stdexcept>

namespace {

namespace fs = std::filesystem;

struct Arguments {
    std::vector<std::string> scenes = {"film-spheres", "textures"};
    double minutes = 10;
    int threads = 2, size = 96, samples = 16, pictures = 8, memory = 1536;
    int leakEachRound = 0; ///< bytes, to prove that a leak is found
};

/// Rounds at the beginning whose memory is not compared: pools of threads and caches fill.
constexpr std::size_t warmUp = 4;
/// Rounds that are made at least.
constexpr std::size_t fewestRounds = 8;
/// Rounds from which on the process's memory is judged. In fewer, what OpenImageIO, TBB and the allocator keep is
/// still changing.
constexpr std::size_t fewestForProcess = 100;
/// What the process's memory may grow by between the two halves of them.
constexpr double allowedGrowth = 0.02;

/// The memory of the process, MiB.
struct ProcessMemory {
    double resident;  ///< pages that are in memory
    double allocated; ///< what was asked of malloc() and not given back, by all libraries
    double unused;    ///< what malloc() keeps for later
};

ProcessMemory processMemory() {
    constexpr double mebibyte = 1 << 20;
    long total = 0, resident = 0;
    std::ifstream("/proc/self/statm") >> total >> resident;
    const struct mallinfo2 heap = mallinfo2();
    return {static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE)) / mebibyte,
            static_cast<double>(heap.uordblks + heap.hblkhd) / mebibyte, static_cast<double>(heap.fordblks) / mebibyte};
}

/// More than that is refused to the process, in address space.
void limitMemory(int mebibytes) {
    const rlimit limit{static_cast<rlim_t>(mebibytes) << 20, static_cast<rlim_t>(mebibytes) << 20};
    if (setrlimit(RLIMIT_AS, &limit) != 0) throw std::runtime_error("cannot limit the memory");
}

/// One scene's pictures over time.
class Series {
public:
    Series(const render::Scene &scene, const render::Subject &subject, const Arguments &arguments)
        : scene_(scene), subject_(subject), arguments_(arguments), first_(Making(*this).rendered(0)) {}

    const std::string &name() const { return scene_.name; }
    std::size_t count() const { return channels_[0].size(); }

    /// Some more, of the next seeds, with all worlds, lights, materials and films made anew, and given up
    /// afterwards.
    void render() {
        const Making making(*this);
        for (int i = 0; i < arguments_.pictures; ++i) add(making.rendered(static_cast<std::uint32_t>(count() + 1)));
    }

    /// Throws if the first picture is not what it was, bit by bit, or the later half of all has another mean
    /// than the earlier one.
    void check() const {
        const std::vector<render::Pixel> again = Making(*this).rendered(0);
        if (again.size() != first_.size() ||
            std::memcmp(again.data(), first_.data(), first_.size() * sizeof(render::Pixel)) != 0)
            throw std::runtime_error(scene_.name + ": the first picture, rendered again, is another");
        for (int channel = 0; channel < 3; ++channel) {
            const auto middle = channels_[channel].begin() + static_cast<long>(count() / 2);
            const Estimate earlier = estimate({channels_[channel].begin(), middle});
            const Estimate later = estimate({middle, channels_[channel].end()});
            std::printf("| %s, channel %d | %.6f +- %.6f | %.6f +- %.6f |\n", name().c_str(), channel, earlier.mean,
                        earlier.standardError, later.mean, later.standardError);
            if (!agree(earlier, later)) throw std::runtime_error(scene_.name + ": the pictures' mean drifts");
        }
    }

private:
    /// A scene that has been made.
    class Making {
    public:
        explicit Making(const Series &series)
            : series_(series),
              environment_(render::environmentOf(series.scene_.lighting, series.subject_.directory)),
              views_(series.scene_.views.make(series.subject_)) {}

        std::vector<render::Pixel> rendered(std::uint32_t seed) const {
            const Arguments &arguments = series_.arguments_;
            render::RenderSettings settings;
            settings.samplesPerPixel = arguments.samples;
            settings.seed = seed;
            settings.threads = arguments.threads;
            settings.path.indirectLimit = 2;
            settings.path.maxBounces = series_.scene_.maxBounces;
            std::vector<render::Pixel> pixels;
            for (std::size_t i = 0; i < views_.size(); ++i) {
                const render::V2f extent = series_.scene_.views.extents.at(i) * static_cast<float>(arguments.size);
                settings.width = static_cast<int>(std::lround(extent.x));
                settings.height = static_cast<int>(std::lround(extent.y));
                const render::Picture picture =
                    renderPicture(*views_[i].world, environment_, views_[i].camera, settings);
                pixels.insert(pixels.end(), picture.pixels.begin(), picture.pixels.end());
            }
            return pixels;
        }

    private:
        const Series &series_;
        const render::Environment environment_;
        const std::vector<render::View> views_;
    };

    void add(const std::vector<render::Pixel> &pixels) {
        double sums[3] = {};
        for (const render::Pixel &pixel : pixels) {
            for (int channel = 0; channel < 3; ++channel) {
                const float radiance = pixel.radiance[channel];
                if (!(radiance >= 0) || !std::isfinite(radiance))
                    throw std::runtime_error(scene_.name + ": a pixel of radiance " + std::to_string(radiance));
                sums[channel] += radiance;
            }
        }
        for (int channel = 0; channel < 3; ++channel)
            channels_[channel].push_back(sums[channel] / static_cast<double>(pixels.size()));
    }

    const render::Scene &scene_;
    const render::Subject &subject_;
    const Arguments &arguments_;
    const std::vector<render::Pixel> first_;
    std::vector<double> channels_[3];
};

/// Prints the least memory of the two halves of all rounds after the first ones; throws if it grew in a long run. What
/// is never given back raises the least; what is in use for a while raises some.
void report(const std::vector<ProcessMemory> &process) {
    const auto begin = process.begin() + static_cast<long>(std::min(warmUp, process.size() / 2));
    const auto middle = begin + (process.end() - begin) / 2;
    const auto least = [](auto from, auto to, double ProcessMemory::*field) {
        return (*std::min_element(from, to, [&](const auto &a, const auto &b) { return a.*field < b.*field; })).*field;
    };
    std::printf("\n| least of the process, MiB | earlier half | later half |\n|---|---:|---:|\n");
    bool grows = false;
    const auto row = [&](const char *name, double ProcessMemory::*field) {
        const double before = least(begin, middle, field), after = least(middle, process.end(), field);
        std::printf("| %s | %.2f | %.2f |\n", name, before, after);
        return after > before * (1 + allowedGrowth);
    };
    row("resident", &ProcessMemory::resident);
    grows = row("allocated", &ProcessMemory::allocated);
    row("kept by malloc()", &ProcessMemory::unused);
    if (process.size() < fewestForProcess)
        std::printf("\nThe process is judged from %zu rounds on.\n", fewestForProcess);
    else if (grows) throw std::runtime_error("the process's memory grows");
}

void soak(const Arguments &arguments) {
    limitMemory(arguments.memory);
    auto mesh = std::make_shared<render::Mesh>(render::readObj(BUNNY));
    standOnFloor(*mesh);
    const render::Subject subject{"bunny", mesh, fs::temp_directory_path() / "pellicle-soak"};

    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    const auto minutes = [&] { return std::chrono::duration<double, std::ratio<60>>(Clock::now() - start).count(); };
    std::vector<Series> all;
    for (const std::string &name : arguments.scenes) all.emplace_back(render::sceneNamed(name), subject, arguments);
    std::vector<ProcessMemory> process;
    HeldMemory afterFirst{};
    double told = 0;
    while (minutes() < arguments.minutes || process.size() < fewestRounds) {
        for (Series &series : all) series.render();
        leak(arguments.leakEachRound);
        const HeldMemory held = heldMemory();
        if (process.empty()) afterFirst = held;
        // What is free but kept by the allocator is no growth.
        malloc_trim(0);
        process.push_back(processMemory());
        if (minutes() >= told) {
            std::fprintf(stderr, "%.1f of %.1f minutes, %zu rounds, %.1f MiB resident, %.1f allocated\n", minutes(),
                         arguments.minutes, process.size(), process.back().resident, process.back().allocated);
            told += 1;
        }
        if (!(held == afterFirst))
            throw std::runtime_error("pellicle leaks: it holds " + std::to_string(held.bytes) + " bytes in " +
                                     std::to_string(held.blocks) + " blocks after round " +
                                     std::to_string(process.size()) + ", and " + std::to_string(afterFirst.bytes) +
                                     " in " + std::to_string(afterFirst.blocks) + " after the first");
    }
    std::printf("%zu rounds of %zu scenes, %d pictures of each, in %.1f minutes, %d threads, at most %d MiB.\n\n",
                process.size(), all.size(), arguments.pictures, minutes(), arguments.threads, arguments.memory);
    std::printf("Pellicle holds %ld bytes in %ld blocks after every round.\n\n", afterFirst.bytes, afterFirst.blocks);
    std::printf("| mean radiance | earlier half | later half |\n|---|---:|---:|\n");
    for (const Series &series : all) series.check();
    report(process);
}

} // namespace

int main(int argc, char **argv) {
    Arguments arguments;
    CLI::App app{"Renders scenes again and again; fails if pictures change or memory grows."};
    app.add_option("scenes", arguments.scenes, "As pellicle_render --list names them")->capture_default_str();
    app.add_option("--minutes", arguments.minutes, "For how long")->check(CLI::Range(0.0, 1e4))->capture_default_str();
    app.add_option("--threads", arguments.threads, "0: one per core")->check(CLI::Range(0, 1024))->capture_default_str();
    app.add_option("--size", arguments.size, "Pixels of a picture's unit")->check(CLI::Range(8, 4096))->capture_default_str();
    app.add_option("--samples", arguments.samples, "Per pixel")->check(CLI::Range(1, 65536))->capture_default_str();
    app.add_option("--pictures", arguments.pictures, "Of each scene, before it is made anew")
        ->check(CLI::Range(1, 1 << 20))
        ->capture_default_str();
    app.add_option("--memory", arguments.memory, "MiB of address space that the process may have")
        ->check(CLI::Range(64, 1 << 20))
        ->capture_default_str();
    app.add_option("--leak", arguments.leakEachRound, "Bytes that are lost in every round: the soak must fail")
        ->check(CLI::Range(0, 1 << 20));
    CLI11_PARSE(app, argc, argv);
    try {
        soak(arguments);
        return 0;
    } catch (const std::exception &error) {
        std::fprintf(stderr, "pellicle_soak: %s\n", error.what());
        return 1;
    }
}
