// The light of a scene.
#pragma once

#include "environment.hpp"

namespace render {

enum class Lighting {
    studio,   ///< narrow soft boxes: for highlights of rough surfaces
    darkRoom, ///< wide soft boxes and nothing else: for what is transparent or reflects little
    tent,     ///< wide soft boxes with grey gaps: for metals
    sky,      ///< a clouded sky: for mirrors that lie flat
};

LatLongMap mapOf(Lighting lighting);

} // namespace render
