// Microfacets as a renderer's author would type them in: plain scalar C++ with the standard library's
// functions. Baselines of the table of batches.
#pragma once

#include "../plain_film.hpp"
#include "plain_diffuse.hpp"

namespace plain {

inline Direction normalized(const Direction &v) {
    const float scale = 1 / std::sqrt(dot(v, v));
    return {v.x * scale, v.y * scale, v.z * scale};
}

// D, and G over 4 (n.v) (n.l).
struct Ggx {
    float alpha;

    // Walter et al. 2007, "Microfacet Models for Refraction through Rough Surfaces", eq. 33.
    float density(const Direction &h) const {
        const float a2 = alpha * alpha, t = h.z * h.z * (a2 - 1) + 1;
        return a2 / (material::pi * t * t);
    }

    // Heitz 2014, "Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs", eq. 72 and 99.
    float visibility(float nv, float nl) const {
        const float a2 = alpha * alpha;
        return 0.5f / (nl * std::sqrt(nv * nv * (1 - a2) + a2) + nv * std::sqrt(nl * nl * (1 - a2) + a2));
    }
};

struct Beckmann {
    float alpha;

    // Walter et al. 2007, eq. 25.
    float density(const Direction &h) const {
        const float a2 = alpha * alpha, c2 = h.z * h.z;
        return std::exp((c2 - 1) / (c2 * a2)) / (material::pi * a2 * c2 * c2);
    }

    // The rational approximation of Walter et al. 2007 as Lambda: Heitz 2014, after eq. 72.
    float lambda(float cosine) const {
        const float a = cosine / (alpha * std::sqrt(std::max(1 - cosine * cosine, 1e-12f)));
        return a < 1.6f ? (1 - 1.259f * a + 0.396f * a * a) / (3.535f * a + 2.181f * a * a) : 0;
    }

    float visibility(float nv, float nl) const { return 0.25f / ((1 + lambda(nv) + lambda(nl)) * nv * nl); }
};

struct Schlick {
    float f0[3];
    float operator()(int c, float cosine) const { return f0[c] + (1 - f0[c]) * pow5(1 - cosine); }
};

// Exact, eta >= 1: Cook and Torrance 1982, "A Reflectance Model for Computer Graphics", section "Fresnel".
struct Dielectric {
    float eta[3];
    float operator()(int i, float c) const {
        const float g = std::sqrt(eta[i] * eta[i] - 1 + c * c);
        const float s = (g - c) / (g + c), p = (c * (g + c) - 1) / (c * (g - c) + 1);
        return 0.5f * s * s * (1 + p * p);
    }
};

// Exact: Born and Wolf, "Principles of Optics", section 14.2.
struct Conductor {
    float eta[3], k[3];
    float operator()(int i, float c) const {
        const float c2 = c * c, s2 = 1 - c2;
        const float t0 = eta[i] * eta[i] - k[i] * k[i] - s2;
        const float norm = std::sqrt(t0 * t0 + 4 * eta[i] * eta[i] * k[i] * k[i]);
        const float t1 = norm + c2, t2 = 2 * c * std::sqrt(0.5f * (norm + t0));
        const float rs = (t1 - t2) / (t1 + t2);
        const float t3 = c2 * norm + s2 * s2, t4 = t2 * s2;
        return 0.5f * rs * (1 + (t3 - t4) / (t3 + t4));
    }
};

template <class Normals, class Fresnel>
void microfacet(const Normals &normals, const Fresnel &fresnel, const Direction &wo, const Direction &wi,
                float value[3]) {
    if (is_below(wo, wi, value)) return;
    const Direction h = normalized({wo.x + wi.x, wo.y + wi.y, wo.z + wi.z});
    const float highlight = normals.density(h) * normals.visibility(wo.z, wi.z) * wi.z;
    const float cosine = std::min(dot(wo, h), 1.0f);
    for (int c = 0; c < 3; ++c) value[c] = highlight * fresnel(c, cosine);
}

// The same with a film's colour for F.
inline void coated(const Ggx &normals, const Bilinear &film, float thickness_nm, const Direction &wo,
                   const Direction &wi, float value[3]) {
    if (is_below(wo, wi, value)) return;
    const Direction h = normalized({wo.x + wi.x, wo.y + wi.y, wo.z + wi.z});
    const float highlight = normals.density(h) * normals.visibility(wo.z, wi.z) * wi.z;
    film.at(dot(wo, h), thickness_nm, value);
    for (int c = 0; c < 3; ++c) value[c] *= highlight;
}

// A function of the cosine between equidistant values.
struct Curve {
    static constexpr int width = 64;
    float values[width];

