// Path tracing.
#pragma once

#include "environment.hpp"
#include "sampler.hpp"
#include "world.hpp"

#include <limits>

namespace render {

/// How direct light is found. All agree in the mean; the tests compare them.
enum class Technique {
    combined, ///< light and BSDF sampling joined by multiple importance sampling
    light,    ///< light sampling alone (Dirac lobes, which it cannot find, excepted)
    bsdf,     ///< BSDF sampling alone
};

struct PathSettings {
    Technique technique = Technique::combined;
    int lightSamples = 4; ///< at the first surface, seen directly or in mirrors; one at later ones
    int maxBounces = 5;
    /// Greatest radiance that one path adds by light reflected more than once, mirrors between the
    /// camera and the first other surface not counted. A limit darkens caustics, which path tracing
    /// finds only by chance, and removes their fireflies.
    float indirectLimit = std::numeric_limits<float>::infinity();
};

/// What the first surface along a ray looks like, apart from its light; 0 where there is none.
struct FirstHit {
    V3f normal{0};
    float distance = 0;
};

/// An estimate of the radiance that arrives along a ray.
Rgb radiance(const Ray &ray, const World &world, const Environment &environment, const PathSettings &settings,
             Sampler &sampler, FirstHit &firstHit);

} // namespace render
