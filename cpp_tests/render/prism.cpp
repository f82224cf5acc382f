#include "prism.hpp"

#include "parallel.hpp"

#include <pellicle.hpp>

#include <OpenImageIO/imagebufalgo.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <numeric>
#include <optional>
#include <vector>

namespace render {
namespace {

constexpr float firstWavelength = 390, lastWavelength = 730;
constexpr int wavelengths = 4;
constexpr int mostBounces = 12;
constexpr float pictureWidth = 16;

/// Corners of the prism, and the beam: where its middle meets the left face, its direction and its width.
constexpr float side = 4.6f;
const V2f apex(0, 2.3f);
const V2f corners[3] = {apex, apex + V2f(-0.5f * side, -0.8660254f * side), apex + V2f(0.5f * side, -0.8660254f * side)};
constexpr float beamWidth = 0.07f;
/// Degrees of incidence. At 63.2 yellow passes with the least deviation.
constexpr float incidence = 61;

V2f rotated(V2f v, float degrees) {
    const float c = std::cos(radians(degrees)), s = std::sin(radians(degrees));
    return {c * v.x - s * v.y, s * v.x + c * v.y};
}

/// Of the face that the beam meets.
V2f leftNormal() { return rotated(V2f(-1, 0), -30); }

float crossed(V2f a, V2f b) { return a.x * b.y - a.y * b.x; }

struct Hit {
    float distance;
    V2f normal; ///< out of the glass
};

/// The nearest face beyond `least`.
std::optional<Hit> intersect(V2f origin, V2f direction, float least) {
    std::optional<Hit> nearest;
    for (int i = 0; i < 3; ++i) {
        const V2f from = corners[i], edge = corners[(i + 1) % 3] - from;
        const float parallel = crossed(direction, edge);
        if (parallel == 0) continue;
        const float distance = crossed(from - origin, edge) / parallel;
        const float along = crossed(from - origin, direction) / parallel;
        if (distance <= least || along < 0 || along > 1 || (nearest && nearest->distance <= distance)) continue;
        nearest = Hit{distance, V2f(edge.y, -edge.x).normalized()};
    }
    return nearest;
}

/// The glass itself, seen faintly, with brighter edges.
Rgb glassAt(V2f at, float pixelsPerUnit) {
    float nearest = 1e9f;
    bool inside = true;
    for (int i = 0; i < 3; ++i) {
        const V2f from = corners[i], edge = corners[(i + 1) % 3] - from;
        const float along = std::clamp((at - from).dot(edge) / edge.dot(edge), 0.0f, 1.0f);
        nearest = std::min(nearest, (at - from - along * edge).length());
        inside = inside && crossed(edge, at - from) > 0;
    }
    const float line = 1 - smoothstep(0.8f, 2.0f, nearest * pixelsPerUnit);
    return Rgb(0.045f, 0.05f, 0.06f) * (inside ? 0.35f + 0.8f * std::exp(-3 * nearest) : 0.0f) +
           Rgb(0.30f, 0.33f, 0.36f) * line;
}

/// A smooth surface of bare glass, from both sides.
const pellicle::Bsdf &glass() {
    static const pellicle::Bsdf bsdf =
        pellicle::BsdfBuilder("film").film(pellicle::FilmBuilder("SF11").transmittance().create()).create();
    return bsdf;
}

/// The numbers of ray i: the golden ratio's multiples and Kronecker sequences of other irrationals.
float number(int ray, int dimension) {
    static const double steps[] = {0.6180339887498949, 0.4142135623730951, 0.7320508075688772, 0.2360679774997898};
    const double x = (ray + 0.5) * steps[dimension % 4] + 0.3819660112501051 * dimension * dimension;
    return std::min(static_cast<float>(x - std::floor(x)), 0.99999994f);
}

using Wavelengths = std::array<float, wavelengths>;

/// The hero first, the others in equal steps (A. Wilkie et al., "Hero Wavelength Spectral Sampling", 2014, eq. 6).
Wavelengths wavelengthsOf(float u) {
    Wavelengths nm{};
    for (std::size_t j = 0; j < wavelengths; ++j) {
        const float part = u + static_cast<float>(j) / wavelengths;
        nm[j] = lerp(firstWavelength, lastWavelength, part - std::floor(part));
    }
    return nm;
}

} // namespace

void tracePrism(int firstRay, int rays, int allRays, const std::function<void(const Segment &)> &seen) {
    PellicleCall call{};
    call.size = sizeof call;
    call.transport = PELLICLE_TRANSPORT_IMPORTANCE; // from the light
    const V2f direction = -rotated(leftNormal(), incidence), across(-direction.y, direction.x);
    const V2f target = corners[1] + 0.58f * (corners[0] - corners[1]);
    for (int ray = firstRay; ray < firstRay + rays; ++ray) {
        Wavelengths nm = wavelengthsOf(number(ray, 0));
        int count = wavelengths;
        // Along the path: what arrives, and the density as if the wavelength were the hero (Wilkie et al. 2014, eq. 11).
        std::array<float, wavelengths> values, densities;
        values.fill(1);
        densities.fill(1);
        V2f origin = target - 12.0f * direction + beamWidth * (number(ray, 1) - 0.5f) * across, along = direction;
        for (int bounce = 0; bounce < mostBounces; ++bounce) {
            const std::optional<Hit> hit = intersect(origin, along, 1e-4f);
            const V2f end = origin + (hit ? hit->distance : 20.0f) * along;
            const float sum = std::accumulate(densities.begin(), densities.end(), 0.0f);
            for (std::size_t j = 0; j < static_cast<std::size_t>(count); ++j)
                seen({origin, end, nm[j], values[j] / (sum * static_cast<float>(allRays))});
            if (!hit) break;
            const V2f tangent(-hit->normal.y, hit->normal.x);
            const std::array<float, 3> wo{-along.dot(tangent), 0, -along.dot(hit->normal)};
            const std::array<float, 3> u{number(ray, 2 + bounce), 0.5f, 0.5f};
            std::array<float, wavelengths> weight{}, pdf{};
            const PellicleSpectralSample sample =
                glass().sample_spectral(wo, u, nm.data(), static_cast<std::size_t>(count), 0, weight.data(), pdf.data(),
                                        nullptr, &call);
            if (sample.lobe_probability == 0) break;
            const float mean = std::accumulate(pdf.begin(), pdf.end(), 0.0f) / static_cast<float>(count);
            for (std::size_t j = 0; j < wavelengths; ++j) {
                values[j] *= weight[j] * mean;
                densities[j] *= pdf[j];
            }
            if (sample.hero_only) count = 1;
            origin = end;
            along = sample.wi[0] * tangent + sample.wi[2] * hit->normal;
        }
    }
}

OIIO::ImageBuf prismPicture(const PrismSettings &settings) {
    const int width = settings.width, height = settings.height;
    const float scale = static_cast<float>(width) / pictureWidth;
    std::vector<Rgb> sums(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), Rgb(0));
    const auto pixelOf = [&](V2f p) {
        return V2f(p.x * scale + 0.5f * static_cast<float>(width), 0.5f * static_cast<float>(height) - p.y * scale);
    };
    std::mutex mutex;
    constexpr int parts = 16;
    const int rays = std::max(1, settings.rays / parts);
    parallelFor(parts, settings.threads, [&](int part) {
        std::vector<Rgb> own(sums.size(), Rgb(0));
        tracePrism(part * rays, rays, parts * rays, [&](const Segment &segment) {
            const V2f from = pixelOf(segment.from), to = pixelOf(segment.to);
            const float length = (to - from).length();
            // Steps of half a pixel, each spread over the four nearest pixels.
            const int steps = static_cast<int>(std::ceil(2 * length));
            const Rgb light = colorOf(segment.wavelength) * (segment.power * length / static_cast<float>(steps));
            for (int i = 0; i < steps; ++i) {
                const V2f p = from + (to - from) * ((static_cast<float>(i) + 0.5f) / static_cast<float>(steps)) - V2f(0.5f);
                const float left = std::floor(p.x), top = std::floor(p.y);
                const float weightX[2] = {1 - (p.x - left), p.x - left}, weightY[2] = {1 - (p.y - top), p.y - top};
                for (int dy = 0; dy < 2; ++dy)
                    for (int dx = 0; dx < 2; ++dx) {
                        const int x = static_cast<int>(left) + dx, y = static_cast<int>(top) + dy;
                        if (x < 0 || y < 0 || x >= width || y >= height) continue;
                        own[static_cast<std::size_t>(y * width + x)] += light * (weightX[dx] * weightY[dy]);
                    }
            }
        });
        const std::lock_guard lock(mutex);
        for (std::size_t i = 0; i < own.size(); ++i) sums[i] += own[i];
    });
    OIIO::ImageBuf image(OIIO::ImageSpec(width, height, 3, OIIO::TypeFloat));
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const V2f at((static_cast<float>(x) + 0.5f - 0.5f * static_cast<float>(width)) / scale,
                         (0.5f * static_cast<float>(height) - static_cast<float>(y) - 0.5f) / scale);
            // The beam itself is about 1.
            const Rgb light = sums[static_cast<std::size_t>(y * width + x)] * (beamWidth * scale) + glassAt(at, scale);
            const float pixel[3] = {std::max(light.x, 0.0f), std::max(light.y, 0.0f), std::max(light.z, 0.0f)};
            image.setpixel(x, y, pixel);
        }
    return image;
}

