#include "environment_ways.hpp"

#include "glossy_metal.hpp"
#include "landscape.hpp"
#include "parallel.hpp"
#include "studio.hpp"

#include <algorithm>
#include <stdexcept>

namespace render {
namespace {

const Rgb f90(1);

pellicle::Bsdf gold(float roughness) { return glossyMetal(roughness, goldF0, f90); }

std::filesystem::path made(const std::filesystem::path &directory) {
    makeDirectory(directory);
    return directory;
}

} // namespace

PreparedEnvironment::PreparedEnvironment(std::string name, const LatLongMap &map,
                                         const std::filesystem::path &directory, int threads)
    : name_(std::move(name)),
      light_(map),
      mipMap_(map, made(directory) / (name_ + ".mip.exr")),
      prefiltered_(map, directory / (name_ + ".prefiltered.tif"), threads) {}

LatLongMap comparedMap(const std::string &name) {
    constexpr int landscapeHeight = 512;
    if (name == "landscape") return drawLatLong(landscapeHeight, Landscape());
    if (name == "studio") return studio();
    throw std::invalid_argument("there is no environment \"" + name + "\"");
}

Reflection splitSumWay(const PreparedEnvironment &environment, const AlbedoTable &albedo, float roughness) {
    return [way = SplitSum(environment.prefiltered(), albedo, roughness, goldF0, f90)](const SpherePixel &pixel) {
        return way.reflected(pixel.frame, sphereToViewer);
    };
}

Reflection filteredWay(const PreparedEnvironment &environment, float roughness, int samples) {
    return [way = FilteredSampling(environment.mipMap(), gold(roughness), samples)](const SpherePixel &pixel) {
        return way.reflected(pixel.frame, sphereToViewer);
    };
}

Reflection importanceWay(const PreparedEnvironment &environment, float roughness, int pairs, std::uint32_t seed) {
    return [way = ImportanceSampling(environment.light(), gold(roughness), pairs), seed](const SpherePixel &pixel) {
        // Pictures are smaller than 1024 x 1024.
        const std::uint32_t place = static_cast<std::uint32_t>(pixel.at.y) << 10 | static_cast<std::uint32_t>(pixel.at.x);
        return way.reflected(pixel.frame, sphereToViewer, seed << 20 | place);
    };
}

std::vector<Rgb> evaluated(const Reflection &way, const std::vector<SpherePixel> &pixels, int threads) {
    std::vector<Rgb> values(pixels.size());
    constexpr int chunk = 64;
    const int count = static_cast<int>(pixels.size());
    parallelFor((count + chunk - 1) / chunk, threads, [&](int part) {
        for (int i = part * chunk; i < std::min(count, (part + 1) * chunk); ++i) values[i] = way(pixels[i]);
    });
    return values;
}

Truth truth(const PreparedEnvironment &environment, float roughness, int pairs, int repetitions,
            const std::vector<SpherePixel> &pixels, int threads) {
    const std::size_t size = pixels.size();
    Truth result{std::vector<Rgb>(size, Rgb(0)), std::vector<Rgb>(size, Rgb(0))};
    std::vector<Rgb> squares(size, Rgb(0));
    const float n = static_cast<float>(repetitions);
    for (int repetition = 0; repetition < repetitions; ++repetition) {
        const auto seed = static_cast<std::uint32_t>(repetition + 1);
        const std::vector<Rgb> values =
            evaluated(importanceWay(environment, roughness, pairs, seed), pixels, threads);
        // The update of B. P. Welford, "Note on a Method for Calculating Corrected Sums of Squares and
        // Products", Technometrics 4(3), 1962.
        for (std::size_t i = 0; i < size; ++i) {
            const Rgb before = values[i] - result.mean[i];
            result.mean[i] += before / static_cast<float>(repetition + 1);
            squares[i] += before * (values[i] - result.mean[i]);
        }
    }
    for (std::size_t i = 0; i < size; ++i) result.variance[i] = squares[i] / (n * (n - 1));
    return result;
}

Deviation deviation(const std::vector<Rgb> &values, const Truth &truth) {
    double squares = 0, noise = 0, power = 0, value = 0, mean = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            const double t = truth.mean[i][c], difference = values[i][c] - t;
            squares += difference * difference;
            noise += truth.variance[i][c];
            power += t * t;
            value += values[i][c];
            mean += t;
        }
    }
    return {std::sqrt(std::max(0.0, squares - noise) / power), value / mean - 1, std::sqrt(noise / power)};
}

} // namespace render
