#include "material.hpp"

#include <stdexcept>

namespace render {

Material::Material(pellicle::BsdfBuilder bsdf, std::vector<VaryingParameter> varying) {
    for (VaryingParameter &parameter : varying) {
        bsdf.vary(parameter.name, parameter.min, parameter.max);
        patterns_.push_back(std::move(parameter.pattern));
    }
    bsdf_ = bsdf.create();
    const PellicleBsdfInfo info = bsdf_.info();
    transmits_ = (info.flags & PELLICLE_TRANSMISSION) != 0;
    onlyDirac_ = (info.flags & (PELLICLE_DIFFUSE | PELLICLE_GLOSSY)) == 0;

    std::size_t components = 0;
    for (const Pattern &pattern : patterns_) components += pattern.components;
    if (components != info.varying_floats || components > std::tuple_size_v<Varying>)
        throw std::logic_error("a pattern does not have its parameter's number of components");
}

Material::Varying Material::varyingAt(const SurfacePoint &point) const {
    Varying varying{};
    float *next = varying.data();
    for (const Pattern &pattern : patterns_) {
        pattern.write(point, next);
        next += pattern.components;
    }
    return varying;
}

Material &Material::mapNormals(Pattern normals) {
    if (normals.components != 3) throw std::logic_error("a normal map has three components");
    normals_ = std::move(normals);
    return *this;
}

Material &Material::reflectAmbient(const Rgb &reflectance) {
    ambientReflectance_ = reflectance;
    return *this;
}

V3f Material::normalAt(const SurfacePoint &point) const {
    V3f normal;
    normals_->write(point, &normal.x);
    return normal;
}

} // namespace render
