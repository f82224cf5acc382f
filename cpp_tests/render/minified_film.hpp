// A sheet of anodised titanium, far across, whose thickness varies within a pixel where it is far away.
#pragma once

#include "camera.hpp"
#include "thickness_map.hpp"
#include "world.hpp"

namespace render {

/// TiO2 on titanium: mean 160 nm, with a broad unevenness of 22 nm and one of 28 nm that is twenty times as fine.
std::shared_ptr<const Material> unevenOxide(Minification minification, std::shared_ptr<const Texture> moments);

/// A plane in the height 0, wider than can be seen, with texture coordinates. Committed.
std::unique_ptr<World> anodisedSheet(std::shared_ptr<const Material> material);

/// 2 above the sheet, looking down by 4 to 48 degrees.
Camera overSheet();

} // namespace render
