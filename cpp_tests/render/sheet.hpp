// A contact sheet: the pictures of a chapter on one page.
#pragma once

#include <OpenImageIO/imagebuf.h>

#include <string>
#include <vector>

namespace render {

struct Cell {
    std::string caption;                  ///< lines end in \n
    std::vector<OIIO::ImageBuf> pictures; ///< below one another, for display
    std::vector<std::string> columns;     ///< labels of equally wide columns, under the pictures
    std::vector<std::string> rows;        ///< labels of equally high rows, in the upper left corner of each
};

/// Cells side by side, in as many rows as it takes, each with its caption underneath.
struct Section {
    int columns;
    float aspect; ///< height over width of its pictures
    std::vector<Cell> cells;
};

/// A page; one that needs fewer columns than its section has is narrower. Without the font (Debian:
/// fonts-dejavu-core) captions are left out. Throws std::runtime_error.
OIIO::ImageBuf contactSheet(const Section &section);

} // namespace render
