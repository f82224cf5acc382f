// What covers an object: a BSDF of pellicle and the patterns of its varying parameters.
#pragma once

#include "pattern.hpp"

#include <pellicle.hpp>

#include <array>
#include <string>
#include <vector>

namespace render {

/// A parameter given per point; `min` and `max` as in PellicleRange.
struct VaryingParameter {
    std::string name;
    float min, max;
    Pattern pattern;
};

class Material {
public:
    /// `bsdf` describes the model and its fixed parameters. Throws pellicle::Error.
    Material(pellicle::BsdfBuilder bsdf, std::vector<VaryingParameter> varying = {});

    const pellicle::Bsdf &bsdf() const { return bsdf_; }

    /// Light passes: the side from which the surface is seen matters, and must not be flipped.
    bool transmits() const { return transmits_; }

    /// Nothing but mirror images: no use sampling the light.
    bool onlyDirac() const { return onlyDirac_; }

    /// The components of all varying parameters, as pellicle's calls take them.
    using Varying = std::array<float, 16>;
    Varying varyingAt(const SurfacePoint &point) const;

private:
    pellicle::Bsdf bsdf_;
    std::vector<Pattern> patterns_;
    bool transmits_, onlyDirac_;
};

} // namespace render
