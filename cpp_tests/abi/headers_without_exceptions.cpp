// What programs built without exceptions use of pellicle.hpp: handles, builders and statuses.
#include <pellicle.hpp>

#if !defined(__cpp_exceptions) && PELLICLE_HPP_THROWS
#error "exceptions are off, but the throwing half of pellicle.hpp is there"
#endif

float value_without_exceptions(const float *wo, const float *wi) {
    pellicle::Bsdf bsdf;
    if (pellicle::BsdfBuilder("lambert").set("reflectance", 0.5f).create(bsdf) != PELLICLE_OK) return -1.0f;
    const pellicle::Bsdf copy = bsdf;
    const PellicleCall call = pellicle::call_options(PELLICLE_TRANSPORT_IMPORTANCE);
    float value[3] = {};
    pellicle_bsdf_eval(copy.raw(), wo, wi, nullptr, &call, value, nullptr, nullptr);
    return value[0];
}
