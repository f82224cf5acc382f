// A clear sky and the sun, by formula.
#pragma once

#include "math.hpp"

namespace render {

/// The daylight model of A. Preetham, P. Shirley and B. Smits, "A Practical Analytic Model for
/// Daylight", SIGGRAPH 1999. Radiances are in units of 10 kcd/m^2 of luminance, which makes a sky of
/// about 1 and a white wall in the sun of about 3.
class ClearSky {
public:
    /// `turbidity`: haze; 2 is very clear, 6 hazy.
    ClearSky(const V3f &toSun, float turbidity);

    /// Of the sky without the sun, above the horizon; at and below it the horizon's.
    Rgb radiance(const V3f &direction) const;

    /// Of a surface that faces the sun, by the sun alone.
    const Rgb &sunIrradiance() const { return sunIrradiance_; }

    const V3f &toSun() const { return toSun_; }

private:
    /// R. Perez, R. Seals and J. Michalsky, "All-Weather Model for Sky Luminance Distribution", Solar
    /// Energy 50(3), 1993.
    struct Perez {
        float a, b, c, d, e;
        float operator()(float cosZenith, float cosSun) const;
    };
    float relative(const Perez &perez, float cosZenith, float cosSun) const;

    V3f toSun_;
    Perez luminance_, x_, y_;
    float zenithLuminance_, zenithX_, zenithY_;
    Rgb sunIrradiance_;
};

} // namespace render
