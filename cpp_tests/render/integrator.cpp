#include "integrator.hpp"

#include "normal_map.hpp"

#include <algorithm>
#include <vector>

namespace render {
namespace {

/// A surface point with everything that does not depend on the direction to the light.
class Shading {
public:
    Shading(const Hit &hit, const V3f &toViewer) : material_(*hit.material), point_(hit.point) {
        Frame &frame = point_.shading;
        V3f interpolated = frame.normal;
        if (material_.hasNormalMap())
            frame = frameAround(mappedNormal(point_, material_.normalAt(point_)));
        // pellicle's models without TRANSMISSION are one-sided: show them from both sides.
        if (!material_.transmits() && dot(toViewer, point_.geometricNormal) < 0) {
            point_.geometricNormal = -point_.geometricNormal;
            frame = frameAround(-frame.normal);
            interpolated = -interpolated;
        }
        if (material_.hasNormalMap() && !material_.transmits())
            frame = frameAround(
                keepReflectionAbove(frame.normal, interpolated, point_.geometricNormal, toViewer));
        // Where interpolation has turned the normal away from the viewer it is turned back until it is
        // just visible, as otherwise outlines would be black (A. Keller et al., "The Iray Light
        // Transport Simulation and Rendering System", 2017, does so too).
        const float side = dot(toViewer, point_.geometricNormal) < 0 ? -1.0f : 1.0f;
        constexpr float leastCosine = 0.01f;
        const float cosine = side * dot(toViewer, frame.normal);
        if (cosine < leastCosine)
            frame = frameAround((frame.normal + toViewer * (side * (leastCosine - cosine))).normalized());

        wo_ = frame.toLocal(toViewer);
        varying_ = material_.varyingAt(point_);
    }

    const SurfacePoint &point() const { return point_; }
    const Rgb &ambientReflectance() const { return material_.ambientReflectance(); }
    bool onlyDirac() const { return material_.onlyDirac(); }
    bool transmits() const { return material_.transmits(); }

    struct Scattering {
        Rgb value{0};
        float pdf = 0;
    };
    Scattering eval(const V3f &toLight) const {
        const V3f wi = point_.shading.toLocal(toLight);
        if (leaks(toLight, wi)) return {};
        const pellicle::Evaluation e = material_.bsdf().eval(&wo_.x, &wi.x, varying_.data());
        return {Rgb(e.value[0], e.value[1], e.value[2]), e.pdf};
    }

    struct Sample {
        V3f toLight;
        Rgb weight;
        float pdf;
        bool dirac;
    };
    /// Weight 0: the path ends.
    Sample sample(float lobe, const V2f &u) const {
        const float uniforms[3] = {lobe, u.x, u.y};
        return outward(material_.bsdf().sample(&wo_.x, uniforms, varying_.data()));
    }

    /// All that a transparent mirror does with the light: its reflection and its refraction, each times its
    /// probability, or the total reflection.
    std::vector<Sample> split() const {
        constexpr float last = 0x1.fffffep-1f;
        std::vector<Sample> ways;
        float chosen = 0;
        for (const float u : {0.0f, last}) {
            if (chosen == 1) break;
            const float uniforms[3] = {u, 0, 0};
            const PellicleSample s = material_.bsdf().sample(&wo_.x, uniforms, varying_.data());
            ways.push_back(outward(s));
            ways.back().weight *= s.lobe_probability;
            chosen += s.lobe_probability;
        }
        return ways;
    }

private:
    /// The sample in the world's frame; without weight if the true normal refuses it.
    Sample outward(const PellicleSample &s) const {
        const V3f wi(s.wi[0], s.wi[1], s.wi[2]);
        const V3f toLight = point_.shading.toWorld(wi);
        const Rgb weight = leaks(toLight, wi) ? Rgb(0) : Rgb(s.weight[0], s.weight[1], s.weight[2]);
        return {toLight, weight, s.pdf, (s.flags & PELLICLE_DELTA) != 0};
    }

    /// The interpolated normal and the true one disagree on which side the light is.
    bool leaks(const V3f &toLight, const V3f &wi) const {
        return dot(toLight, point_.geometricNormal) * wi.z <= 0;
    }

