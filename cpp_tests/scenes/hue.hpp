// Colours as people name them.
#pragma once

#include "math.hpp"

/// CIELAB, white D65 (CIE 15:2004, section 8.2.1), as lightness, chroma and hue.
struct Perceived {
    double lightness, chroma;
    double hue; ///< degrees, 0 to 360
};
Perceived perceived(const render::Rgb &linear);

/// Hues from `from` up to `to` degrees; `to` may exceed 360.
struct HueRange {
    const char *name;
    double from, to;

    bool contains(double hue) const { return (hue >= from && hue <= to) || hue + 360 <= to; }
};

/// What names mean, wide enough to overlap as names do. For comparison, sRGB's red is at 40 degrees,
/// yellow at 103, green at 136, cyan at 196, blue at 306 and magenta at 328. Brown and tan are dark and
/// pale orange.
namespace hues {
constexpr HueRange pink{"pink", 330, 405}, orange{"orange", 40, 85}, gold{"gold", 70, 108},
    yellow{"yellow", 80, 110}, yellowGreen{"yellow-green", 100, 145}, green{"green", 130, 185},
    blueGreen{"blue-green", 180, 240}, blue{"blue", 225, 300}, blueViolet{"blue-violet", 280, 310},
    violet{"violet", 290, 330}, redViolet{"red-violet", 315, 375};
} // namespace hues
