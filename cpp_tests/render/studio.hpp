// The embedded environments: a photographer's studio, lit in several ways, and a sky.
#pragma once

#include "environment.hpp"

#include <vector>

namespace render {

/// A rectangle of light that faces the origin, infinitely far away.
struct SoftBox {
    float azimuth, elevation; ///< degrees; azimuth from -z (behind the object) towards +x
    float width, height;      ///< degrees
    float roll;               ///< degrees
    Rgb radiance;
};

/// What the boxes add to the light from a direction.
Rgb lightOf(const std::vector<SoftBox> &boxes, const V3f &direction);

/// A dim sky with narrow, bright soft boxes: narrow along the horizon, where the gallery's layers
/// spread their colours, so that these stay apart, and tall, so that highlights have a shape.
LatLongMap studio();

/// Wide soft boxes of about radiance 1 on both sides of the camera, above and behind the object, with
/// black gaps between. They reach below the horizon, for objects that float. What lies straight behind
/// the object is black, and so is the place of the camera.
LatLongMap darkRoom();

/// The same with grey gaps: metals show their own colour all over and keep a shape.
LatLongMap tent();

/// A grey room with a window of small panes on the left, in front, and pale soft boxes on the right and
/// behind. Nothing is black, and nothing is so bright that its image in a good mirror would be only white.
LatLongMap windowRoom();

/// A lamp of 6 degrees at the upper left, in front, in a dim grey room.
LatLongMap spotInRoom();

/// A lamp of 8 degrees where the camera of rows of spheres is, and little else.
LatLongMap frontLamp();

/// A lamp of 6 degrees at the upper left, in front, in the dark.
LatLongMap lamp();

/// The CIE's standard overcast sky: the zenith, of radiance 1, three times as bright as the horizon.
LatLongMap cloudedSky();

} // namespace render
