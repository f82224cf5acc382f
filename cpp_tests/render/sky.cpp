#include "sky.hpp"

#include <algorithm>

namespace render {
namespace {

/// The model's luminances are in kcd/m^2.
constexpr float unit = 10;

/// CIE xyY with white at D65 to linear Rec.709 (IEC 61966-2-1).
Rgb fromXyy(float x, float y, float luminance) {
    const float X = x / y * luminance, Z = (1 - x - y) / y * luminance;
    return {3.2406f * X - 1.5372f * luminance - 0.4986f * Z, -0.9689f * X + 1.8758f * luminance + 0.0415f * Z,
            0.0557f * X - 0.2040f * luminance + 1.0570f * Z};
}

/// What the air lets pass of the sun's light at a wavelength in micrometres: Rayleigh scattering and
/// aerosols (the paper's appendix A.1; ozone, gas and vapour are left out).
float transmittance(float wavelength, float opticalMass, float turbidity) {
    const float aerosol = 0.04608f * turbidity - 0.04586f;
    return std::exp(-opticalMass *
                    (0.008735f * std::pow(wavelength, -4.08f) + aerosol * std::pow(wavelength, -1.3f)));
}

} // namespace

// The coefficients and the colour of the zenith are those of the paper's appendix A.2.
ClearSky::ClearSky(const V3f &toSun, float turbidity)
    : toSun_(toSun.normalized()) {
    const float t = turbidity, cosine = toSun_.y, theta = std::acos(cosine);
    luminance_ = {0.1787f * t - 1.4630f, -0.3554f * t + 0.4275f, -0.0227f * t + 5.3251f,
                  0.1206f * t - 2.5771f, -0.0670f * t + 0.3703f};
    x_ = {-0.0193f * t - 0.2592f, -0.0665f * t + 0.0008f, -0.0004f * t + 0.2125f, -0.0641f * t - 0.8989f,
          -0.0033f * t + 0.0452f};
    y_ = {-0.0167f * t - 0.2608f, -0.0950f * t + 0.0092f, -0.0079f * t + 0.2102f, -0.0441f * t - 1.6537f,
          -0.0109f * t + 0.0529f};

    const float chi = (4.0f / 9 - t / 120) * (pi - 2 * theta);
    zenithLuminance_ = (4.0453f * t - 4.9710f) * std::tan(chi) - 0.2155f * t + 2.4192f;
    const auto cubic = [&](float a, float b, float c, float d) {
        return ((a * theta + b) * theta + c) * theta + d;
    };
    zenithX_ = t * t * cubic(0.00166f, -0.00375f, 0.00209f, 0) +
               t * cubic(-0.02903f, 0.06377f, -0.03202f, 0.00394f) +
               cubic(0.11693f, -0.21196f, 0.06052f, 0.25886f);
    zenithY_ = t * t * cubic(0.00275f, -0.00610f, 0.00317f, 0) +
               t * cubic(-0.04214f, 0.08970f, -0.04153f, 0.00516f) +
               cubic(0.15346f, -0.26756f, 0.06670f, 0.26688f);

    // The solar illuminance constant of the IES Lighting Handbook, klx; its colour is taken to be white.
    // Optical mass by F. Kasten, as the paper quotes it.
    constexpr float outside = 127.5f;
    const float mass = 1 / (cosine + 0.15f * std::pow(93.885f - theta * 180 / pi, -1.253f));
    sunIrradiance_ =
        Rgb(transmittance(0.61f, mass, t), transmittance(0.55f, mass, t), transmittance(0.465f, mass, t)) *
        (outside / unit);
}

Rgb ClearSky::radiance(const V3f &direction) const {
    const float cosZenith = std::max(direction.y, 0.01f), cosSun = dot(direction, toSun_);
    return fromXyy(zenithX_ * relative(x_, cosZenith, cosSun), zenithY_ * relative(y_, cosZenith, cosSun),
                   zenithLuminance_ * relative(luminance_, cosZenith, cosSun) / unit);
}

float ClearSky::Perez::operator()(float cosZenith, float cosSun) const {
    const float gamma = std::acos(std::clamp(cosSun, -1.0f, 1.0f));
    return (1 + a * std::exp(b / cosZenith)) * (1 + c * std::exp(d * gamma) + e * cosSun * cosSun);
}

/// To the zenith: the paper's equation 3.
float ClearSky::relative(const Perez &perez, float cosZenith, float cosSun) const {
    return perez(cosZenith, cosSun) / perez(1, toSun_.y);
}

} // namespace render
