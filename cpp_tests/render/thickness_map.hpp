// A thickness that a texture gives, and how much of it a pixel averages.
#pragma once

#include "texture.hpp"

#include <filesystem>
#include <memory>
#include <vector>

namespace render {

/// Waves of all directions with random phases, in a square that repeats itself: mean 0, standard deviation 1, and nearly
/// normal wherever several of them are seen together.
constexpr int unevennessWaves = 64;
/// The square's side in wave lengths.
constexpr float leastWavesPerSide = 8, greatestWavesPerSide = 30;

/// `size` x `size` numbers, rows from the top.
std::vector<float> unevenness(int size);

/// Writes an image of two channels into `directory`: the unevenness and its square, whose smaller sizes are the mean and the
/// mean square. Throws std::runtime_error.
std::filesystem::path writeMoments(const std::filesystem::path &directory);

/// The unevenness, `deviation` nm, seen `repetitions` times along u and v.
struct UnevenLayer {
    float deviation, repetitions;
};

/// What a renderer makes of a thickness that varies within a pixel.
enum class Minification {
    mean,             ///< one colour, that of the footprint's mean thickness: wrong
    meanAndDeviation, ///< colours averaged over the footprint's mean and standard deviation
    none,             ///< full detail wherever a sample falls: right, with many samples
};

/// Thickness and its standard deviation: `mean` nm and the sum of unevennesses, which are independent of each other. Of
/// each the texture knows E[x] and E[x^2] within the footprint; variances E[x^2] - E[x]^2 add up (M. Olano and D. Baker,
/// "LEAN Mapping", I3D 2010, do so with slopes).
class ThicknessMap {
public:
    ThicknessMap(std::shared_ptr<const Texture> moments, float mean, std::vector<UnevenLayer> layers);

    /// nm. Minification::none ignores the footprint.
    Pattern thickness(Minification minification) const;
    /// nm, at most `greatest`.
    Pattern deviation(float greatest) const;

private:
    std::shared_ptr<const Texture> moments_;
    float mean_;
    std::vector<UnevenLayer> layers_;
};

} // namespace render
