// Reflection of an environment in real time: a look-up in a prefiltered environment and one in a table.
#pragma once

#include "albedo_table.hpp"
#include "frame.hpp"
#include "prefilter.hpp"

namespace render {

/// B. Karis, "Real Shading in Unreal Engine 4", SIGGRAPH 2013 course: the integral of light times BSDF as the
/// product of their integrals. Exact in a constant environment and for a mirror; otherwise the lobe is that of
/// a surface seen from its normal, round and centred on the mirror direction.
class SplitSum {
public:
    /// Both must outlive this.
    SplitSum(const PrefilteredEnvironment &environment, const AlbedoTable &albedo, float roughness, const Rgb &f0,
             const Rgb &f90);

    /// Reflected towards `toViewer`, in world space.
    Rgb reflected(const Frame &frame, const V3f &toViewer) const;

private:
    const PrefilteredEnvironment &environment_;
    const AlbedoTable &albedo_;
    float roughness_;
    Rgb f0_, f90_;
};

} // namespace render
