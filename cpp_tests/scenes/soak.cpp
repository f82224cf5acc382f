// pellicle_soak: renders scenes again and again for some minutes, with everything made anew each time, and
// fails if pictures change or memory grows. Run by `./x check soak`, not by ctest.

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
};

/// Rounds at the beginning whose memory is not compared: pools of threads and caches fill.
constexpr std::size_t warmUp = 4;
/// Rounds that are compared at least.
constexpr std::size_t fewestCompared = 8;
/// What memory may grow by between the two halves of them.
constexpr double allowedGrowth = 0.01;

/// Of the process, in pages that are in memory, MiB.
double residentMiB() {
    long total = 0, resident = 0;
    std::ifstream("/proc/self/statm") >> total >> resident;
    return static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1 << 20);
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
    std::vector<double> resident;
    double told = 0;
    while (minutes() < arguments.minutes || resident.size() < warmUp + fewestCompared) {
        for (Series &series : all) series.render();
        // What is free but kept by the allocator is no growth.
        malloc_trim(0);
        resident.push_back(residentMiB());
        if (minutes() >= told) {
            std::fprintf(stderr, "%.1f of %.1f minutes, %zu rounds, %.1f MiB\n", minutes(), arguments.minutes,
                         resident.size(), resident.back());
            told += 1;
        }
    }
    std::printf("%zu rounds of %zu scenes, %d pictures of each, in %.1f minutes, %d threads, at most %d MiB.\n\n",
                resident.size(), all.size(), arguments.pictures, minutes(), arguments.threads, arguments.memory);
    std::printf("| mean radiance | earlier half | later half |\n|---|---:|---:|\n");
    for (const Series &series : all) series.check();
    const auto middle = resident.begin() + static_cast<long>((warmUp + resident.size()) / 2);
    // What is never given back raises the least; what is in use for a while raises some.
    const double before = *std::min_element(resident.begin() + warmUp, middle);
    const double after = *std::min_element(middle, resident.end());
    std::printf("| least memory, MiB | %.2f | %.2f |\n", before, after);
    if (after > before * (1 + allowedGrowth)) throw std::runtime_error("memory grows");
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
    CLI11_PARSE(app, argc, argv);
    try {
        soak(arguments);
        return 0;
    } catch (const std::exception &error) {
        std::fprintf(stderr, "pellicle_soak: %s\n", error.what());
        return 1;
    }
}
