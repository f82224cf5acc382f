// A small path tracer: 25 spheres, metallic from bottom to top and rough from left to right, in a studio.
// Usage: spheres [picture [samples]], by default spheres.png with 64 samples a pixel.
//
// One BSDF serves all spheres: roughness and metallic are declared as varying and come with every call.
// Builds alone against an installed pellicle, see CMakeLists.txt beside it.

#include <Imath/ImathColor.h>
#include <Imath/ImathVec.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/parallel.h>
#include <pellicle.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <random>
#include <stdexcept>
#include <string>

using Imath::C3f;
using Imath::V3f;

constexpr int size = 640, longestPath = 8, perSide = 5;
constexpr float spacing = 2.3f, eyeDistance = 26, halfView = 6.1f;

// Uniform in [0, 1), with the 24 bits of precision that a float has.
float uniform(std::mt19937 &random) { return static_cast<float>(random() >> 8) * 0x1p-24f; }

// A rectangle of light, infinitely far away; width and height are tangents of half its angles.
float softBox(const V3f &direction, const V3f &towards, float width, float height) {
    const V3f forward = towards.normalized(), right = V3f(0, 1, 0).cross(forward).normalized();
    const float depth = direction.dot(forward);
    if (depth <= 0) return 0;
    const auto inside = [](float x) { return std::clamp(5 * (1 - std::fabs(x)), 0.0f, 1.0f); };
    return inside(direction.dot(right) / depth / width) *
           inside(direction.dot(forward.cross(right)) / depth / height);
}

// The studio's radiance: y is up, the camera looks along -z.
C3f environment(const V3f &direction) {
    const float height = (direction.y + 1) / 2, front = (direction.z + 1) / 2; // the backdrop is dark
    return C3f(0.02f, 0.022f, 0.028f) + C3f(0.46f, 0.48f, 0.52f) * ((0.25f + 0.75f * height) * front) +
           C3f(3.5f, 3.4f, 3.2f) * softBox(direction, {-1.0f, 0.7f, 0.9f}, 0.5f, 0.75f) +  // key
           C3f(0.9f, 1.0f, 1.2f) * softBox(direction, {1.0f, 0.1f, 0.4f}, 0.3f, 1.2f) +    // fill
           C3f(2.2f, 2.2f, 2.2f) * softBox(direction, {0.4f, 1.0f, -0.3f}, 1.1f, 0.5f);    // from above
}

// Follows a path until it leaves the spheres. Directions are chosen by the BSDF alone, the first with u.
C3f radiance(const pellicle::Bsdf &bsdf, V3f origin, V3f direction, std::array<float, 3> u,
             std::mt19937 &random) {
    C3f throughput(1);
    for (int bounce = 0; bounce < longestPath; ++bounce) {
        float nearest = INFINITY;
        V3f centre;
        std::array<float, 2> varying{}; // roughness and metallic, in declared order
        for (int i = 0; i < perSide * perSide; ++i) {
            const int column = i % perSide, row = i / perSide;
            const V3f candidate = V3f(float(column - perSide / 2), float(row - perSide / 2), 0) * spacing;
            const V3f toCentre = candidate - origin;
            const float along = toCentre.dot(direction);
            const float discriminant = 1 - (toCentre - direction * along).length2(); // radius 1
            if (discriminant < 0) continue;
            const float distance = along - std::sqrt(discriminant);
            if (distance < 1e-3f || distance > nearest) continue;
            nearest = distance;
            centre = candidate;
            varying = {float(column) / (perSide - 1), float(row) / (perSide - 1)};
        }
        if (nearest == INFINITY) return throughput * environment(direction);

        // The shading frame: +Z is the normal. The material is isotropic, any tangent will do.
        origin += direction * nearest;
        const V3f normal = (origin - centre).normalized();
        const V3f tangent = normal.cross(std::fabs(normal.x) < 0.5f ? V3f(1, 0, 0) : V3f(0, 1, 0)).normalized();
        const V3f bitangent = normal.cross(tangent);
        const std::array<float, 3> wo{-direction.dot(tangent), -direction.dot(bitangent), -direction.dot(normal)};
        const PellicleSample sample = bsdf.sample(wo, u, varying.data());
        throughput *= C3f(sample.weight[0], sample.weight[1], sample.weight[2]);
        if (throughput == C3f(0)) break; // also when there was no valid sample
        direction = (tangent * sample.wi[0] + bitangent * sample.wi[1] + normal * sample.wi[2]).normalized();
        u = {uniform(random), uniform(random), uniform(random)};
    }
    return C3f(0);
}

C3f pixel(const pellicle::Bsdf &bsdf, int x, int y, int samples, std::mt19937 &random) {
    // The sequence R3, shifted: 1 / phi, 1 / phi^2 and 1 / phi^3, where phi^4 = phi + 1 (M. Roberts, "The
    // Unreasonable Effectiveness of Quasirandom Sequences", 2018). Less noise than independent numbers.
    constexpr std::array<float, 3> steps{0.8191725f, 0.6710436f, 0.5497005f};
    std::array<float, 3> u{uniform(random), uniform(random), uniform(random)};
    C3f sum(0);
    for (int i = 0; i < samples; ++i) {
        const float right = 2 * (float(x) + uniform(random)) / size - 1;
        const float up = 1 - 2 * (float(y) + uniform(random)) / size;
        const V3f direction = V3f(right * halfView, up * halfView, -eyeDistance).normalized();
        for (unsigned k = 0; k < 3; ++k) u[k] = std::fmod(u[k] + steps[k], 1.0f);
        sum += radiance(bsdf, {0, 0, eyeDistance}, direction, u, random);
    }
    const C3f mean = sum / float(samples);
    // E. Reinhard et al., "Photographic Tone Reproduction for Digital Images", 2002, eq. 4.
    constexpr float white = 4;
    const float luminance = 0.2126f * mean.x + 0.7152f * mean.y + 0.0722f * mean.z; // Rec.709
    return mean * ((1 + luminance / (white * white)) / (1 + luminance));
}

int main(int argc, char **argv) try {
    const std::string file = argc > 1 ? argv[1] : "spheres.png";
    const int samples = argc > 2 ? std::max(1, std::stoi(argv[2])) : 64;
    const pellicle::Bsdf bsdf = pellicle::BsdfBuilder("metallic_roughness")
                                    .set("base_color", {0.72f, 0.2f, 0.07f})
                                    .vary("roughness", 0, 1)
                                    .vary("metallic", 0, 1)
                                    .create();
    OIIO::ImageBuf image(OIIO::ImageSpec(size, size, 3, OIIO::TypeFloat));
    OIIO::parallel_for(0, size, [&](int y) { // threads share the BSDF
        std::mt19937 random(static_cast<unsigned>(y)); // the same picture with any number of threads
        for (int x = 0; x < size; ++x) image.setpixel(x, y, pixel(bsdf, x, y, samples, random).getValue());
    });
    if (OIIO::ImageBufAlgo::colorconvert(image, image, "linear", "sRGB") && image.write(file, OIIO::TypeUInt8))
        return 0;
    std::cerr << "cannot write " << file << ": " << (image.has_error() ? image.geterror() : OIIO::geterror()) << '\n';
    return 1;
} catch (const pellicle::Error &error) {
    std::cerr << pellicle_status_string(error.status()) << ": " << error.what() << '\n';
    return 1;
} catch (const std::logic_error &) {
    std::cerr << "the number of samples is no number that fits: " << argv[2] << '\n';
    return 1;
}
