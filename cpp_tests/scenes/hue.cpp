#include "hue.hpp"

using namespace render;

Perceived perceived(const Rgb &linear) {
    // IEC 61966-2-1, Rec.709 primaries to XYZ; each row divided by the white's X, Y or Z.
    const double x = (0.4124 * linear.x + 0.3576 * linear.y + 0.1805 * linear.z) / 0.9505;
    const double y = 0.2126 * linear.x + 0.7152 * linear.y + 0.0722 * linear.z;
    const double z = (0.0193 * linear.x + 0.1192 * linear.y + 0.9505 * linear.z) / 1.0890;
    const auto f = [](double t) {
        return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116;
    };
    const double a = 500 * (f(x) - f(y)), b = 200 * (f(y) - f(z));
    const double hue = 180 / static_cast<double>(pi) * std::atan2(b, a);
    return {116 * f(y) - 16, std::hypot(a, b), hue < 0 ? hue + 360 : hue};
}
