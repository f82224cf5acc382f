#include "environment.hpp"

namespace render {

Rgb Environment::radiance(const V3f &direction) const {
    return std::visit([&](const auto &light) { return light.radiance(direction); }, light_);
}

Environment::Sample Environment::sample(const V2f &u) const {
    return std::visit([&](const auto &light) { return light.sample(u); }, light_);
}

float Environment::pdf(const V3f &direction) const {
    return std::visit([&](const auto &light) { return light.pdf(direction); }, light_);
}

} // namespace render
