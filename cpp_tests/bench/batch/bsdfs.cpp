#include "bsdfs.hpp"

namespace bsdfs {

pellicle::BsdfBuilder layered() {
    return pellicle::BsdfBuilder("layered")
        .set("eta", material::layer_eta, 3)
        .set("exponent_reflection", material::exponent_reflection)
        .set("exponent_transmission", material::exponent_transmission)
        .set("thickness_nm", material::layer_nm)
        .set("base_normal", material::deviation, 3)
        .set("specular_weight", 1.0f)
        .set("diffuse_weight", 0.0f)
        .choose("variant", "paper");
}

pellicle::BsdfBuilder ggx(const char *fresnel, float alpha) {
    return pellicle::BsdfBuilder("microfacet").set("alpha", alpha).choose("fresnel", fresnel);
}

pellicle::Bsdf conductor() {
    return ggx("conductor").set("eta", material::metal_eta, 3).set("k", material::metal_k, 3).create();
}

pellicle::Film coating() {
    return pellicle::FilmBuilder(pellicle::Medium::constant(material::film_base_eta, material::film_base_k))
        .layer(pellicle::Medium::constant(material::film_eta), 0.0f, material::greatest_nm)
        .create();
}

pellicle::Film soap() {
    return pellicle::FilmBuilder(pellicle::Medium::constant(1.0f))
        .layer(pellicle::Medium::constant(material::film_eta), 0.0f, material::greatest_nm)
        .create();
}

pellicle::Film fixed_soap() {
    return pellicle::FilmBuilder(pellicle::Medium::constant(1.0f))
        .layer(pellicle::Medium::constant(material::film_eta), material::fixed_nm)
        .create();
}

} // namespace bsdfs
