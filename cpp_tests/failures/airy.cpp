#include "airy.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace airy {

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr int first_nm = 380, last_nm = 780;

// The matching functions of CIE 1931, 2 degrees, at every nanometre from `first_nm` on.
std::vector<Rgb> read_observer() {
    std::ifstream file(AIRY_OBSERVER_FILE);
    std::vector<Rgb> rows;
    for (std::string line; std::getline(file, line);) {
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream numbers(line);
        double lambda_nm;
        Rgb xyz;
        if (numbers >> lambda_nm >> xyz[0] >> xyz[1] >> xyz[2] && lambda_nm >= first_nm && lambda_nm <= last_nm)
            rows.push_back(xyz);
    }
    if (rows.size() != last_nm - first_nm + 1) throw std::runtime_error("cannot read " AIRY_OBSERVER_FILE);
    return rows;
}

Rgb cross(const Rgb &a, const Rgb &b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// What red, green and blue see at every nanometre, in any unit: the rows of the inverse of the matrix of the
// primaries of ITU-R BT.709. Their scale falls out where white is divided by.
const std::vector<Rgb> &observer() {
    static const std::vector<Rgb> rgb = [] {
        const Rgb red = {0.64, 0.33, 0.03}, green = {0.30, 0.60, 0.10}, blue = {0.15, 0.06, 0.79};
        const Rgb rows[3] = {cross(green, blue), cross(blue, red), cross(red, green)};
        std::vector<Rgb> all = read_observer();
        for (Rgb &entry : all) {
            const Rgb xyz = entry;
            for (int c = 0; c < 3; ++c) entry[c] = rows[c][0] * xyz[0] + rows[c][1] * xyz[1] + rows[c][2] * xyz[2];
        }
        return all;
    }();
    return rgb;
}

// By the trapezoidal rule; `steps` is the number of its steps per nanometre.
Rgb integral(const std::function<double(double)> &spectrum, int steps) {
    const std::vector<Rgb> &weights = observer();
    Rgb sum{}, white{};
    for (int i = 0; i <= (last_nm - first_nm) * steps; ++i) {
        const std::size_t row = std::min<std::size_t>(i / steps, weights.size() - 2);
        const double fraction = double(i) / steps - double(row);
        const double end = i == 0 || i == (last_nm - first_nm) * steps ? 0.5 : 1.0;
        const double value = spectrum(first_nm + double(i) / steps);
        for (int c = 0; c < 3; ++c) {
            const double weight = end * (weights[row][c] * (1 - fraction) + weights[row + 1][c] * fraction);
            sum[c] += weight * value;
            white[c] += weight;
        }
    }
    for (int c = 0; c < 3; ++c) sum[c] /= white[c];
    return sum;
}

// A ray's cosine inside a medium, of the wave that dies away inwards: by Snell's law, written so that equal indices
// give the same cosine.
Complex inside(double ambient, double cos_theta, Complex index) {
    const Complex excess = (index - ambient) * (index + ambient);
    const Complex normal = std::sqrt(excess + ambient * ambient * cos_theta * cos_theta);
    return (normal.imag() < 0 ? -normal : normal) / index;
}

Complex fresnel(Complex eta_a, Complex cos_a, Complex eta_b, Complex cos_b, Polarisation polarisation) {
    if (polarisation == Polarisation::p) std::swap(cos_a, cos_b);
    const Complex sum = eta_a * cos_a + eta_b * cos_b;
    // Along the surface two equal media give 0 / 0.
    return sum == 0.0 ? 0.0 : (eta_a * cos_a - eta_b * cos_b) / sum;
}

} // namespace

Amplitudes amplitudes(const Stack &stack, double cos_theta, Polarisation polarisation) {
    const Complex cos1 = inside(stack.ambient, cos_theta, stack.film);
    const Complex cos2 = inside(stack.ambient, cos_theta, stack.base);
    return {fresnel(stack.ambient, cos_theta, stack.film, cos1, polarisation),
            fresnel(stack.film, cos1, stack.base, cos2, polarisation), 2.0 * stack.film * cos1};
}