namespace {

/// The functions of eq. 4.
std::array<float, 3> matchingFunctions(float wavelength) {
    const auto lobe = [&](float scale, float mean, float below, float above) {
        const float t = (wavelength - mean) * (wavelength < mean ? below : above);
        return scale * std::exp(-0.5f * t * t);
    };
    return {lobe(0.362f, 442.0f, 0.0624f, 0.0374f) + lobe(1.056f, 599.8f, 0.0264f, 0.0323f) +
                lobe(-0.065f, 501.1f, 0.0490f, 0.0382f),
            lobe(0.821f, 568.8f, 0.0213f, 0.0247f) + lobe(0.286f, 530.9f, 0.0613f, 0.0322f),
            lobe(1.217f, 437.0f, 0.0845f, 0.0278f) + lobe(0.681f, 459.0f, 0.0385f, 0.0725f)};
}

/// XYZ in Rec.709 (IEC 61966-2-1).
Rgb rec709(const std::array<float, 3> &xyz) {
    const auto [x, y, z] = xyz;
    return {3.2406f * x - 1.5372f * y - 0.4986f * z, -0.9689f * x + 1.8758f * y + 0.0415f * z,
            0.0557f * x - 0.2040f * y + 1.0570f * z};
}

} // namespace

Rgb colorOf(float wavelength) {
    static const Rgb mean = [] {
        Rgb sum(0);
        const int steps = static_cast<int>(lastWavelength - firstWavelength);
        for (int i = 0; i < steps; ++i) sum += rec709(matchingFunctions(firstWavelength + static_cast<float>(i) + 0.5f));
        return sum / static_cast<float>(steps);
    }();
    const Rgb color = rec709(matchingFunctions(wavelength));
    return {color.x / mean.x, color.y / mean.y, color.z / mean.z};
}

} // namespace render
