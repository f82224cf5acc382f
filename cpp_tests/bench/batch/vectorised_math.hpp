// The pieces of the vectorised loops. For -Ofast: no branches.
#pragma once

#include "materials.hpp"
#include "vectorised.hpp"

#include <cmath>

// Of its own in every width: the compiler must not merge what was compiled for different ones.
namespace vectorised::VECTORISED_WIDTH {
namespace {

struct Vector {
    float x, y, z;
};
struct Color {
    float r, g, b;
};

inline float dot(Vector a, Vector b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline float at_least(float a, float least) {
    return a > least ? a : least;
}
inline float at_most(float a, float greatest) {
    return a < greatest ? a : greatest;
}
inline float pow5(float x) {
    return x * x * (x * x) * x;
}

// Below, glibc's vector functions call the scalar ones for the element.
constexpr float least_exponent = -80;

// Of max(0, cosine), but for e^-80.
inline float power(float cosine, float exponent) {
    return std::exp(at_least(exponent * std::log(at_least(cosine, 1e-30f)), least_exponent));
}

inline Color operator*(float a, Color c) {
    return {a * c.r, a * c.g, a * c.b};
}
inline Color operator+(Color a, Color b) {
    return {a.r + b.r, a.g + b.g, a.b + b.b};
}
inline Color color(const float (&c)[3]) {
    return {c[0], c[1], c[2]};
}

// `f` of every element, 0 for directions below the horizon.
template <bool varies, class F> inline void each(const In &in, const Out &out, std::size_t count, F f) {
    const Components wo = in.wo, wi = in.wi;
    const float *varying = in.varying;
    float *const r = out.r, *const g = out.g, *const b = out.b;
#pragma GCC ivdep
    for (std::size_t i = 0; i < count; ++i) {
        const Vector o = {wo.x[i], wo.y[i], wo.z[i]}, v = {wi.x[i], wi.y[i], wi.z[i]};
        const Color value = f(o, v, varies ? varying[i] : 0);
        const float above = (o.z > 0) & (v.z > 0) ? 1.0f : 0.0f;
        r[i] = above * value.r;
        g[i] = above * value.g;
        b[i] = above * value.b;
    }
}

struct Half {
    float z, cosine; // n.h and wo.h
};

inline Half half(Vector wo, Vector wi) {
    const Vector sum = {wo.x + wi.x, wo.y + wi.y, wo.z + wi.z};
    const float scale = 1 / std::sqrt(dot(sum, sum));
    return {sum.z * scale, at_most(dot(wo, sum) * scale, 1)};
}

// D G / (4 n.v) of GGX; see plain::Ggx.
inline float ggx(float alpha, Half h, float nv, float nl) {
    const float a2 = alpha * alpha, t = h.z * h.z * (a2 - 1) + 1;
    const float lengths = nl * std::sqrt(nv * nv * (1 - a2) + a2) + nv * std::sqrt(nl * nl * (1 - a2) + a2);
    return 0.5f / material::pi * a2 * nl / (t * t * lengths);
}

// See plain::Beckmann.
inline float lambda(float alpha, float cosine) {
    const float a = cosine / (alpha * std::sqrt(at_least(1 - cosine * cosine, 1e-12f)));
    const float approximation = (1 - 1.259f * a + 0.396f * a * a) / (3.535f * a + 2.181f * a * a);
    return a < 1.6f ? approximation : 0;
}

inline float beckmann(float alpha, Half h, float nv, float nl) {
    const float a2 = alpha * alpha, c2 = h.z * h.z;
    const float gaussian = std::exp(at_least((c2 - 1) / (c2 * a2), least_exponent));
    return 0.25f * gaussian / (material::pi * a2 * c2 * c2 * (1 + lambda(alpha, nv) + lambda(alpha, nl)) * nv);
}

inline float schlick(float f0, float weight) {
    return f0 + (1 - f0) * weight;
}

inline Color schlick(const float (&f0)[3], float cosine) {
    const float weight = pow5(1 - cosine);
    return {schlick(f0[0], weight), schlick(f0[1], weight), schlick(f0[2], weight)};
}

// See plain::Dielectric.
inline float dielectric(float eta, float c) {
    const float g = std::sqrt(eta * eta - 1 + c * c);
    const float s = (g - c) / (g + c), p = (c * (g + c) - 1) / (c * (g - c) + 1);
    return 0.5f * s * s * (1 + p * p);
}

// See plain::Conductor.
inline float conductor(float eta, float k, float c) {
    const float c2 = c * c, s2 = 1 - c2;
    const float t0 = eta * eta - k * k - s2;
    const float norm = std::sqrt(t0 * t0 + 4 * eta * eta * k * k);
    const float t1 = norm + c2, t2 = 2 * c * std::sqrt(0.5f * (norm + t0));
    const float t3 = c2 * norm + s2 * s2, t4 = t2 * s2;
    // Rs (1 + Rp / Rs) / 2 = t1 - t2 over t1 + t2, times t3 over t3 + t4: one division.
    return (t1 - t2) * t3 / ((t1 + t2) * (t3 + t4));
}

inline Color conductor(float c) {
    using material::metal_eta, material::metal_k;
    return {conductor(metal_eta[0], metal_k[0], c), conductor(metal_eta[1], metal_k[1], c),
            conductor(metal_eta[2], metal_k[2], c)};
}

// See plain::Bilinear.
struct Corners {
    int first; // index of the first corner
    float u, v;

    Corners(float cos_theta, float thickness_nm) {
        const float x = at_most(at_least(cos_theta, 0), 1) * 63;
        const float y = at_most(at_least(thickness_nm, 0), material::greatest_nm) * (255 / material::greatest_nm);
        const float i = at_most(float(int(x)), 62), j = at_most(float(int(y)), 254);
        first = int(j) * 64 + int(i);
        u = x - i;
        v = y - j;
    }

    float between(const float *plane) const {
        const float *corner = plane;
        const float a = corner[first] + u * (corner[first + 1] - corner[first]);
        const float b = corner[first + 64] + u * (corner[first + 65] - corner[first + 64]);
        return a + v * (b - a);
    }

    Color between(const FilmPlanes &film) const { return {between(film.r), between(film.g), between(film.b)}; }
};

// See plain::Curve.
struct Ends {
    int first;
    float u;

    explicit Ends(float cosine) {
        const float x = at_most(at_least(cosine, 0), 1) * 63;
        const float i = at_most(float(int(x)), 62);
        first = int(i);
        u = x - i;
    }

    float between(const float *values) const {
        return values[first] + u * (values[first + 1] - values[first]);
    }
};

} // namespace
} // namespace vectorised::VECTORISED_WIDTH
