// Diffuse models and Phong's as a renderer's author would type them in: plain scalar C++ with the
// standard library's functions. Baselines of the table of batches.
#pragma once

#include "../plain.hpp"
#include "materials.hpp"

#include <algorithm>
#include <cmath>

namespace plain {

using Direction = Vec3<float>;

inline bool is_below(const Direction &wo, const Direction &wi, float value[3]) {
    if (wo.z > 0 && wi.z > 0) return false;
    value[0] = value[1] = value[2] = 0;
    return true;
}

inline void lambert(const Direction &wo, const Direction &wi, float value[3]) {
    if (is_below(wo, wi, value)) return;
    for (int c = 0; c < 3; ++c) value[c] = material::reflectance[c] / material::pi * wi.z;
}

// Oren and Nayar 1994, "Generalization of Lambert's Reflectance Model", the functional approximation
// of section 4 with both terms.
inline void oren_nayar(const Direction &wo, const Direction &wi, float value[3]) {
    if (is_below(wo, wi, value)) return;
    constexpr float pi = material::pi;
    const float s = material::sigma * material::sigma;
    const float theta_o = std::acos(std::min(wo.z, 1.0f)), theta_i = std::acos(std::min(wi.z, 1.0f));
    const float a = std::max(theta_o, theta_i), b = std::min(theta_o, theta_i);
    const float sines = std::sin(theta_o) * std::sin(theta_i);
    const float cos_phi = sines > 0 ? (wo.x * wi.x + wo.y * wi.y) / sines : 0;

    const float c1 = 1 - 0.5f * s / (s + 0.33f);
    const float cube = 2 * b / pi * (2 * b / pi) * (2 * b / pi);
    const float c2 = 0.45f * s / (s + 0.09f) * (std::sin(a) - (cos_phi < 0 ? cube : 0));
    const float product = 4 * a * b / (pi * pi);
    const float c3 = 0.125f * s / (s + 0.09f) * product * product;
    const float direct =
        c1 + cos_phi * c2 * std::tan(b) + (1 - std::abs(cos_phi)) * c3 * std::tan((a + b) / 2);
    const float mutual = 0.17f * s / (s + 0.13f) * (1 - cos_phi * (2 * b / pi) * (2 * b / pi));
    for (int c = 0; c < 3; ++c) {
        const float rho = material::reflectance[c];
        value[c] = rho / pi * (direct + rho * mutual) * wi.z;
    }
}

// Burley 2012, "Physically-Based Shading at Disney", section 5.3.
inline void disney_diffuse(const Direction &wo, const Direction &wi, float value[3]) {
    if (is_below(wo, wi, value)) return;
    const Direction sum = {wo.x + wi.x, wo.y + wi.y, wo.z + wi.z};
    const float cos_d = dot(wi, sum) / std::sqrt(dot(sum, sum));
    const float fd90 = 0.5f + 2 * material::disney_roughness * cos_d * cos_d;
    const float both = (1 + (fd90 - 1) * pow5(1 - wi.z)) * (1 + (fd90 - 1) * pow5(1 - wo.z));
    for (int c = 0; c < 3; ++c) value[c] = material::reflectance[c] / material::pi * both * wi.z;
}

// Lafortune and Willems 1994, "Using the modified Phong reflectance model for physically based
// rendering", eq. 5 and 6.
inline void phong(const Direction &wo, const Direction &wi, float value[3]) {
    if (is_below(wo, wi, value)) return;
    const float exponent = material::phong_exponent;
    const float cosine = dot(Direction{-wo.x, -wo.y, wo.z}, wi);
    const float lobe = cosine > 0 ? (exponent + 2) / (2 * material::pi) * std::pow(cosine, exponent) : 0;
    for (int c = 0; c < 3; ++c)
        value[c] = (material::phong_diffuse[c] / material::pi + material::phong_specular[c] * lobe) * wi.z;
}

} // namespace plain
