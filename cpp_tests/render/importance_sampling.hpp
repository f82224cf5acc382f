// Reflection of an environment by samples of BSDF and light together: noise, but no other error.
#pragma once

#include "environment.hpp"
#include "frame.hpp"

#include <pellicle.hpp>

#include <cstdint>

namespace render {

/// E. Veach and L. Guibas, "Optimally Combining Sampling Techniques for Monte Carlo Rendering", SIGGRAPH
/// 1995, equation 9: the balance heuristic, with as many samples of either.
class ImportanceSampling {
public:
    /// `pairs`: samples of the BSDF, and as many of the light. The environment must outlive this.
    ImportanceSampling(const Environment &environment, pellicle::Bsdf bsdf, int pairs);

    /// Reflected towards `toViewer`, in world space. Other seeds give independent estimates.
    Rgb reflected(const Frame &frame, const V3f &toViewer, std::uint32_t seed) const;

private:
    Rgb fromBsdf(const Frame &frame, const V3f &wo, const V3f &uniforms) const;
    Rgb fromLight(const Frame &frame, const V3f &wo, const V2f &uniforms) const;

    const Environment &environment_;
    pellicle::Bsdf bsdf_;
    bool onlyDirac_;
    int pairs_;
};

} // namespace render
