// An oxidised wafer to the horizon, whose thickness varies within a pixel where it is far away.
#pragma once

#include "camera.hpp"
#include "thickness_map.hpp"
#include "world.hpp"

namespace render {

/// SiO2 on silicon, 100 to 900 nm: mean 500 nm, two unevennesses of 70 nm, one twenty times as fine as the other.
std::shared_ptr<const Material> unevenOxide(Minification minification, std::shared_ptr<const Texture> moments);

/// A plane in the height 0, wider than can be seen. Committed.
std::unique_ptr<World> wafer(std::shared_ptr<const Material> material);

/// 2 above the wafer, towards its horizon.
Camera overWafer();

} // namespace render
