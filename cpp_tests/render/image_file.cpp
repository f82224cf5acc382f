#include "image_file.hpp"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include <algorithm>
#include <stdexcept>

namespace render {

RadianceImage readRadiance(const std::filesystem::path &file, const std::string &what) {
    OIIO::ImageBuf image(file.string());
    const auto fail = [&](const std::string &why) {
        throw std::runtime_error("cannot read the " + what + " " + file.string() + ": " + why);
    };
    if (!image.read(0, 0, true, OIIO::TypeFloat)) fail(image.geterror());
    if (OIIO::Strutil::iequals(image.spec().get_string_attribute("oiio:ColorSpace"), "sRGB"))
        image = OIIO::ImageBufAlgo::colorconvert(image, "sRGB", "linear");
    const int grey[3] = {0, 0, 0};
    if (image.nchannels() < 3) image = OIIO::ImageBufAlgo::channels(image, 3, grey);
    if (image.has_error()) fail(image.geterror());

    RadianceImage result{image.spec().width, image.spec().height, {}};
    result.texels.resize(static_cast<std::size_t>(result.width) * result.height);
    OIIO::ROI roi = image.roi(); // a data window may begin anywhere
    roi.chend = 3;
    if (!image.get_pixels(roi, OIIO::TypeFloat, result.texels.data())) fail(image.geterror());
    for (Rgb &texel : result.texels) {
        // The largest half float stands for infinity, as it does in many an HDR photograph of the sun.
        for (int c = 0; c < 3; ++c) texel[c] = texel[c] > 0 ? std::min(texel[c], 65504.0f) : 0;
    }
    return result;
}

void writeRadiance(const RadianceImage &image, const std::filesystem::path &file) {
    OIIO::ImageBuf buffer(OIIO::ImageSpec(image.width, image.height, 3, OIIO::TypeFloat));
    buffer.set_pixels(buffer.roi(), OIIO::TypeFloat, image.texels.data());
    if (!buffer.write(file.string(), OIIO::TypeFloat))
        throw std::runtime_error("cannot write " + file.string() + ": " + buffer.geterror());
}

void makeDirectory(const std::filesystem::path &directory) {
    std::error_code error;
    std::filesystem::create_directories(directory, error);
    if (error)
        throw std::runtime_error("cannot make the directory " + directory.string() + ": " + error.message());
}

} // namespace render
