// A direction chosen by an environment's importance.
#pragma once

#include "math.hpp"

namespace render {

struct LightSample {
    V3f direction; ///< unit, towards the light
    Rgb radiance;
    float pdf; ///< per solid angle; 0: no sample
};

} // namespace render
