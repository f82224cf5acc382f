#include "albedo_table.hpp"

#include "glossy_metal.hpp"
#include "parallel.hpp"

#include <algorithm>

namespace render {
namespace {

/// Equal steps of the roughness and of the cosine's square root, which opens grazing angles.
constexpr int cosines = 32, roughnesses = 32;
constexpr float leastCosine = 1e-4f; ///< at the horizon itself nothing is defined

} // namespace

AlbedoTable::AlbedoTable(int threads)
    : values_(static_cast<std::size_t>(cosines) * roughnesses) {
    parallelFor(roughnesses, threads, [&](int row) {
        const float roughness = static_cast<float>(row) / (roughnesses - 1);
        // Red shows the factor of f0, green that of f90.
        const pellicle::Bsdf bsdf = glossyMetal(roughness, Rgb(1, 0, 0), Rgb(0, 1, 0));
        for (int column = 0; column < cosines; ++column) {
            const float root = static_cast<float>(column) / (cosines - 1), cosine = std::max(root * root, leastCosine);
            const V3f wo(std::sqrt(1 - cosine * cosine), 0, cosine);
            const auto albedo = bsdf.albedo(&wo.x);
            values_[static_cast<std::size_t>(row) * cosines + column] = V2f(albedo[0], albedo[1]);
        }
    });
}

V2f AlbedoTable::at(float cosine, float roughness) const {
    const auto place = [](float t, int count) { return std::clamp(t, 0.0f, 1.0f) * static_cast<float>(count - 1); };
    const float x = place(std::sqrt(std::max(cosine, 0.0f)), cosines), y = place(roughness, roughnesses);
    const int column = std::min(static_cast<int>(x), cosines - 2), row = std::min(static_cast<int>(y), roughnesses - 2);
    const float s = x - static_cast<float>(column), t = y - static_cast<float>(row);
    const V2f *value = &values_[static_cast<std::size_t>(row) * cosines + column];
    return (value[0] * (1 - s) + value[1] * s) * (1 - t) + (value[cosines] * (1 - s) + value[cosines + 1] * s) * t;
}

} // namespace render
