#include "sheet.hpp"

#include <OpenImageIO/imagebufalgo.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace render {
namespace {

constexpr int pageWidth = 1672, gap = 12, fontSize = 15, lineHeight = 21;
constexpr const char *font = "DejaVuSans";
constexpr float paper[3] = {0.085f, 0.085f, 0.09f}, bright[3] = {0.92f, 0.92f, 0.92f},
                dim[3] = {0.62f, 0.62f, 0.62f};

std::vector<std::string> linesOf(const std::string &text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

void place(OIIO::ImageBuf &sheet, const OIIO::ImageBuf &picture, int x, int y, int width, int height) {
    OIIO::ImageBuf fitted = picture;
    if (picture.spec().width != width || picture.spec().height != height)
        fitted = OIIO::ImageBufAlgo::resize(picture, "", 0, OIIO::ROI(0, width, 0, height, 0, 1, 0, 3));
    if (!OIIO::ImageBufAlgo::paste(sheet, x, y, 0, 0, fitted))
        throw std::runtime_error("cannot lay out the contact sheet: " + sheet.geterror());
}

/// False without the font; the sheet then stays without captions.
bool write(OIIO::ImageBuf &sheet, const std::string &line, int x, int y, const float (&colour)[3],
           OIIO::ImageBufAlgo::TextAlignX align = OIIO::ImageBufAlgo::TextAlignX::Left) {
    if (OIIO::ImageBufAlgo::render_text(sheet, x, y, line, fontSize, font, colour, align)) return true;
    sheet.geterror();
    return false;
}

/// The first line is the title.
void writeCaption(OIIO::ImageBuf &sheet, const std::vector<std::string> &lines, int x, int y) {
    for (const std::string &line : lines) {
        y += lineHeight;
        if (!write(sheet, line, x + 2, y, &line == &lines.front() ? bright : dim)) return;
    }
}

/// Of a picture whose upper left corner is given, and of the line below it.
void writeLabels(OIIO::ImageBuf &sheet, const Cell &cell, int x, int y, int width, int height) {
    const auto count = [](const std::vector<std::string> &labels) { return static_cast<int>(labels.size()); };
    for (int i = 0; i < count(cell.columns); ++i) {
        const int centre = x + (2 * i + 1) * width / (2 * count(cell.columns));
        write(sheet, cell.columns[i], centre, y + height + lineHeight, dim,
              OIIO::ImageBufAlgo::TextAlignX::Center);
    }
    for (int i = 0; i < count(cell.rows); ++i)
        write(sheet, cell.rows[i], x + gap / 2, y + i * height / count(cell.rows) + fontSize + gap / 4, dim);
}

/// A section's measures, in pixels.
struct Layout {
    int columns, rows, pictureWidth, pictureHeight, cellHeight;

    explicit Layout(const Section &section) {
        std::size_t stacked = 0, lines = 0;
        for (const Cell &cell : section.cells) {
            stacked = std::max(stacked, cell.pictures.size());
            lines = std::max(lines, linesOf(cell.caption).size() + (cell.columns.empty() ? 0 : 1));
        }
        const int count = static_cast<int>(section.cells.size());
        columns = std::min(section.columns, count);
        rows = columns ? (count + columns - 1) / columns : 0;
        pictureWidth = (pageWidth - gap) / section.columns - gap;
        pictureHeight = static_cast<int>(std::lround(static_cast<float>(pictureWidth) * section.aspect));
        cellHeight = static_cast<int>(stacked) * (pictureHeight + gap / 2) +
                     static_cast<int>(lines) * lineHeight + 2 * gap;
    }

    int width() const { return columns * (pictureWidth + gap) + gap; }
};

/// Its upper edge is at `top`.
void draw(OIIO::ImageBuf &sheet, const Section &section, const Layout &layout, int top) {
    for (int i = 0; i < static_cast<int>(section.cells.size()); ++i) {
        const Cell &cell = section.cells[i];
        const int x = gap + i % layout.columns * (layout.pictureWidth + gap);
        int y = top + i / layout.columns * layout.cellHeight;
        for (const OIIO::ImageBuf &picture : cell.pictures) {
            place(sheet, picture, x, y, layout.pictureWidth, layout.pictureHeight);
            writeLabels(sheet, cell, x, y, layout.pictureWidth, layout.pictureHeight);
            y += layout.pictureHeight + gap / 2;
        }
        writeCaption(sheet, linesOf(cell.caption), x, y - gap / 2 + (cell.columns.empty() ? 0 : lineHeight));
    }
}

} // namespace

OIIO::ImageBuf contactSheet(const Section &section) {
    const Layout layout(section);
    OIIO::ImageBuf sheet(OIIO::ImageSpec(layout.width(), gap + layout.rows * layout.cellHeight, 3, OIIO::TypeFloat));
    OIIO::ImageBufAlgo::fill(sheet, paper);
    draw(sheet, section, layout, gap);
    return sheet;
}

} // namespace render
