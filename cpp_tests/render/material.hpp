// What covers an object: a BSDF of pellicle and the patterns of its varying parameters.
#pragma once

#include "pattern.hpp"

#include <pellicle.hpp>

#include <array>
#include <optional>
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

    /// A normal map: a direction in the surface's tangent frame (normal_map.hpp), z > 0, of any length.
    Material &mapNormals(Pattern normals);

    /// What the surface returns of ambient light (World::setAmbient): for `phong` its diffuse colour.
    Material &reflectAmbient(const Rgb &reflectance);

    const pellicle::Bsdf &bsdf() const { return bsdf_; }

    /// Light passes: the side from which the surface is seen matters, and must not be flipped.
    bool transmits() const { return transmits_; }

    /// Nothing but mirror images: no use sampling the light.
    bool onlyDirac() const { return onlyDirac_; }

    /// The components of all varying parameters, as pellicle's calls take them.
    using Varying = std::array<float, 16>;
    Varying varyingAt(const SurfacePoint &point) const;

    bool hasNormalMap() const { return normals_.has_value(); }
    V3f normalAt(const SurfacePoint &point) const;

    const Rgb &ambientReflectance() const { return ambientReflectance_; }

private:
    pellicle::Bsdf bsdf_;
    std::vector<Pattern> patterns_;
    std::optional<Pattern> normals_;
    Rgb ambientReflectance_{0};
    bool transmits_, onlyDirac_;
};

} // namespace render
