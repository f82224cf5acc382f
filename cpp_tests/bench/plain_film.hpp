// A film's colour as a renderer's author would type it in: plain scalar C++ with the standard
// library's functions and a loop over the channels. The baselines of the films' benchmark.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace plain {

// Linear RGB over cosine and thickness, between the four nearest entries.
struct Bilinear {
    static constexpr int width = 64, height = 256;
    float greatest_nm;
    std::vector<float> rgb; // rows of equal thickness

    template <class Color> Bilinear(float greatest_nm, const Color &color) : greatest_nm(greatest_nm) {
        for (int j = 0; j < height; ++j)
            for (int i = 0; i < width; ++i)
                for (const float channel : color(i / (width - 1.0f), greatest_nm * j / (height - 1.0f)))
                    rgb.push_back(channel);
    }

    void at(float cos_theta, float thickness_nm, float value[3]) const {
        const float x = std::clamp(cos_theta, 0.0f, 1.0f) * (width - 1);
        const float y = std::clamp(thickness_nm, 0.0f, greatest_nm) * ((height - 1) / greatest_nm);
        const int i = std::min(int(x), width - 2), j = std::min(int(y), height - 2);
        const float u = x - i, v = y - j;
        const float *near = &rgb[3 * (j * width + i)], *far = near + 3 * width;
        for (int c = 0; c < 3; ++c) {
            const float a = near[c] + u * (near[c + 3] - near[c]);
            const float b = far[c] + u * (far[c + 3] - far[c]);
            value[c] = a + v * (b - a);
        }
    }
};

struct Complex {
    float re, im;
};

