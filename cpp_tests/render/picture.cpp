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

OIIO::ImageBuf display(const Picture &picture, float exposure) {
    OIIO::ImageBuf image(OIIO::ImageSpec(picture.width, picture.height, 3, OIIO::TypeFloat));
    image.set_pixels(image.roi(), OIIO::TypeFloat, picture.pixels.data(), sizeof(Pixel));
    OIIO::ImageBufAlgo::mul(image, image, std::exp2(exposure));
    OIIO::ImageBufAlgo::clamp(image, image, 0.0f, 1.0f);
    if (!OIIO::ImageBufAlgo::colorconvert(image, image, "linear", "sRGB"))
        throw std::runtime_error("cannot convert to sRGB: " + image.geterror());
    return image;
}

void writePng(const OIIO::ImageBuf &image, const std::filesystem::path &file) {
    OIIO::ImageBuf dithered = image;
    dithered.specmod().attribute("oiio:dither", 1);
    write(dithered, file, OIIO::TypeUInt8);
}

} // namespace render
