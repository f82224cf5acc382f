// The embedded environments: a photographer's studio, lit in three ways, and a sky.
#pragma once

#include "environment.hpp"

namespace render {

/// A dim sky with narrow, bright soft boxes: narrow along the horizon, where the gallery's layers
/// spread their colours, so that these stay apart, and tall, so that highlights have a shape.
LatLongMap studio();

/// Wide soft boxes of about radiance 1 on both sides of the camera, above and behind the object, with
/// black gaps between. They reach below the horizon, for objects that float. What lies straight behind
/// the object is black, and so is the place of the camera.
LatLongMap darkRoom();

/// The same with grey gaps: metals show their own colour all over and keep a shape.
LatLongMap tent();

/// The CIE's standard overcast sky: the zenith, of radiance 1, three times as bright as the horizon.
LatLongMap cloudedSky();

} // namespace render
