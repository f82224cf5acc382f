#include "vectorised.hpp"
#include "vectorised_math.hpp"

namespace vectorised::VECTORISED_WIDTH {

namespace {

// See plain::eval.
struct Layered {
    static constexpr float lambda_nm[3] = {645, 525, 445};

    static float channel(int c, Vector wo, Vector wi, float lobe_r, float thickness_nm) {
        using material::pi;
        const float *normal = material::deviation;
        const float eta = material::layer_eta[c], ratio = 1 / eta;
        const float f = (1 - eta) / (1 + eta) * ((1 - eta) / (1 + eta));
        const float fresnel_in = f + (1 - f) * pow5(1 - wi.z);
        const float reflected = fresnel_in * lobe_r;
        const float cos_in = std::sqrt(1 - ratio * ratio * (1 - wi.z * wi.z));
        const float cos_out = std::sqrt(1 - ratio * ratio * (1 - wo.z * wo.z));
        // The deviation has no y.
        const float in_n = -ratio * wi.x * normal[0] - cos_in * normal[2];
        const float out_n = -ratio * wo.x * normal[0] - cos_out * normal[2];
        // -<mirrored in, out>
        const float cos_t = 2 * in_n * out_n - ratio * ratio * (wi.x * wo.x + wi.y * wo.y) - cos_in * cos_out;
        const float fresnel_out = (1 - f) * (1 - pow5(1 - cos_out));
        const bool is_seen = (in_n < 0) & (out_n < 0) & (cos_t > 0);
        const float lobe_t = power(cos_t, material::exponent_transmission);
        const float transmitted = is_seen ? (1 - fresnel_in) * fresnel_out * lobe_t : 0;
        const float phase = pi * eta * thickness_nm / lambda_nm[c] * (cos_in + cos_out);
        // -Ofast takes roots of subnormal numbers to be NaN.
        const float both = std::sqrt(at_least(reflected * transmitted, 1e-36f));
        return 0.5f * wi.z * (reflected + transmitted + 2 * std::cos(2 * phase) * both);
    }

