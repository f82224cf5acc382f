// The metal whose reflections are compared.
#pragma once

#include "math.hpp"

#include <pellicle.hpp>

namespace render {

/// `microfacet` with its defaults (ggx, smith, Schlick's Fresnel factor, no compensation), alpha the square
/// of `roughness` (B. Burley, "Physically-Based Shading at Disney", 2012, section 5.4); 0 is a mirror.
pellicle::Bsdf glossyMetal(float roughness, const Rgb &f0, const Rgb &f90);

/// Gold in the lecture's table of F0, its red of 1.022 held to 1.
inline const Rgb goldF0(1.0f, 0.782f, 0.344f);

} // namespace render