    float at(float cosine) const {
        const float x = std::clamp(cosine, 0.0f, 1.0f) * (width - 1);
        const int i = std::min(int(x), width - 2);
        return values[i] + (x - i) * (values[i + 1] - values[i]);
    }
};

// A metal and a coated diffuse part mixed: the highlight's remainder 1 - E, from both sides, goes to the
// diffuse part (Kelemen and Szirmay-Kalos 2001, "A Microfacet Based Coupled Specular-Matte BRDF Model with
// Importance Sampling", section 2.2).
struct MetallicRoughness {
    Schlick fresnel; // of the dielectric's f0 and the base colour, mixed
    Curve remainder; // of the dielectric
    float mean;      // of the remainder, weighted by the cosine

    void eval(const Direction &wo, const Direction &wi, float value[3]) const {
        if (is_below(wo, wi, value)) return;
        float highlight[3];
        microfacet(Ggx{material::roughness * material::roughness}, fresnel, wo, wi, highlight);
        const float coupling = (1 - material::metallic) * remainder.at(wo.z) * remainder.at(wi.z) / mean;
        for (int c = 0; c < 3; ++c)
            value[c] = highlight[c] + material::base_color[c] / material::pi * coupling * wi.z;
    }
};

// A visible normal of GGX: Dupuy and Benyoub 2023, "Sampling Visible GGX Normals with Spherical Caps",
// listing 3.
inline Direction visible_normal(float alpha, const Direction &wo, float u0, float u1) {
    const Direction view = normalized({alpha * wo.x, alpha * wo.y, wo.z});
    const float phi = 2 * material::pi * u0;
    const float z = (1 - u1) * (1 + view.z) - view.z;
    const float sine = std::sqrt(std::clamp(1 - z * z, 0.0f, 1.0f));
    return normalized(
        {alpha * (sine * std::cos(phi) + view.x), alpha * (sine * std::sin(phi) + view.y), z + view.z});
}

// A direction by a visible normal, its density, and value / pdf = F G / G1(wo).
template <class Fresnel>
void sample(const Ggx &normals, const Fresnel &fresnel, const Direction &wo, float u0, float u1, Direction &wi,
            float &pdf, float weight[3]) {
    wi = {0, 0, 0};
    pdf = weight[0] = weight[1] = weight[2] = 0;
    if (wo.z <= 0) return;
    const Direction h = visible_normal(normals.alpha, wo, u0, u1);
    const float cosine = dot(wo, h);
    const Direction found = {2 * cosine * h.x - wo.x, 2 * cosine * h.y - wo.y, 2 * cosine * h.z - wo.z};
    if (found.z <= 0) return;
    wi = found;
    // D G1(wo) / (4 n.v), G1 = 2 n.v / (n.v + sqrt(...)).
    const float a2 = normals.alpha * normals.alpha;
    pdf = normals.density(h) / (2 * (wo.z + std::sqrt(a2 + (1 - a2) * wo.z * wo.z)));
    float value[3];
    microfacet(normals, fresnel, wo, wi, value);
    for (int c = 0; c < 3; ++c) weight[c] = value[c] / pdf;
}

} // namespace plain
