// How a parameter of a BSDF varies over a surface.
#pragma once

#include "noise.hpp"
#include "surface.hpp"

#include <functional>
#include <vector>

namespace render {

/// A varying parameter as a function of the surface point.
struct Pattern {
    int components;
    std::function<void(const SurfacePoint &, float *components)> write;
};

/// Fractal noise in object space.
struct NoiseField {
    float frequency = 2; ///< of the first octave, per unit of length
    int octaves = 3;

    /// The gradient is with respect to object space.
    Noise at(const SurfacePoint &point) const;
};

/// min + (max - min) noise.
Pattern noiseBetween(float min, float max, NoiseField field);

/// A direction `degrees` away from the shading normal, towards the frame's tangent.
Pattern constantDeviation(float degrees);

/// A direction that leans against the noise's slope as the normal of a height field of `height`
/// does (J. Blinn, "Simulation of Wrinkled Surfaces", SIGGRAPH 1978).
Pattern bump(float height, NoiseField field);

/// `values` in steps along `axis`, in object space, from `from` to `to`; the end values beyond.
Pattern steps(const V3f &axis, float from, float to, std::vector<float> values);

/// From 0 at `from` to `max` at `to` along `axis`, in object space, and on beyond `to`; never below 0.
/// Flow carries thick and thin places along: the value is uneven by the fraction `unevenness`.
Pattern draining(const V3f &axis, float from, float to, float max, float unevenness);

/// min + (max - min) noise that looks stirred: the place where noise is read is itself moved by noise.
Pattern stirred(float min, float max, float frequency);

/// Grey that fades from `centre` to `rim` between two distances from the world's vertical axis.
Pattern fadingGrey(float centre, float rim, float from, float to);

} // namespace render
