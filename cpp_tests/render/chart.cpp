#include "chart.hpp"

#include "math.hpp"
#include "picture.hpp"

#include <OpenImageIO/imagebufalgo.h>

#include <cstdio>

namespace render {
namespace {

constexpr int left = 34, right = 22, top = 8, bottom = 24, fontSize = 13;
constexpr float background[3] = {0.085f, 0.085f, 0.09f}, ink[3] = {0.75f, 0.75f, 0.75f};

std::string captionOf(const Stack &stack) {
    char brightness[32] = "at its own brightness";
    if (stack.chartExposure != 0)
        std::snprintf(brightness, sizeof brightness, "shown %.3g times as bright",
                      std::exp2(stack.chartExposure));
    return stack.title + "\n0-1500 nm, 0-90 degrees, " + brightness + "\n";
}

void label(OIIO::ImageBuf &image, int x, int y, const std::string &text, bool toTheLeft) {
    using Align = OIIO::ImageBufAlgo::TextAlignX;
    OIIO::ImageBufAlgo::render_text(image, x, y, text, fontSize, "DejaVuSans", ink,
                                    toTheLeft ? Align::Right : Align::Center,
                                    toTheLeft ? OIIO::ImageBufAlgo::TextAlignY::Center
                                              : OIIO::ImageBufAlgo::TextAlignY::Top);
    image.geterror(); // no font: no numbers
}

} // namespace

const std::vector<Chart> &charts() {
    static const std::vector<Chart> all = [] {
        std::vector<Chart> list;
        for (const Stack &stack : stacks())
            list.push_back({"newton-" + stack.name, captionOf(stack), stack, stack.chartExposure});
        return list;
    }();
    return all;
}

OIIO::ImageBuf reflectanceChart(const Stack &stack, int width, int height) {
    const pellicle::Film film = stack.film(chartThickness).create();
    OIIO::ImageBuf chart(OIIO::ImageSpec(width, height, 3, OIIO::TypeFloat));
    for (int y = 0; y < height; ++y) {
        const float angle = 90 * (1 - (static_cast<float>(y) + 0.5f) / static_cast<float>(height));
        for (int x = 0; x < width; ++x) {
            const float thickness =
                chartThickness * (static_cast<float>(x) + 0.5f) / static_cast<float>(width);
            chart.setpixel(x, y, film.reflectance(std::cos(radians(angle)), thickness).data());
        }
    }
    return chart;
}

OIIO::ImageBuf displayChart(const OIIO::ImageBuf &chart, float exposure) {
    const int width = chart.spec().width, height = chart.spec().height;
    OIIO::ImageBuf page(OIIO::ImageSpec(left + width + right, top + height + bottom, 3, OIIO::TypeFloat));
    OIIO::ImageBufAlgo::fill(page, background);
    if (!OIIO::ImageBufAlgo::paste(page, left, top, 0, 0, displayed(chart, exposure)))
        throw std::runtime_error("cannot draw a chart: " + page.geterror());

    for (int thickness = 0; thickness <= 1500; thickness += 250) {
        const int x = left + width * thickness / 1500;
        OIIO::ImageBufAlgo::fill(page, ink, OIIO::ROI(x, x + 1, top + height, top + height + 4));
        if (thickness % 500 == 0)
            label(page, x, top + height + 6, std::to_string(thickness) + (thickness ? "" : " nm"), false);
    }
    for (int angle = 0; angle <= 90; angle += 30) {
        const int y = top + height - height * angle / 90;
        OIIO::ImageBufAlgo::fill(page, ink, OIIO::ROI(left - 4, left, y, y + 1));
        label(page, left - 6, y, std::to_string(angle), true);
    }
    return page;
}

} // namespace render
