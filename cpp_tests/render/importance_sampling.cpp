#include "importance_sampling.hpp"

#include "sampler.hpp"

namespace render {

ImportanceSampling::ImportanceSampling(const Environment &environment, pellicle::Bsdf bsdf, int pairs)
    : environment_(environment),
      bsdf_(std::move(bsdf)),
      onlyDirac_((bsdf_.info().flags & (PELLICLE_DIFFUSE | PELLICLE_GLOSSY)) == 0),
      pairs_(pairs) {}

Rgb ImportanceSampling::reflected(const Frame &frame, const V3f &toViewer, std::uint32_t seed) const {
    const V3f wo = frame.toLocal(toViewer);
    Sampler sampler(pairs_, seed);
    Rgb sum(0);
    for (int i = 0; i < pairs_; ++i) {
        sampler.start({0, 0}, i);
        const Sampler::Numbers numbers = sampler.next();
        sum += fromBsdf(frame, wo, V3f(numbers[2], numbers[0], numbers[1]));
        if (!onlyDirac_) sum += fromLight(frame, wo, sampler.next(1).at2d(0));
    }
    return sum / static_cast<float>(pairs_);
}

Rgb ImportanceSampling::fromBsdf(const Frame &frame, const V3f &wo, const V3f &uniforms) const {
    const PellicleSample sample = bsdf_.sample(&wo.x, &uniforms.x);
    const Rgb weight(sample.weight[0], sample.weight[1], sample.weight[2]);
    if (sample.wi[2] <= 0) return Rgb(0);
    const V3f direction = frame.toWorld(V3f(sample.wi[0], sample.wi[1], sample.wi[2]));
    const Rgb light = weight * environment_.radiance(direction);
    if (onlyDirac_) return light;
    return light * (sample.pdf / (sample.pdf + environment_.pdf(direction)));
}

Rgb ImportanceSampling::fromLight(const Frame &frame, const V3f &wo, const V2f &uniforms) const {
    const LightSample light = environment_.sample(uniforms);
    const V3f wi = frame.toLocal(light.direction);
    if (light.pdf <= 0 || wi.z <= 0) return Rgb(0);
    const pellicle::Evaluation bsdf = bsdf_.eval(&wo.x, &wi.x);
    return Rgb(bsdf.value[0], bsdf.value[1], bsdf.value[2]) * light.radiance / (light.pdf + bsdf.pdf);
}

} // namespace render
