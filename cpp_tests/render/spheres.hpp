// Views of many spheres, each with a material of its own.
#pragma once

#include "view.hpp"

namespace render {

using Materials = std::vector<std::shared_ptr<const Material>>;

/// A row of spheres that stand on the floor, the first on the left; columns of the picture are equally
/// wide. `extent` as in Views.
Views sphereRow(std::function<Materials()> spheres, V2f extent, Floor floor = {});

/// Rows of spheres that float, the first row at the top; all rows have as many. Rows and columns of the
/// square picture are equally high and wide. `side` as in Views.
Views sphereGrid(std::function<std::vector<Materials>()> rows, float side);

} // namespace render
