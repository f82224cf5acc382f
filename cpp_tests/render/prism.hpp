// A beam of white light that a prism takes apart, traced from the lamp by spectral calls.
#pragma once

#include "math.hpp"

#include <OpenImageIO/imagebuf.h>

#include <functional>
#include <vector>

namespace render {

/// Rays have the density of a beam of white light; in air, light passes unseen but for a thin smoke.
struct PrismSettings {
    int width = 960, height = 540;
    int rays = 1 << 16;
    int threads = 0;
};

/// A straight piece of a ray: from, to, and what it carries at one wavelength, nm.
struct Segment {
    V2f from, to;
    float wavelength, power;
};

/// The picture's plane is 16 wide and 9 high, with the origin in the middle. The prism is an equilateral triangle of SF11
/// glass, seen along its edge. Calls `seen` with every piece of every ray; the power of all rays together is 1.
void tracePrism(int firstRay, int rays, int allRays, const std::function<void(const Segment &)> &seen);

/// What a smoke shows of the light, linear, and the prism.
OIIO::ImageBuf prismPicture(const PrismSettings &settings);

/// Linear Rec.709 of a wavelength, nm, so that light of equal power at 390-730 nm is (1, 1, 1) in the mean: colour matching
/// functions by C. Wyman, P.-P. Sloan and P. Shirley, "Simple Analytic Approximations to the CIE XYZ Color Matching
/// Functions", JCGT 2(2), 2013, eq. 4.
Rgb colorOf(float wavelength);

} // namespace render