inline Complex operator+(Complex a, Complex b) {
    return {a.re + b.re, a.im + b.im};
}
inline Complex operator-(Complex a, Complex b) {
    return {a.re - b.re, a.im - b.im};
}
inline Complex operator*(Complex a, Complex b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
inline Complex operator*(float a, Complex b) {
    return {a * b.re, a * b.im};
}
inline float squared(Complex a) {
    return a.re * a.re + a.im * a.im;
}
inline Complex operator/(Complex a, Complex b) {
    return (1 / squared(b)) * (a * Complex{b.re, -b.im});
}
// The root with both parts >= 0, of a number with im >= 0.
inline Complex root(Complex a) {
    const float norm = std::sqrt(squared(a));
    return {std::sqrt(std::max(0.0f, (norm + a.re) / 2)), std::sqrt(std::max(0.0f, (norm - a.re) / 2))};
}

// The Fourier transform of the sensitivities of linear Rec.709 under white E, by path difference, with
// the wavenumber in the middle taken out; a perfect mirror is (1, 1, 1).
class Sensitivity {
public:
    Sensitivity() {
        constexpr double rec709[3][3] = {{3.2404542, -1.5371385, -0.4985314}, // IEC 61966-2-1, from XYZ
                                         {-0.9692660, 1.8760108, 0.0415560},
                                         {0.0556434, -0.2040259, 1.0572252}};
        // One entry before 0 and two beyond the end, for the interpolation.
        std::vector<std::array<double, 6>> sums(steps + 4, std::array<double, 6>{});
        double white[3] = {};
        for (double nm = 380.5; nm < 780; ++nm) {
            const std::array<double, 3> xyz = matching_functions(nm);
            double weight[3];
            for (int c = 0; c < 3; ++c) {
                weight[c] = rec709[c][0] * xyz[0] + rec709[c][1] * xyz[1] + rec709[c][2] * xyz[2];
                white[c] += weight[c];
            }
            for (std::size_t i = 0; i < sums.size(); ++i) {
                const double phase = 2 * 3.14159265358979 * (1 / nm - carrier) * (double(i) - 1) * step_nm;
                for (int c = 0; c < 3; ++c) {
                    sums[i][2 * c] += weight[c] * std::cos(phase);
                    sums[i][2 * c + 1] += weight[c] * std::sin(phase);
                }
            }
        }
        for (const auto &sum : sums)
            for (int c = 0; c < 3; ++c)
                table.push_back({float(sum[2 * c] / white[c]), float(sum[2 * c + 1] / white[c])});
    }

    // Of a channel, at a path difference.
    Complex at(int c, float path_nm) const {
        const float position = path_nm / step_nm;
        if (position >= steps) return {0, 0};
        const int i = int(position);
        const float t = position - i;
        // Between the middle two of four entries (Catmull and Rom 1974).
        const Complex *p = &table[3 * i + c];
        const Complex p0 = p[0], p1 = p[3], p2 = p[6], p3 = p[9];
        const Complex square = 2 * p0 - 5 * p1 + 4 * p2 - p3, cube = 3 * (p1 - p2) + p3 - p0;
        const Complex found = p1 + (t / 2) * (p2 - p0 + t * (square + t * cube));
        const float phase = float(2 * 3.14159265358979 * carrier) * path_nm;
        return found * Complex{std::cos(phase), std::sin(phase)};
    }

private:
    static constexpr int steps = 1500;
    static constexpr float step_nm = 24;
    static constexpr double carrier = 0.5 * (1.0 / 380 + 1.0 / 780); // per nm
    std::vector<Complex> table;

    // CIE 1931 x, y and z by Wyman, Sloan and Shirley 2013, "Simple Analytic Approximations to the CIE
    // XYZ Color Matching Functions", section 2.2.
    static std::array<double, 3> matching_functions(double nm) {
        const auto lobe = [nm](double height, double mean, double below, double above) {
            const double t = (nm - mean) / (nm < mean ? below : above);
            return height * std::exp(-t * t / 2);
        };
        return {lobe(1.056, 599.8, 37.9, 31.0) + lobe(0.362, 442.0, 16.0, 26.7) + lobe(-0.065, 501.1, 20.4, 26.2),
                lobe(0.821, 568.8, 46.9, 40.5) + lobe(0.286, 530.9, 16.3, 31.1),
                lobe(1.217, 437.0, 11.8, 36.0) + lobe(0.681, 459.0, 26.0, 13.8)};
    }
};

// A transparent film of index eta in vacuum, on a base of index base_eta + i base_k, per channel.
struct Film {
    float eta[3], base_eta[3], base_k[3];
};

// Belcour and Barla 2017, "A Practical Extension to Microfacet Theory for the Modeling of Varying
// Iridescence", eq. 6-10, with complex amplitudes and three terms:
// R = C0 + 2 Re sum of C(m) S(m path), with g = r01 r12, h = (1 - r01^2) r12,
// C0 = r01^2 + |h|^2 / (1 - |g|^2) and C(m) = (-g)^(m - 1) (r01 h - g |h|^2 / (1 - |g|^2)).
inline void harmonics(const Film &film, const Sensitivity &sensitivity, float cos_theta, float thickness_nm,
                      float value[3]) {
    const float sin_squared = 1 - cos_theta * cos_theta;
    for (int c = 0; c < 3; ++c) {
        const float film_squared = film.eta[c] * film.eta[c];
        const Complex base = {film.base_eta[c], film.base_k[c]}, base_squared = base * base;
        const float film_q = std::sqrt(film_squared - sin_squared);
        const Complex base_q = root(base_squared - Complex{sin_squared, 0});
        const float path_nm = 2 * film_q * thickness_nm;

        // Tangential fields in the three media: of s, then of p.
        const float film_w[2] = {film_q, film_q / film_squared};
        const Complex base_w[2] = {base_q, base_q / base_squared};
        Complex term[2], factor[2];
        float sum = 0;
        for (int pol = 0; pol < 2; ++pol) {
            const float r01 = (cos_theta - film_w[pol]) / (cos_theta + film_w[pol]);
            const Complex r12 = (Complex{film_w[pol], 0} - base_w[pol]) / (Complex{film_w[pol], 0} + base_w[pol]);
            const Complex g = r01 * r12, h = (1 - r01 * r01) * r12;
            const float pairs = squared(h) / std::max(1 - squared(g), 1e-6f);
            sum += r01 * r01 + pairs;
            term[pol] = r01 * h - pairs * g;
            factor[pol] = -1 * g;
        }
        for (int m = 1; m <= 3; ++m) {
            const Complex transform = sensitivity.at(c, m * path_nm);
            sum += 2 * ((term[0] + term[1]) * transform).re;
            for (int pol = 0; pol < 2; ++pol) term[pol] = term[pol] * factor[pol];
        }
        value[c] = std::clamp(sum / 2, 0.0f, 1.0f);
    }
}

} // namespace plain
