// The library's objects that rows are about.
#pragma once

#include "materials.hpp"

#include <pellicle.hpp>

namespace bsdfs {

// The SIMD level of everything that is made here; empty: the widest.
extern std::string simd_level;

// Of a model, or of a film on a base, at that level.
pellicle::BsdfBuilder of(const char *model);
pellicle::FilmBuilder on(pellicle::Medium base);

pellicle::BsdfBuilder layered();
pellicle::BsdfBuilder ggx(const char *fresnel, float alpha = material::alpha);
pellicle::Bsdf conductor();

// Of film_eta, 0 to greatest_nm thick, on the base of film_base_eta + i film_base_k.
pellicle::Film coating();
pellicle::Film soap();
pellicle::Film fixed_soap();

} // namespace bsdfs
