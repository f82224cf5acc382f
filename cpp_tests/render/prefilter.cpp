#include "prefilter.hpp"

#include "frame.hpp"
#include "glossy_metal.hpp"
#include "parallel.hpp"
#include "sampler.hpp"

#include <algorithm>

namespace render {
namespace {

constexpr int greatestHeight = 256, leastHeight = 32;
/// Pairs of samples for a texel: more where there are fewer texels, and light comes from everywhere.
constexpr int leastPairs = 64, greatestPairs = 256;

/// A power of two with texels about as wide as alpha, radians: a lobe of GGX falls to a quarter of its height
/// where the half vector is alpha away from the normal, and wi twice as far. Never more than the map has.
int heightFor(float roughness, const LatLongMap &map) {
    const float alpha = roughness * roughness;
    int height = std::min(map.height, greatestHeight);
    while (height > leastHeight && 2 * pi / static_cast<float>(height) < 1.2f * alpha) height /= 2;
    return height;
}

std::vector<LatLongMap> allPrefiltered(const LatLongMap &map, int threads) {
    const Environment environment(map);
    std::vector<LatLongMap> maps{map};
    for (int i = 1; i <= PrefilteredEnvironment::steps; ++i) {
        const float roughness = static_cast<float>(i) / PrefilteredEnvironment::steps;
        const int height = heightFor(roughness, map);
        const int pairs = std::clamp(greatestPairs * leastHeight / height, leastPairs, greatestPairs);
        maps.push_back(prefiltered(environment, roughness, height, pairs, threads));
    }
    return maps;
}

/// The lobe of a surface that is seen from its normal.
class FacingLobe {
public:
    explicit FacingLobe(float roughness)
        : bsdf_(glossyMetal(roughness, Rgb(1), Rgb(1))) {}

    struct Sum {
        Rgb radiance{0}; ///< weighted
        float weight = 0;
    };

    /// Adds a sample of the lobe around a direction and one of the light, joined by the balance heuristic.
    void add(const Environment &environment, const Frame &frame, Sampler &sampler, Sum &sum) const {
        const auto addWeighted = [&](const Rgb &radiance, float weight) {
            sum.radiance += radiance * weight;
            sum.weight += weight;
        };
        const Sampler::Numbers numbers = sampler.next();
        const float uniforms[3] = {numbers[2], numbers[0], numbers[1]};
        const PellicleSample own = bsdf_.sample(&normal.x, uniforms);
        if (own.wi[2] > 0) {
            const V3f direction = frame.toWorld(V3f(own.wi[0], own.wi[1], own.wi[2]));
            const float share = own.pdf / (own.pdf + environment.pdf(direction));
            addWeighted(environment.radiance(direction), own.wi[2] * share);
        }
        const LightSample light = environment.sample(sampler.next(1).at2d(0));
        const V3f wi = frame.toLocal(light.direction);
        if (light.pdf > 0 && wi.z > 0) {
            const float pdf = bsdf_.pdf(&normal.x, &wi.x);
            addWeighted(light.radiance, wi.z * pdf / (light.pdf + pdf));
        }
    }

private:
    static inline const V3f normal{0, 0, 1};

    pellicle::Bsdf bsdf_;
};

} // namespace

LatLongMap prefiltered(const Environment &environment, float roughness, int height, int pairs, int threads) {
    const FacingLobe lobe(roughness);
    LatLongMap map{2 * height, height, {}};
    map.texels.resize(static_cast<std::size_t>(map.width) * height);
    parallelFor(height, threads, [&](int row) {
        const float cosTheta = std::cos(pi * (static_cast<float>(row) + 0.5f) / static_cast<float>(height));
        for (int column = 0; column < map.width; ++column) {
            const Frame frame = frameAround(
                latLongDirection((static_cast<float>(column) + 0.5f) / static_cast<float>(map.width), cosTheta));
            const auto index = static_cast<std::size_t>(row) * map.width + column;
            Sampler sampler(pairs, static_cast<std::uint32_t>(index));
            FacingLobe::Sum sum;
            for (int i = 0; i < pairs; ++i) {
                sampler.start({0, 0}, i);
                lobe.add(environment, frame, sampler, sum);
            }
            map.texels[index] = sum.weight > 0 ? sum.radiance / sum.weight : Rgb(0);
        }
    });
    return map;
}

PrefilteredEnvironment::PrefilteredEnvironment(const LatLongMap &map, const std::filesystem::path &file, int threads)
    : texture_(allPrefiltered(map, threads), Layout::parts, file) {}

Rgb PrefilteredEnvironment::radiance(const V3f &direction, float roughness) const {
    const float place = std::clamp(roughness, 0.0f, 1.0f) * steps;
    const int part = std::min(static_cast<int>(place), steps - 1);
    const float t = place - static_cast<float>(part);
    // Roughnesses that have a map of their own need no other.
    constexpr float slack = 1e-4f;
    if (t < slack) return texture_.radiance(direction, part, 0);
    if (t > 1 - slack) return texture_.radiance(direction, part + 1, 0);
    return texture_.radiance(direction, part, 0) * (1 - t) + texture_.radiance(direction, part + 1, 0) * t;
}

} // namespace render
