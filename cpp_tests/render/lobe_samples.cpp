#include "lobe_samples.hpp"

#include "sampler.hpp"

namespace render {

std::vector<V3f> lobeUniforms(int count) {
    Sampler sampler(count, 0);
    std::vector<V3f> uniforms;
    for (int i = 0; i < count; ++i) {
        sampler.start({0, 0}, i);
        const Sampler::Numbers numbers = sampler.next();
        uniforms.emplace_back(numbers[2], numbers[0], numbers[1]);
    }
    return uniforms;
}

void sampleLobe(const pellicle::Bsdf &bsdf, const V3f &wo, const std::vector<V3f> &uniforms,
                std::vector<LobeSample> &samples) {
    samples.resize(uniforms.size());
    const auto stride = static_cast<std::ptrdiff_t>(sizeof(LobeSample));
    PellicleSampleBatchArgs args{};
    args.count = uniforms.size();
    args.wo = {&wo.x, 0, sizeof(float)};
    args.u = {&uniforms.data()->x, sizeof(V3f), sizeof(float)};
    args.wi = {&samples.data()->wi.x, stride, sizeof(float)};
    args.weight = {&samples.data()->weight.x, stride, sizeof(float)};
    args.pdf = {&samples.data()->solidAngle, stride, sizeof(float)};
    bsdf.sample_batch(args);
    for (LobeSample &sample : samples)
        if (sample.solidAngle > 0) sample.solidAngle = 1 / (static_cast<float>(samples.size()) * sample.solidAngle);
}

} // namespace render
