// Directions that a BSDF chooses, with the solid angle that each stands for.
#pragma once

#include "math.hpp"

#include <pellicle.hpp>

#include <vector>

namespace render {

struct LobeSample {
    V3f wi; ///< in the shading frame
    Rgb weight;
    float solidAngle; ///< 1 / (count pdf), sr; 0 for a Dirac lobe
};

/// Uniform numbers for samples, the same every time: a scrambled Sobol' sequence.
std::vector<V3f> lobeUniforms(int count);

/// One sample for each of `uniforms`, into `samples`; those without a valid direction have weight 0.
/// Throws pellicle::Error.
void sampleLobe(const pellicle::Bsdf &bsdf, const V3f &wo, const std::vector<V3f> &uniforms,
                std::vector<LobeSample> &samples);

} // namespace render
