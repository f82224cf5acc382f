// The paper's specular term as a renderer's author would type it in: plain scalar C++ with the
// standard library's functions and a loop over the channels. The baseline of the benchmark.
#pragma once

#include <cmath>

namespace plain {

template <class Real> struct Vec3 {
    Real x, y, z;
};

template <class Real> Real dot(const Vec3<Real> &a, const Vec3<Real> &b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class Real> Real pow5(Real x) {
    return x * x * x * x * x;
}

template <class Real> struct Layered {
    Real eta[3];
    Real ambient_eta;
    Real exponent_reflection, exponent_transmission;
    Real thickness_nm;
    Vec3<Real> base_normal;
};

// f(wo, wi) wi.z of "A Simple Layered RGB BRDF Model" (Granier and Heidrich 2002): eq. 5 with one
// traversal of the layer. wo and wi point away from the surface.
template <class Real>
inline void eval(const Layered<Real> &m, const Vec3<Real> &wo, const Vec3<Real> &wi, Real value[3]) {
    using std::cos, std::pow, std::sqrt;
    constexpr Real pi = Real(3.14159265358979323846);
    constexpr Real lambda_nm[3] = {645, 525, 445};

    if (wo.z <= 0 || wi.z <= 0) {
        value[0] = value[1] = value[2] = 0;
        return;
    }
    const Vec3<Real> mirrored = {-wi.x, -wi.y, wi.z};
    const Real cos_r = dot(mirrored, wo);
    const Real lobe_r = cos_r > 0 ? pow(cos_r, m.exponent_reflection) : Real(0);

    for (int c = 0; c < 3; ++c) {
        const Real r0 = m.ambient_eta, r1 = m.eta[c], ratio = r0 / r1;
        const Real f = ((r0 - r1) / (r0 + r1)) * ((r0 - r1) / (r0 + r1));
        const Real fresnel_in = f + (1 - f) * pow5(1 - wi.z);
        const Real reflected = fresnel_in * lobe_r;

        // Directions inside the layer: of the incoming ray, and of the one that leaves along wo.
        const Real cos_in = sqrt(1 - ratio * ratio * (1 - wi.z * wi.z));
        const Real cos_out = sqrt(1 - ratio * ratio * (1 - wo.z * wo.z));
        const Vec3<Real> in = {-ratio * wi.x, -ratio * wi.y, -cos_in};
        const Vec3<Real> out = {-ratio * wo.x, -ratio * wo.y, -cos_out};
        const Real in_n = dot(in, m.base_normal), out_n = dot(out, m.base_normal);
        const Vec3<Real> at_base = {in.x - 2 * in_n * m.base_normal.x, in.y - 2 * in_n * m.base_normal.y,
                                    in.z - 2 * in_n * m.base_normal.z};
        const Real cos_t = -dot(at_base, out);
        Real transmitted = 0;
        if (in_n < 0 && out_n < 0 && cos_t > 0) {
            const Real fresnel_out = (1 - f) * (1 - pow5(1 - cos_out));
            transmitted = (1 - fresnel_in) * fresnel_out * pow(cos_t, m.exponent_transmission);
        }

        const Real phase = pi * r1 * m.thickness_nm / lambda_nm[c] * (cos_in + cos_out);
        const Real rho =
            (reflected + transmitted + 2 * cos(2 * phase) * sqrt(reflected * transmitted)) / 2;
        value[c] = rho * wi.z;
    }
}

} // namespace plain