    static Color value(Vector wo, Vector wi, float thickness_nm) {
        const float cos_r = wi.z * wo.z - wi.x * wo.x - wi.y * wo.y;
        const float lobe = power(cos_r, material::exponent_reflection);
        return {channel(0, wo, wi, lobe, thickness_nm), channel(1, wo, wi, lobe, thickness_nm),
                channel(2, wo, wi, lobe, thickness_nm)};
    }
};

} // namespace

void lambert(const In &in, const Out &out, std::size_t count) {
    each<false>(in, out, count, [](Vector, Vector wi, float) {
        return wi.z / material::pi * color(material::reflectance);
    });
}

// See plain::oren_nayar. Sines are roots, tangents are sines over cosines.
void oren_nayar(const In &in, const Out &out, std::size_t count) {
    each<false>(in, out, count, [](Vector wo, Vector wi, float) {
        constexpr float pi = material::pi;
        const float s = material::sigma * material::sigma;
        const float oz = at_most(wo.z, 1), iz = at_most(wi.z, 1);
        const float sine_o = std::sqrt(1 - oz * oz), sine_i = std::sqrt(1 - iz * iz);
        // acos falls: the greater angle has the lesser cosine.
        const float part_a = 2 / pi * std::acos(oz < iz ? oz : iz), part_b = 2 / pi * std::acos(oz < iz ? iz : oz);
        const float sine_a = oz < iz ? sine_o : sine_i, sine_b = oz < iz ? sine_i : sine_o;
        const float cos_phi = (wo.x * wi.x + wo.y * wi.y) / at_least(sine_o * sine_i, 1e-12f);
        const float c1 = 1 - 0.5f * s / (s + 0.33f);
        const float cube = cos_phi < 0 ? part_b * part_b * part_b : 0;
        const float c2 = 0.45f * s / (s + 0.09f) * (sine_a - cube);
        const float c3 = 0.125f * s / (s + 0.09f) * (part_a * part_b) * (part_a * part_b);
        const float tan_b = sine_b / (oz < iz ? iz : oz), tan_half = (sine_o + sine_i) / (oz + iz);
        const float direct = c1 + cos_phi * c2 * tan_b + (1 - std::fabs(cos_phi)) * c3 * tan_half;
        const float mutual = 0.17f * s / (s + 0.13f) * (1 - cos_phi * part_b * part_b);
        const auto channel = [=](float rho) { return rho / pi * (direct + rho * mutual) * wi.z; };
        const float *rho = material::reflectance;
        return Color{channel(rho[0]), channel(rho[1]), channel(rho[2])};
    });
}

// cos^2 of the angle to the half vector is (1 + <wo, wi>) / 2.
void disney_diffuse(const In &in, const Out &out, std::size_t count) {
    each<false>(in, out, count, [](Vector wo, Vector wi, float) {
        const float excess = material::disney_roughness * (1 + dot(wo, wi)) - 0.5f;
        const float both = (1 + excess * pow5(1 - wi.z)) * (1 + excess * pow5(1 - wo.z));
        return both * wi.z / material::pi * color(material::reflectance);
    });
}

void phong(const In &in, const Out &out, std::size_t count) {
    each<false>(in, out, count, [](Vector wo, Vector wi, float) {
        const float exponent = material::phong_exponent;
        const float cosine = wo.z * wi.z - wo.x * wi.x - wo.y * wi.y;
        const float lobe = (exponent + 2) / (2 * material::pi) * power(cosine, exponent);
        return wi.z * (1 / material::pi * color(material::phong_diffuse) + lobe * color(material::phong_specular));
    });
}

void layered(const In &in, const Out &out, std::size_t count) {
    each<false>(in, out, count,
                [](Vector wo, Vector wi, float) { return Layered::value(wo, wi, material::layer_nm); });
}

void layered_varying(const In &in, const Out &out, std::size_t count) {
    each<true>(in, out, count, [](Vector wo, Vector wi, float nm) { return Layered::value(wo, wi, nm); });
}

void ggx_schlick(const In &in, const Out &out, std::size_t count) {
    each<false>(in, out, count, [](Vector wo, Vector wi, float) {
        const Half h = half(wo, wi);
        return ggx(material::alpha, h, wo.z, wi.z) * schlick(material::f0, h.cosine);
    });
}

void ggx_schlick_varying(const In &in, const Out &out, std::size_t count) {
    each<true>(in, out, count, [](Vector wo, Vector wi, float alpha) {
        const Half h = half(wo, wi);
        return ggx(alpha, h, wo.z, wi.z) * schlick(material::f0, h.cosine);
    });
}

void ggx_dielectric(const In &in, const Out &out, std::size_t count) {
    each<false>(in, out, count, [](Vector wo, Vector wi, float) {
        const Half h = half(wo, wi);
        const float *eta = material::glass_eta;
        const Color fresnel = {dielectric(eta[0], h.cosine), dielectric(eta[1], h.cosine),
                               dielectric(eta[2], h.cosine)};
        return ggx(material::alpha, h, wo.z, wi.z) * fresnel;
    });
}

void ggx_conductor(const In &in, const Out &out, std::size_t count) {
    each<false>(in, out, count, [](Vector wo, Vector wi, float) {
        const Half h = half(wo, wi);
        return ggx(material::alpha, h, wo.z, wi.z) * conductor(h.cosine);
    });
}

void beckmann_conductor(const In &in, const Out &out, std::size_t count) {
    each<false>(in, out, count, [](Vector wo, Vector wi, float) {
        const Half h = half(wo, wi);
        return beckmann(material::alpha, h, wo.z, wi.z) * conductor(h.cosine);
    });
}

void ggx_film(const FilmPlanes &film, const In &in, const Out &out, std::size_t count) {
    each<true>(in, out, count, [film](Vector wo, Vector wi, float thickness_nm) {
        const Half h = half(wo, wi);
        return ggx(material::alpha, h, wo.z, wi.z) * Corners(h.cosine, thickness_nm).between(film);
    });
}

// See plain::MetallicRoughness.
void metallic_roughness(const Remainder &remainder, const In &in, const Out &out, std::size_t count) {
    const float *values = remainder.values;
    const float scale = (1 - material::metallic) / (material::pi * remainder.mean);
    each<false>(in, out, count, [values, scale](Vector wo, Vector wi, float) {
        const float metallic = material::metallic, dielectric = (1 - metallic) * material::dielectric_f0;
        const float *base = material::base_color;
        const float f0[3] = {dielectric + metallic * base[0], dielectric + metallic * base[1],
                                 dielectric + metallic * base[2]};
        const Half h = half(wo, wi);
        const Color highlight =
            ggx(material::roughness * material::roughness, h, wo.z, wi.z) * schlick(f0, h.cosine);
        const float coupling = scale * Ends(wo.z).between(values) * Ends(wi.z).between(values) * wi.z;
        return highlight + coupling * color(material::base_color);
    });
}

// Films: the cosine is wi.z.
void film(const FilmPlanes &film, const In &in, const Out &out, std::size_t count) {
    const float *cosine = in.wi.z, *thickness = in.varying, *red = film.r, *green = film.g, *blue = film.b;
    float *const r = out.r, *const g = out.g, *const b = out.b;
#pragma GCC ivdep
    for (std::size_t i = 0; i < count; ++i) {
        const Corners corners(cosine[i], thickness[i]);
        r[i] = corners.between(red);
        g[i] = corners.between(green);
        b[i] = corners.between(blue);
    }
}

// Of fixed thickness: 64 values.
void film_curve(const FilmPlanes &film, const In &in, const Out &out, std::size_t count) {
    const float *cosine = in.wi.z, *red = film.r, *green = film.g, *blue = film.b;
    float *const r = out.r, *const g = out.g, *const b = out.b;
#pragma GCC ivdep
    for (std::size_t i = 0; i < count; ++i) {
        const Ends ends(cosine[i]);
        r[i] = ends.between(red);
        g[i] = ends.between(green);
        b[i] = ends.between(blue);
    }
}

} // namespace vectorised::VECTORISED_WIDTH
