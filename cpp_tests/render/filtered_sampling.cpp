#include "filtered_sampling.hpp"

namespace render {

FilteredSampling::FilteredSampling(const MipMap &environment, pellicle::Bsdf bsdf, int samples)
    : environment_(environment),
      bsdf_(std::move(bsdf)),
      uniforms_(lobeUniforms(samples)) {}

Rgb FilteredSampling::reflected(const Frame &frame, const V3f &toViewer) const {
    thread_local std::vector<LobeSample> samples;
    sampleLobe(bsdf_, frame.toLocal(toViewer), uniforms_, samples);
    Rgb sum(0);
    for (const LobeSample &sample : samples)
        if (sample.wi.z > 0)
            sum += sample.weight * environment_.radiance(frame.toWorld(sample.wi), overlap * sample.solidAngle);
    return sum / static_cast<float>(samples.size());
}

} // namespace render
