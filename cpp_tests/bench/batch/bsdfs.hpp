// The library's objects that rows are about.
#pragma once

#include "materials.hpp"

#include <pellicle.hpp>

namespace bsdfs {

pellicle::BsdfBuilder layered();
pellicle::BsdfBuilder ggx(const char *fresnel, float alpha = material::alpha);
pellicle::Bsdf conductor();

// Of film_eta, 0 to greatest_nm thick, on the base of film_base_eta + i film_base_k.
pellicle::Film coating();
pellicle::Film soap();
pellicle::Film fixed_soap();

} // namespace bsdfs
