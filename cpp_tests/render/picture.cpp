#include "picture.hpp"

#include <OpenImageIO/imagebufalgo.h>

#include <algorithm>
#include <stdexcept>

namespace render {
namespace {

void write(const OIIO::ImageBuf &image, const std::filesystem::path &file, OIIO::TypeDesc type) {
    if (!image.write(file.string(), type))
        throw std::runtime_error("cannot write " + file.string() + ": " + image.geterror());
}

} // namespace

void writeExr(const Picture &picture, const std::filesystem::path &file) {
    static_assert(sizeof(Pixel) == 7 * sizeof(float), "a pixel is its channels one after another");
    OIIO::ImageSpec spec(picture.width, picture.height, 7, OIIO::TypeFloat);
    spec.channelnames = {"R", "G", "B", "N.X", "N.Y", "N.Z", "Z"};
    spec.attribute("compression", "zip");
    OIIO::ImageBuf image(spec);
    image.set_pixels(image.roi(), OIIO::TypeFloat, picture.pixels.data());
    write(image, file, OIIO::TypeFloat);
}

void writeExr(const OIIO::ImageBuf &image, const std::filesystem::path &file) {
    OIIO::ImageBuf compressed = image;
    compressed.specmod().attribute("compression", "zip");
    write(compressed, file, OIIO::TypeFloat);
}

OIIO::ImageBuf displayed(OIIO::ImageBuf linear, float exposure) {
    OIIO::ImageBufAlgo::mul(linear, linear, std::exp2(exposure));
    OIIO::ImageBufAlgo::clamp(linear, linear, 0.0f, 1.0f);
    if (!OIIO::ImageBufAlgo::colorconvert(linear, linear, "linear", "sRGB"))
        throw std::runtime_error("cannot convert to sRGB: " + linear.geterror());
    return linear;
}

OIIO::ImageBuf display(const Picture &picture, float exposure) {
    OIIO::ImageBuf image(OIIO::ImageSpec(picture.width, picture.height, 3, OIIO::TypeFloat));
    image.set_pixels(image.roi(), OIIO::TypeFloat, picture.pixels.data(), sizeof(Pixel));
    return displayed(std::move(image), exposure);
}

OIIO::ImageBuf photograph(const Picture &picture, float exposure) {
    // The specification's constants: F90 is 0.04, the reflectance of common dielectrics.
    constexpr float startCompression = 0.8f - 0.04f, desaturation = 0.15f;
    Picture toned = picture;
    for (Pixel &pixel : toned.pixels) {
        Rgb colour = pixel.radiance * std::exp2(exposure);
        const float least = std::min({colour.x, colour.y, colour.z});
        colour -= Rgb(least < 0.08f ? least - 6.25f * least * least : 0.04f);
        const float peak = maxComponent(colour);
        if (peak >= startCompression) {
            const float d = 1 - startCompression, newPeak = 1 - d * d / (peak + d - startCompression);
            const float grey = 1 - 1 / (desaturation * (peak - newPeak) + 1);
            colour = colour * (newPeak / peak) * (1 - grey) + Rgb(newPeak * grey);
        }
        pixel.radiance = colour;
    }
    return display(toned, 0);
}

void writeJpeg(const OIIO::ImageBuf &image, const std::filesystem::path &file) {
    OIIO::ImageBuf compressed = image;
    compressed.specmod().attribute("compression", "jpeg:90");
    compressed.specmod().attribute("jpeg:subsampling", "4:4:4");
    write(compressed, file, OIIO::TypeUInt8);
}

void writePng(const OIIO::ImageBuf &image, const std::filesystem::path &file) {
    OIIO::ImageBuf dithered = image;
    dithered.specmod().attribute("oiio:dither", 1);
    write(dithered, file, OIIO::TypeUInt8);
}

} // namespace render
