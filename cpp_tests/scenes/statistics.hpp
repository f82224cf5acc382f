// Means of repeated renderings and how far to trust them.
#pragma once

#include "render.hpp"

#include <array>
#include <functional>
#include <vector>

/// Of independent repetitions.
struct Estimate {
    double mean, standardError;
};
Estimate estimate(const std::vector<double> &repetitions);

/// Within 4 standard errors of each other, which independent estimates of one number miss once in
/// 16 000 times (more often when few repetitions estimate the error); seeds being fixed, a test that
/// passes goes on passing.
bool agree(const Estimate &a, const Estimate &b);

using RgbEstimate = std::array<Estimate, 3>;

/// Each channel's mean over the picture, from `repetitions` renderings with different seeds. Within a
/// picture samples are stratified and not independent; pictures are.
RgbEstimate pictureMean(int repetitions,
                        const std::function<render::Picture(std::uint32_t seed)> &renderOnce);