double reflectance(const Stack &stack, double cos_theta, double thickness_nm, double lambda_nm, const Power &power) {
    double sum = 0;
    for (const Polarisation polarisation : {Polarisation::s, Polarisation::p}) {
        const Amplitudes found = amplitudes(stack, cos_theta, polarisation);
        sum += power(found, std::exp(Complex(0, 2 * pi) * found.path * (thickness_nm / lambda_nm)));
    }
    return 0.5 * sum;
}

double reflectance(const Stack &stack, double cos_theta, double thickness_nm, double lambda_nm) {
    return reflectance(stack, cos_theta, thickness_nm, lambda_nm, all_beams);
}

// Born and Wolf, "Principles of Optics", 7.6.1; with r01 = -1 and r12 = 1 everything is reflected.
double all_beams(const Amplitudes &a, Complex round_trip) {
    const Complex below = a.r12 * round_trip, divisor = 1.0 + a.r01 * below;
    return divisor == 0.0 ? 1.0 : std::norm((a.r01 + below) / divisor);
}

double two_beams(const Amplitudes &a, Complex round_trip) {
    return std::norm(a.r01 + (1.0 - a.r01 * a.r01) * a.r12 * round_trip);
}

// R = 1 - (1 - |r01|^2) (1 - |r12|^2) / (1 - |g|^2) (1 + 2 sum over m of Re (-g)^m), g = r01 r12 round_trip:
// Poisson's kernel in Fourier's series.
Power harmonics(int order) {
    return [order](const Amplitudes &a, Complex round_trip) {
        const Complex g = a.r01 * a.r12 * round_trip;
        Complex term = 1.0;
        double kernel = 1;
        for (int m = 1; m <= order; ++m) {
            term *= -g;
            kernel += 2 * term.real();
        }
        return 1 - (1 - std::norm(a.r01)) * (1 - std::norm(a.r12)) / (1 - std::norm(g)) * kernel;
    };
}

Rgb color(const std::function<double(double)> &spectrum) {
    Rgb last = integral(spectrum, 1), before = last;
    for (int steps = 2; steps <= 1 << 14; steps *= 2) {
        const Rgb next = integral(spectrum, steps);
        if (distance(next, last) < 1e-6 && distance(last, before) < 1e-5) return next;
        before = last;
        last = next;
    }
    throw std::runtime_error("no convergence");
}

Rgb fixed_wavelengths(const std::function<double(double)> &spectrum, int count) {
    const double width_nm = double(last_nm - first_nm) / count;
    return integral([&](double lambda_nm) {
        const double part = std::min(std::floor((lambda_nm - first_nm) / width_nm), count - 1.0);
        return spectrum(first_nm + (part + 0.5) * width_nm);
    }, 4);
}

Rgb color(const Stack &stack, double cos_theta, double thickness_nm) {
    const Amplitudes s = amplitudes(stack, cos_theta, Polarisation::s);
    const Amplitudes p = amplitudes(stack, cos_theta, Polarisation::p);
    return color([&](double lambda_nm) {
        const Complex turn = Complex(0, 2 * pi * thickness_nm / lambda_nm);
        return 0.5 * (all_beams(s, std::exp(turn * s.path)) + all_beams(p, std::exp(turn * p.path)));
    });
}

double incoherent(const Stack &stack, double cos_theta) {
    double sum = 0;
    for (const Polarisation polarisation : {Polarisation::s, Polarisation::p}) {
        const Amplitudes a = amplitudes(stack, cos_theta, polarisation);
        const double top = std::norm(a.r01), bottom = std::norm(a.r12);
        sum += top + (1 - top) * (1 - top) * bottom / (1 - top * bottom);
    }
    return 0.5 * sum;
}

Rgb clipped(Rgb rgb) {
    for (double &channel : rgb) channel = std::clamp(channel, 0.0, 1.0);
    return rgb;
}

double distance(const Rgb &a, const Rgb &b) {
    double greatest = 0;
    for (int c = 0; c < 3; ++c) greatest = std::max(greatest, std::fabs(a[c] - b[c]));
    return greatest;
}

} // namespace airy
