#include "picture.hpp"

#include <OpenImageIO/imagebufalgo.h>

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

void writePng(const OIIO::ImageBuf &image, const std::filesystem::path &file) {
    OIIO::ImageBuf dithered = image;
    dithered.specmod().attribute("oiio:dither", 1);
    write(dithered, file, OIIO::TypeUInt8);
}

} // namespace render
