// The truth that films are compared with: Airy's sum for one layer, written straight from the textbook in
// double precision, and its colour from the 1 nm matching functions. It shares nothing with the library.
#pragma once

#include <array>
#include <complex>
#include <functional>

namespace airy {

using Complex = std::complex<double>;
using Rgb = std::array<double, 3>;

// A layer between two half-spaces, with indices that are the same at every wavelength.
struct Stack {
    double ambient;
    Complex film, base;
};

// Amplitudes of one polarisation at one angle: |a|^2 is a reflectance.
struct Amplitudes {
    Complex r01, r12;
    // 2 n1 cos1: the optical path of a round trip, over the thickness.
    Complex path;
};
enum class Polarisation { s, p };
Amplitudes amplitudes(const Stack &stack, double cos_theta, Polarisation polarisation);

// Of unpolarised light at one wavelength: all beams added up.
double reflectance(const Stack &stack, double cos_theta, double thickness_nm, double lambda_nm);

// The same for any way of adding up the beams: the mean over both polarisations of `power`, which gets the
// amplitudes and the round trip's factor exp(i 2 pi path thickness / lambda).
using Power = std::function<double(const Amplitudes &, Complex round_trip)>;
double reflectance(const Stack &stack, double cos_theta, double thickness_nm, double lambda_nm, const Power &power);

// Power of all beams, of the first two, and of Fourier's series in the fringe's phase up to a harmonic (for
// media that do not absorb).
double all_beams(const Amplitudes &amplitudes, Complex round_trip);
double two_beams(const Amplitudes &amplitudes, Complex round_trip);
Power harmonics(int order);

// Linear Rec.709 in which a perfect mirror is (1, 1, 1) under equal-energy white, of a spectrum over
// 380-780 nm; not clipped. The step is halved until the colour stays the same to 1e-6.
Rgb color(const std::function<double(double lambda_nm)> &spectrum);

// By `count` equidistant wavelengths instead, each for its part of the spectrum.
Rgb fixed_wavelengths(const std::function<double(double lambda_nm)> &spectrum, int count);

// The colour of a stack.
Rgb color(const Stack &stack, double cos_theta, double thickness_nm);

// Without absorption the colour that thick films go to, grey: beams' powers added up.
double incoherent(const Stack &stack, double cos_theta);

// Each channel held in [0, 1].
Rgb clipped(Rgb rgb);

// The greatest difference of a channel.
double distance(const Rgb &a, const Rgb &b);

} // namespace airy
