#include "sheet.hpp"

#include <OpenImageIO/imagebufalgo.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace render {
namespace {

constexpr int columns = 5, pictureSize = 320, gap = 12, fontSize = 15, lineHeight = 21;
constexpr const char *font = "DejaVuSans";
constexpr float paper[3] = {0.085f, 0.085f, 0.09f}, bright[3] = {0.92f, 0.92f, 0.92f},
                dim[3] = {0.62f, 0.62f, 0.62f};

std::vector<std::string> linesOf(const std::string &text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

void place(OIIO::ImageBuf &sheet, const OIIO::ImageBuf &picture, int x, int y) {
    OIIO::ImageBuf fitted = picture;
    if (picture.spec().width != pictureSize || picture.spec().height != pictureSize)
        fitted =
            OIIO::ImageBufAlgo::resize(picture, "", 0, OIIO::ROI(0, pictureSize, 0, pictureSize, 0, 1, 0, 3));
    if (!OIIO::ImageBufAlgo::paste(sheet, x, y, 0, 0, fitted))
        throw std::runtime_error("cannot lay out the contact sheet: " + sheet.geterror());
}

/// The first line is the title.
void write(OIIO::ImageBuf &sheet, const std::vector<std::string> &lines, int x, int y) {
    for (const std::string &line : lines) {
        y += lineHeight;
        const bool title = &line == &lines.front();
        if (!OIIO::ImageBufAlgo::render_text(sheet, x + 2, y, line, fontSize, font, title ? bright : dim)) {
            sheet.geterror(); // no font: the sheet stays without captions
            return;
        }
    }
}

} // namespace

OIIO::ImageBuf contactSheet(const std::vector<Cell> &cells) {
    std::size_t stacked = 0, lines = 0;
    for (const Cell &cell : cells) {
        stacked = std::max(stacked, cell.pictures.size());
        lines = std::max(lines, linesOf(cell.caption).size());
    }
    const int count = static_cast<int>(cells.size()), acrossCount = std::min(columns, count);
    const int rows = (count + columns - 1) / columns;
    const int cellWidth = pictureSize + gap;
    const int captionHeight = static_cast<int>(lines) * lineHeight + gap;
    const int cellHeight = static_cast<int>(stacked) * (pictureSize + gap / 2) + captionHeight + gap;

    OIIO::ImageBuf sheet(
        OIIO::ImageSpec(acrossCount * cellWidth + gap, rows * cellHeight + gap, 3, OIIO::TypeFloat));
    OIIO::ImageBufAlgo::fill(sheet, paper);
    for (int i = 0; i < count; ++i) {
        const int x = gap + i % columns * cellWidth;
        int y = gap + i / columns * cellHeight;
        for (const OIIO::ImageBuf &picture : cells[i].pictures) {
            place(sheet, picture, x, y);
            y += pictureSize + gap / 2;
        }
        write(sheet, linesOf(cells[i].caption), x, y - gap / 2);
    }
    return sheet;
}

} // namespace render