    const Material &material_;
    SurfacePoint point_;
    V3f wo_;
    Material::Varying varying_;
};

/// E. Veach and L. Guibas, "Optimally Combining Sampling Techniques for Monte Carlo Rendering",
/// SIGGRAPH 1995: the power heuristic with exponent 2. Divided through, so that it cannot overflow.
float powerHeuristic(float pdf, float otherPdf) {
    if (pdf == 0) return 0;
    const float ratio = otherPdf / pdf;
    return 1 / (1 + ratio * ratio);
}

bool isBlack(const Rgb &c) { return c.x == 0 && c.y == 0 && c.z == 0; }

/// Light from the environment, by `count` samples of it.
Rgb sampleLight(const Shading &shading, const World &world, const Environment &environment,
                Technique technique, const Sampler::Points &uniforms, int count) {
    const SurfacePoint &point = shading.point();
    Rgb sum(0);
    for (int i = 0; i < count; ++i) {
        const Environment::Sample light = environment.sample(uniforms.at2d(i));
        if (light.pdf == 0) continue;
        const Shading::Scattering scattering = shading.eval(light.direction);
        if (isBlack(scattering.value)) continue;
        if (world.occluded(leaveSurface(point.position, point.geometricNormal, light.direction))) continue;
        const float pdf = static_cast<float>(count) * light.pdf;
        const float weight = technique == Technique::combined ? powerHeuristic(pdf, scattering.pdf) : 1.0f;
        sum += scattering.value * light.radiance * (weight / pdf);
    }
    return sum;
}

/// What the camera sees, directly or in mirrors.
struct Beam {
    Ray ray;
    Rgb throughput;
    int bounce;
    int splits; ///< how many transparent mirrors may still be followed both ways
};

Rgb trace(const Beam &beam, const World &world, const Environment &environment, const PathSettings &settings,
          Sampler &sampler, FirstHit &firstHit) {
    Ray ray = beam.ray;
    Rgb sum(0), throughput = beam.throughput;
    // How the ray was chosen: by a BSDF with this density, or (no density) by the camera or a mirror;
    // and how many samples of the light it competes with.
    float bsdfPdf = 0;
    int lightSamples = settings.lightSamples;
    // Reflections behind the camera's, those in mirrors seen by it not counted.
    int reflections = 0;
    bool inMirrors = true;
    float atFirst = 1; ///< throughput behind the first surface
    const auto limited = [&](const Rgb &light, int behind) {
        const float brightest = maxComponent(light);
        return behind > 0 && brightest > settings.indirectLimit
                   ? light * (settings.indirectLimit / brightest)
                   : light;
    };

    for (int bounce = beam.bounce;; ++bounce) {
        const std::optional<Hit> hit = world.intersect(ray);
        if (!hit) {
            float weight = 1;
            if (bsdfPdf > 0 && settings.technique == Technique::light) weight = 0;
            if (bsdfPdf > 0 && settings.technique == Technique::combined)
                weight = powerHeuristic(bsdfPdf,
                                        static_cast<float>(lightSamples) * environment.pdf(ray.direction));
            return sum + limited(throughput * environment.radiance(ray.direction) * weight, reflections - 1);
        }
        const Shading shading(*hit, -ray.direction);
        const SurfacePoint &point = shading.point();
        if (bounce == 0) firstHit = {point.shading.normal, hit->distance};
        if (bounce == settings.maxBounces) return sum;
        sum += limited(throughput * world.ambient() * shading.ambientReflectance(), reflections);

        lightSamples = inMirrors ? settings.lightSamples : 1;
        if (!shading.onlyDirac()) {
            const Sampler::Points uniforms = sampler.next(lightSamples);
            if (settings.technique != Technique::bsdf)
                sum += limited(throughput * sampleLight(shading, world, environment, settings.technique,
                                                        uniforms, lightSamples),
                               reflections);
        }

        if (inMirrors && beam.splits > 0 && shading.onlyDirac() && shading.transmits()) {
            for (const Shading::Sample &way : shading.split())
                if (!isBlack(way.weight))
                    sum += trace({leaveSurface(point.position, point.geometricNormal, way.toLight),
                                  throughput * way.weight, bounce + 1, beam.splits - 1},
                                 world, environment, settings, sampler, firstHit);
            return sum;
        }
        const Sampler::Numbers numbers = sampler.next();
        const Shading::Sample next = shading.sample(numbers[2], {numbers[0], numbers[1]});
        throughput *= next.weight;
        bsdfPdf = next.dirac ? 0 : next.pdf;
        inMirrors = inMirrors && next.dirac;
        if (!inMirrors) ++reflections;
        ray = leaveSurface(point.position, point.geometricNormal, next.toLight);

        // Russian roulette (J. Arvo and D. Kirk, "Particle Transport and Image Synthesis", SIGGRAPH
        // 1990), by what is lost since the first surface, seen directly or in mirrors: what dark
        // surfaces reflect would become speckles otherwise. Below 1, as the paper's variant can reflect
        // more light than it receives, and well above 0.
        if (isBlack(throughput)) return sum;
        if (reflections <= 1) {
            atFirst = maxComponent(throughput);
            continue;
        }
        const float survival = std::clamp(maxComponent(throughput) / atFirst, 0.5f, 0.95f);
        if (numbers[3] >= survival) return sum;
        throughput *= 1 / survival;
    }
}

} // namespace

Rgb radiance(const Ray &ray, const World &world, const Environment &environment, const PathSettings &settings,
             Sampler &sampler, FirstHit &firstHit) {
    // Four surfaces: both elements of a lens, or a bubble in front of another.
    constexpr int splits = 4;
    return trace({ray, Rgb(1), 0, splits}, world, environment, settings, sampler, firstHit);
}

} // namespace render
