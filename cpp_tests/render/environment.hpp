// Light from infinitely far away.
#pragma once

#include "lat_long.hpp"

namespace render {

using Environment = LatLongLight;

} // namespace render
