// Three ways to the reflection of an environment, and how far they are apart.
#pragma once

#include "environment.hpp"
#include "filtered_sampling.hpp"
#include "importance_sampling.hpp"
#include "sphere_pixels.hpp"
#include "split_sum.hpp"

#include <functional>
#include <string>

namespace render {

/// An environment, ready for all ways.
class PreparedEnvironment {
public:
    /// Writes NAME.mip.exr and NAME.prefiltered.tif into `directory`, which is made if missing. Throws
    /// std::runtime_error.
    PreparedEnvironment(std::string name, const LatLongMap &map, const std::filesystem::path &directory,
                        int threads = 0);

    const std::string &name() const { return name_; }
    const Environment &light() const { return light_; }
    const MipMap &mipMap() const { return mipMap_; }
    const PrefilteredEnvironment &prefiltered() const { return prefiltered_; }

private:
    std::string name_;
    Environment light_;
    MipMap mipMap_;
    PrefilteredEnvironment prefiltered_;
};

/// "landscape", the gallery's at half its size, or "studio". Throws std::invalid_argument for other names.
LatLongMap comparedMap(const std::string &name);

/// The radiance of a pixel of the sphere.
using Reflection = std::function<Rgb(const SpherePixel &)>;

/// Gold of this roughness. What they are given must outlive them.
Reflection splitSumWay(const PreparedEnvironment &environment, const AlbedoTable &albedo, float roughness);
Reflection filteredWay(const PreparedEnvironment &environment, float roughness, int samples);
/// `seed` is below 4096.
Reflection importanceWay(const PreparedEnvironment &environment, float roughness, int pairs, std::uint32_t seed);

/// One value for each pixel. `threads` 0: one per core.
std::vector<Rgb> evaluated(const Reflection &way, const std::vector<SpherePixel> &pixels, int threads = 0);

/// The mean of independent repetitions of importance sampling.
struct Truth {
    std::vector<Rgb> mean;
    std::vector<Rgb> variance; ///< of the mean
};
Truth truth(const PreparedEnvironment &environment, float roughness, int pairs, int repetitions,
            const std::vector<SpherePixel> &pixels, int threads = 0);

/// Of all pixels and channels, relative to the truth.
struct Deviation {
    double rms;   ///< root mean square of the differences over that of the truth, whose own noise is taken out
    double bias;  ///< mean over the truth's, less 1
    double noise; ///< the truth's own: root mean square of its standard errors
};
Deviation deviation(const std::vector<Rgb> &values, const Truth &truth);

} // namespace render
