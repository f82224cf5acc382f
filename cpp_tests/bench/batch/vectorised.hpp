// The plain formulas once more as loops over structures of arrays, for the compiler to vectorise: branches
// are selects, what does not depend on the element is computed before the loop. Compiled twice, for
// vectors of 256 and of 512 bits, with -Ofast: NaN is not handled.
#pragma once

#include <cstddef>

namespace vectorised {

struct Components {
    const float *x, *y, *z;
};

struct In {
    Components wo, wi;
    const float *varying; // of rows that have one
};

struct Out {
    float *r, *g, *b;
};

// Linear RGB over cosine and thickness, 64 x 256, the channels apart; see plain::Bilinear.
struct FilmPlanes {
    const float *r, *g, *b;
};

// A function of the cosine, 64 values; see plain::Curve.
struct Remainder {
    const float *values;
    float mean;
};

// Every loop, and what it is called with.
#define VECTORISED_LOOPS(LOOP)                                                                                \
    LOOP(lambert, (const In &, const Out &, std::size_t))                                                     \
    LOOP(oren_nayar, (const In &, const Out &, std::size_t))                                                  \
    LOOP(disney_diffuse, (const In &, const Out &, std::size_t))                                              \
    LOOP(phong, (const In &, const Out &, std::size_t))                                                       \
    LOOP(layered, (const In &, const Out &, std::size_t))                                                     \
    LOOP(layered_varying, (const In &, const Out &, std::size_t))                                             \
    LOOP(ggx_schlick, (const In &, const Out &, std::size_t))                                                 \
    LOOP(ggx_dielectric, (const In &, const Out &, std::size_t))                                              \
    LOOP(ggx_conductor, (const In &, const Out &, std::size_t))                                               \
    LOOP(ggx_schlick_varying, (const In &, const Out &, std::size_t))                                         \
    LOOP(beckmann_conductor, (const In &, const Out &, std::size_t))                                          \
    LOOP(ggx_film, (const FilmPlanes &, const In &, const Out &, std::size_t))                                \
    LOOP(metallic_roughness, (const Remainder &, const In &, const Out &, std::size_t))                       \
    LOOP(film, (const FilmPlanes &, const In &, const Out &, std::size_t))                                    \
    LOOP(film_curve, (const FilmPlanes &, const In &, const Out &, std::size_t))

#define VECTORISED_DECLARE(name, arguments) void name arguments;
namespace bits256 {
VECTORISED_LOOPS(VECTORISED_DECLARE)
}
namespace bits512 {
VECTORISED_LOOPS(VECTORISED_DECLARE)
}
#undef VECTORISED_DECLARE

} // namespace vectorised
