// The contact sheet: all pictures of a run on one page.
#pragma once

#include <OpenImageIO/imagebuf.h>

#include <string>
#include <vector>

namespace render {

struct Cell {
    std::string caption;                  ///< lines end in \n
    std::vector<OIIO::ImageBuf> pictures; ///< below one another; square, for display
};

/// Cells side by side, in as many rows as it takes, each with its caption underneath. Without the
/// font (Debian: fonts-dejavu-core) captions are left out. Throws std::runtime_error.
OIIO::ImageBuf contactSheet(const std::vector<Cell> &cells);

} // namespace render
