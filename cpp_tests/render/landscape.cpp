#include "landscape.hpp"

#include "noise.hpp"

#include <algorithm>

namespace render {
namespace {

/// Degrees; azimuth from -z towards +x: from the left and behind the camera.
constexpr float sunAzimuth = -128, sunElevation = 38;
constexpr float turbidity = 2.6f;

/// The disc is drawn four times as wide as the sun's 0.27 degrees, so that texels can hold it, and its
/// irradiance is the sun's.
constexpr float sunRadius = 1.07f;

V3f fromAngles(float azimuth, float elevation) {
    const float a = radians(azimuth), e = radians(elevation);
    return {std::cos(e) * std::sin(a), std::sin(e), -std::cos(e) * std::cos(a)};
}

Rgb mix(const Rgb &a, const Rgb &b, float t) { return a + (b - a) * t; }

/// Degrees above the horizon.
float elevationOf(const V3f &direction) {
    return std::asin(std::clamp(direction.y, -1.0f, 1.0f)) * (180 / pi);
}

/// A chain of hills: its skyline, in degrees, between `low` and `high`.
struct Ridge {
    float low, high;
    float frequency; ///< of the skyline's noise, per radian
    float haze;      ///< the share of the horizon's light in its own
    float shift;
};
constexpr Ridge ridges[] = {
    {1.8f, 8.2f, 2.1f, 0.66f, 11.3f},
    {0.9f, 5.0f, 3.7f, 0.40f, 47.9f},
    {0.2f, 2.4f, 6.5f, 0.16f, 83.1f},
};

} // namespace

Landscape::Landscape()
    : sky_(fromAngles(sunAzimuth, sunElevation), turbidity) {
    // The sky's share by the midpoint rule, uniform in the squared sine of the zenith angle.
    constexpr int rings = 16, sectors = 32;
    Rgb mean(0);
    for (int i = 0; i < rings; ++i) {
        const float elevation = std::acos(std::sqrt((static_cast<float>(i) + 0.5f) / rings)) * 180 / pi;
        for (int j = 0; j < sectors; ++j)
            mean += sky_.radiance(fromAngles(360 * (static_cast<float>(j) + 0.5f) / sectors, elevation));
    }
    horizontalIrradiance_ = mean * (pi / (rings * sectors)) + sky_.sunIrradiance() * sky_.toSun().y;
}

Rgb Landscape::operator()(const V3f &direction) const {
    if (direction.y < 0) return meadow(direction);
    const float angle = std::acos(std::clamp(dot(direction, sky_.toSun()), -1.0f, 1.0f)) * 180 / pi;
    const float disc = 1 - smoothstep(0.9f * sunRadius, 1.1f * sunRadius, angle);
    const Rgb sun = sky_.sunIrradiance() / (2 * pi * (1 - std::cos(radians(sunRadius))));
    return hills(direction, clouds(direction, sky_.radiance(direction)) + sun * disc);
}

/// Cumulus on a plane overhead. Their thickness is noise; the side towards the sun is bright, as light
/// from there has crossed less of it.
Rgb Landscape::clouds(const V3f &direction, const Rgb &behind) const {
    const float height = direction.y + 0.06f; // the plane bends down a little, as the earth does
    const V3f place = V3f(direction.x, 0, direction.z) * (1.5f / height) + V3f(7.3f, 0, 2.9f);
    const auto thickness = [](const V3f &p) {
        const float large = fractalNoise01(p * 0.55f + V3f(3.1f, 0.7f, 9.2f), 2).value;
        return fractalNoise01(p + V3f(0, 0.37f, 0), 6).value + 0.7f * large - 0.9f;
    };
    const float here = thickness(place);
    const float cover = smoothstep(0, 0.32f, here) * smoothstep(0.02f, 0.22f, direction.y);
    if (cover <= 0) return behind;
    const V3f side = V3f(sky_.toSun().x, 0, sky_.toSun().z).normalized();
    const float shadow = std::clamp(0.5f + 1.4f * thickness(place + side * 0.22f) - 0.6f * here, 0.0f, 1.0f);
    // A thick cloud reflects most of what it gets; its shaded parts are lit by the sky.
    const Rgb lit = horizontalIrradiance_ * (0.75f / pi), shaded = horizontalIrradiance_ * (0.30f / pi);
    return mix(behind, mix(lit, shaded, shadow), 0.94f * cover);
}

Rgb Landscape::hills(const V3f &direction, const Rgb &behind) const {
    const float elevation = elevationOf(direction);
    if (elevation > 9) return behind;
    const V3f around = V3f(direction.x, 0, direction.z).normalized();
    const Rgb haze = sky_.radiance({direction.x, 0, direction.z});
    Rgb result = behind;
    for (const Ridge &ridge : ridges) {
        const V3f place = around * ridge.frequency + V3f(0, ridge.shift, 0);
        const float skyline = lerp(ridge.low, ridge.high, fractalNoise01(place, 5).value);
        const float inside = smoothstep(-0.08f, 0.08f, skyline - elevation);
        if (inside <= 0) continue;
        // Folds of the slope, and more haze towards its foot.
        const float fold = fractalNoise01(place * 5 + V3f(0, elevation * 0.9f, 0), 4).value;
        const Rgb forest = Rgb(0.035f, 0.055f, 0.026f) * (0.6f + 0.9f * fold);
        const Rgb lit = forest * horizontalIrradiance_ * (1 / pi);
        const float foot = 0.35f * (1 - std::clamp(elevation / std::max(skyline, 0.1f), 0.0f, 1.0f));
        const float hazeShare = ridge.haze + (1 - ridge.haze) * foot;
        result = mix(result, mix(lit, haze * Rgb(0.55f, 0.66f, 0.80f), hazeShare), inside);
    }
    return result;
}

/// Grass with paler patches, on a plane one unit below, fading into haze.
Rgb Landscape::meadow(const V3f &direction) const {
    const float depth = std::max(-direction.y, 1e-3f);
    const V3f place = V3f(direction.x, 0, direction.z) / depth;
    const float distance = place.length();
    // What is finer than the texels, far away, is left out.
    const int octaves = std::clamp(static_cast<int>(6 - std::log2(1 + distance)), 1, 6);
    const float patches = fractalNoise01(place * 0.45f + V3f(5.1f, 2.2f, 8.8f), octaves).value;
    const float blades = fractalNoise01(place * 3.1f + V3f(1.7f, 6.4f, 0.3f), octaves).value;
    const Rgb grass = mix(Rgb(0.045f, 0.085f, 0.022f), Rgb(0.16f, 0.15f, 0.06f), patches);
    const Rgb lit = grass * (0.7f + 0.6f * lerp(blades, 0.5f, smoothstep(4, 25, distance))) *
                    horizontalIrradiance_ * (1 / pi);
    const Rgb haze = sky_.radiance({direction.x, 0, direction.z}) * Rgb(0.55f, 0.66f, 0.80f);
    return mix(lit, haze, 0.55f * smoothstep(4, 160, distance));
}

} // namespace render
