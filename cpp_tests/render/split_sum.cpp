#include "split_sum.hpp"

namespace render {

SplitSum::SplitSum(const PrefilteredEnvironment &environment, const AlbedoTable &albedo, float roughness,
                   const Rgb &f0, const Rgb &f90)
    : environment_(environment),
      albedo_(albedo),
      roughness_(roughness),
      f0_(f0),
      f90_(f90) {}

Rgb SplitSum::reflected(const Frame &frame, const V3f &toViewer) const {
    const float cosine = dot(frame.normal, toViewer);
    const V3f mirrored = frame.normal * (2 * cosine) - toViewer;
    const V2f albedo = albedo_.at(cosine, roughness_);
    return environment_.radiance(mirrored, roughness_) * (f0_ * albedo.x + f90_ * albedo.y);
}

} // namespace render
