// The embedded default environment: a photographer's studio.
#pragma once

#include "environment.hpp"

namespace render {

/// A dim sky with narrow, bright soft boxes: narrow along the horizon, where the gallery's layers
/// spread their colours, so that these stay apart, and tall, so that highlights have a shape.
LatLongMap studio();

} // namespace render
