// pellicle.hpp compiles after the macros of a host, its templates included.
#include "host_macros.h"

#include <pellicle.hpp>

pellicle::Bsdf made_after_host_macros() {
    pellicle::Film film;
    pellicle::Bsdf bsdf;
    pellicle::FilmBuilder("Si").layer(pellicle::Medium::table({{400, 1.5f, 0}, {700, 1.4f, 0}}), 0, 500).create(film);
    pellicle::BsdfBuilder("film").film(film).vary("thickness_nm", 0, 500).create(bsdf);
    return bsdf;
}
