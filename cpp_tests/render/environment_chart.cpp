#include "environment_chart.hpp"

#include "picture.hpp"

#include <OpenImageIO/imagebufalgo.h>

#include <algorithm>
#include <cstdio>

namespace render {
namespace {

constexpr int columns = PrefilteredEnvironment::steps + 1;
/// As many as leave noise that is hardly seen, and few enough for some seconds.
constexpr int truthPairs = 32, truthRepetitions = 2, filteredSamples = 16;

/// Of a page, pixels.
constexpr int left = 130, top = 26, gap = 10, lineHeight = 20, fontSize = 14;
constexpr float background[3] = {0.085f, 0.085f, 0.09f}, ink[3] = {0.8f, 0.8f, 0.8f};
constexpr float grey = 0.5f;
/// By which differences are magnified.
constexpr float gain = 2;

void write(OIIO::ImageBuf &page, const std::string &text, int x, int y,
           OIIO::ImageBufAlgo::TextAlignX align = OIIO::ImageBufAlgo::TextAlignX::Center) {
    if (!OIIO::ImageBufAlgo::render_text(page, x, y, text, fontSize, "DejaVuSans", ink, align,
                                         OIIO::ImageBufAlgo::TextAlignY::Center))
        page.geterror(); // no font: no text
}

void put(OIIO::ImageBuf &image, const std::vector<SpherePixel> &pixels, const std::vector<Rgb> &values, int size,
         int row, int column) {
    for (std::size_t i = 0; i < pixels.size(); ++i)
        image.setpixel(column * size + pixels[i].at.x, row * size + pixels[i].at.y, &values[i].x);
}

std::string percent(double share) {
    char text[32];
    std::snprintf(text, sizeof text, share < 0.1 ? "%.1f %%" : "%.0f %%", 100 * share);
    return text;
}

/// For display as it is: no transfer curve, so that more and less look alike.
OIIO::ImageBuf differenceOf(const OIIO::ImageBuf &way, const OIIO::ImageBuf &truth, float exposure) {
    OIIO::ImageBuf image = OIIO::ImageBufAlgo::sub(way, truth);
    OIIO::ImageBufAlgo::mul(image, image, gain * std::exp2(exposure) * grey);
    OIIO::ImageBufAlgo::add(image, image, grey);
    OIIO::ImageBufAlgo::clamp(image, image, 0.0f, 1.0f);
    return image;
}

} // namespace

const std::vector<EnvironmentChart> &environmentCharts() {
    const std::string explanation = "\nRoughness from left to right; errors are root mean squares relative to the "
                                    "truth's; differences magnified twice";
    static const std::vector<EnvironmentChart> all{
        {"environment-landscape", "Gold in the landscape: importance sampling, filtered sampling, split sum" + explanation,
         "landscape", -0.8f},
        {"environment-studio", "Gold in the studio: importance sampling, filtered sampling, split sum" + explanation,
         "studio", 0.4f},
    };
    return all;
}

EnvironmentSpheres environmentSpheres(const EnvironmentChart &chart, const AlbedoTable &albedo, int size,
                                      const std::filesystem::path &directory, int threads) {
    const PreparedEnvironment environment(chart.environment, comparedMap(chart.environment), directory, threads);
    const std::vector<SpherePixel> pixels = spherePixels(size);
    EnvironmentSpheres result{OIIO::ImageBuf(OIIO::ImageSpec(columns * size, 3 * size, 3, OIIO::TypeFloat)), {}, {}};
    for (int column = 0; column < columns; ++column) {
        const float roughness = static_cast<float>(column) / (columns - 1);
        const Truth expected = truth(environment, roughness, truthPairs, truthRepetitions, pixels, threads);
        const std::vector<Rgb> filtered = evaluated(filteredWay(environment, roughness, filteredSamples), pixels, threads);
        const std::vector<Rgb> split = evaluated(splitSumWay(environment, albedo, roughness), pixels, threads);
        put(result.radiance, pixels, expected.mean, size, 0, column);
        put(result.radiance, pixels, filtered, size, 1, column);
        put(result.radiance, pixels, split, size, 2, column);
        result.filtered.push_back(deviation(filtered, expected));
        result.splitSum.push_back(deviation(split, expected));
    }
    return result;
}

OIIO::ImageBuf displaySpheres(const EnvironmentSpheres &spheres, float exposure) {
    const int size = spheres.radiance.spec().width / columns, cell = size + gap, ways = 3;
    const auto rowTop = [&](int row) { return top + row * cell + std::max(0, row - ways) * lineHeight; };
    OIIO::ImageBuf page(
        OIIO::ImageSpec(left + columns * cell, rowTop(2 * ways - 2) + lineHeight + cell, 3, OIIO::TypeFloat));
    OIIO::ImageBufAlgo::fill(page, background);

    const auto part = [&](const OIIO::ImageBuf &image, int row, int column) {
        const OIIO::ROI roi(column * size, (column + 1) * size, row * size, (row + 1) * size);
        return OIIO::ImageBufAlgo::cut(image, roi);
    };
    const std::vector<SpherePixel> pixels = spherePixels(size);
    // Pixels beside the sphere keep the background.
    const auto place = [&](const OIIO::ImageBuf &image, int row, int column) {
        for (const SpherePixel &pixel : pixels) {
            float colour[3];
            image.getpixel(pixel.at.x, pixel.at.y, colour);
            page.setpixel(left + column * cell + pixel.at.x, rowTop(row) + pixel.at.y, colour);
        }
    };
    const char *names[] = {"truth: importance", "filtered, 16", "split sum", "filtered", "split sum"};
    const char *below[] = {"sampling", "samples", "", "minus truth", "minus truth"};
    for (int row = 0; row < 2 * ways - 1; ++row) {
        const int middle = rowTop(row) + size / 2;
        write(page, names[row], left / 2, middle - (*below[row] ? lineHeight / 2 : 0));
        write(page, below[row], left / 2, middle + lineHeight / 2);
    }
    for (int column = 0; column < columns; ++column) {
        const int centre = left + column * cell + size / 2;
        char roughness[16];
        std::snprintf(roughness, sizeof roughness, "%.1f", static_cast<double>(column) / (columns - 1));
        write(page, (column ? "" : "roughness ") + std::string(roughness), centre, top / 2);
        const OIIO::ImageBuf expected = part(spheres.radiance, 0, column);
        for (int row = 0; row < ways; ++row) {
            const OIIO::ImageBuf way = part(spheres.radiance, row, column);
            place(displayed(way, exposure), row, column);
            if (row == 0) continue;
            const int differences = ways - 1 + row;
            place(differenceOf(way, expected, exposure), differences, column);
            const Deviation &error = row == 1 ? spheres.filtered[column] : spheres.splitSum[column];
            write(page, percent(error.rms), centre, rowTop(differences) + size + lineHeight / 2 + 1);
        }
    }
    return page;
}

} // namespace render
