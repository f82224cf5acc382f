#include "thickness_map.hpp"

#include "image_file.hpp"

#include <OpenImageIO/imagebuf.h>

#include <algorithm>
#include <random>
#include <stdexcept>

namespace render {
namespace {

/// E[x] and E[x^2] within the footprint.
std::array<float, 2> momentsAt(const Texture &texture, const SurfacePoint &point, float repetitions) {
    std::array<float, 2> moments{};
    texture.lookUp(point, repetitions, 2, moments.data());
    return moments;
}

} // namespace

// S. Rice, "Mathematical Analysis of Random Noise", Bell System Technical Journal 23, 1944, section 2.8: many waves of
// equal amplitude sqrt(2 / N) and independent phases sum to a normal distribution; their excess kurtosis is -1.5 / N.
std::vector<float> unevenness(int size) {
    // Unlike the standard library's distributions, this gives the same numbers everywhere.
    std::mt19937 random(1);
    const auto uniform = [&] { return static_cast<float>(random()) * 0x1p-32f; };
    const auto texels = static_cast<std::size_t>(size);
    std::vector<float> image(texels * texels, 0.0f);
    const float amplitude = std::sqrt(2.0f / unevennessWaves);
    std::vector<float> cosU(texels), sinU(texels);
    for (int wave = 0; wave < unevennessWaves; ++wave) {
        // Whole numbers of waves to a side, so that the square repeats itself.
        const float perSide = lerp(leastWavesPerSide, greatestWavesPerSide, uniform()), angle = 2 * pi * uniform();
        const float alongU = std::round(perSide * std::cos(angle)), alongV = std::round(perSide * std::sin(angle));
        const float phase = 2 * pi * uniform();
        const auto at = [&](std::size_t texel) { return (static_cast<float>(texel) + 0.5f) / static_cast<float>(size); };
        for (std::size_t column = 0; column < texels; ++column) {
            cosU[column] = amplitude * std::cos(2 * pi * alongU * at(column) + phase);
            sinU[column] = amplitude * std::sin(2 * pi * alongU * at(column) + phase);
        }
        for (std::size_t row = 0; row < texels; ++row) {
            const float cosV = std::cos(2 * pi * alongV * at(row)), sinV = std::sin(2 * pi * alongV * at(row));
            for (std::size_t column = 0; column < texels; ++column)
                image[row * texels + column] += cosU[column] * cosV - sinU[column] * sinV;
        }
    }
    return image;
}

std::filesystem::path writeMoments(const std::filesystem::path &directory) {
    constexpr int size = 1024;
    std::vector<float> moments;
    for (const float x : unevenness(size)) {
        moments.push_back(x);
        moments.push_back(x * x);
    }
    makeDirectory(directory);
    const std::filesystem::path file = directory / "unevenness.exr";
    OIIO::ImageSpec spec(size, size, 2, OIIO::TypeFloat);
    spec.channelnames = {"R", "G"};
    OIIO::ImageBuf image(spec);
    image.set_pixels(image.roi(), OIIO::TypeFloat, moments.data());
    if (image.has_error() || !image.write(file.string()))
        throw std::runtime_error("cannot write " + file.string() + ": " + image.geterror());
    return file;
}

ThicknessMap::ThicknessMap(std::shared_ptr<const Texture> moments, float mean, std::vector<UnevenLayer> layers)
    : moments_(std::move(moments)),
      mean_(mean),
      layers_(std::move(layers)) {}

Pattern ThicknessMap::thickness(Minification minification) const {
    return {1, [map = *this, minification](const SurfacePoint &seen, float *thickness) {
                SurfacePoint point = seen;
                if (minification == Minification::none) point.footprint = {V2f(0), V2f(0)};
                *thickness = map.mean_;
                for (const UnevenLayer &layer : map.layers_)
                    *thickness += layer.deviation * momentsAt(*map.moments_, point, layer.repetitions)[0];
            }};
}

Pattern ThicknessMap::deviation(float greatest) const {
    return {1, [map = *this, greatest](const SurfacePoint &point, float *deviation) {
                float variance = 0;
                for (const UnevenLayer &layer : map.layers_) {
                    const auto [mean, square] = momentsAt(*map.moments_, point, layer.repetitions);
                    // Rounding makes it negative where the texture is seen in full detail.
                    variance += layer.deviation * layer.deviation * std::max(0.0f, square - mean * mean);
                }
                *deviation = std::min(std::sqrt(variance), greatest);
            }};
}

} // namespace render
