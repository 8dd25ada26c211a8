// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/color/png.h>

#include <png.h>

#include <fovea/base/check.h>
#include <fovea/base/files.h>

namespace fovea::color {
namespace {

/// A PNG on white, in a format of libpng with a byte for each value.
template <typename Image>
Image decoded(In<std::uint8_t> file, png_uint_32 format) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    bool done = png_image_begin_read_from_memory(&image, file.data(), file.size());
    check(done, std::string("PNG: ") + image.message);
    // No more than deflate can make of so many bytes, whatever the header says.
    const bool fits = std::size_t(image.width) * image.height / 8 / 1100 <= file.size();
    if (!fits) png_image_free(&image);
    check(fits, "PNG: the file is none, or broken");
    image.format = format;
    Image made{int(image.width), int(image.height), Array<std::uint8_t>(PNG_IMAGE_SIZE(image))};
    const png_color white{255, 255, 255};
    const auto upwards = -static_cast<png_int_32>(PNG_IMAGE_ROW_STRIDE(image));
    done = png_image_finish_read(&image, &white, made.values.data(), upwards, nullptr);
    check(done, std::string("PNG: ") + image.message);
    return made;
}

}  // namespace

PenTexture read_texture(const std::filesystem::path& file) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    const std::string bytes = bytes_of_file(file, largest_texture);
    bool done = png_image_begin_read_from_memory(&image, bytes.data(), bytes.size());
    check(done, name_of(file) + ": " + image.message);
    const bool fits = image.width <= largest_side && image.height <= largest_side;
    if (!fits) png_image_free(&image);
    check(fits, name_of(file) + ": it has more than " + std::to_string(largest_side) + " pixels along a side");
    image.format = PNG_FORMAT_GRAY;
    std::vector<std::uint8_t> gray(PNG_IMAGE_SIZE(image));
    done = png_image_finish_read(&image, nullptr, gray.data(), 0, nullptr);
    check(done, name_of(file) + ": " + image.message);
    PenTexture texture{int(image.width), int(image.height), Array<float>(gray.size())};
    for (std::size_t i = 0; i < gray.size(); ++i) texture.ink[i] = static_cast<float>(gray[i]) / 255.0f;
    return texture;
}

GrayImage gray_png(In<std::uint8_t> file) { return decoded<GrayImage>(file, PNG_FORMAT_GRAY); }

RgbImage rgb_png(In<std::uint8_t> file) { return decoded<RgbImage>(file, PNG_FORMAT_RGB); }

std::string png_bytes(In<std::uint8_t> values, int width, int height, int channels) {
    check(width > 0 && height > 0, "a picture needs pixels");
    check(values.size() == std::size_t(channels) * width * height,
          "rgb: " + std::string(channels == 3 ? "three" : std::to_string(channels)) + " values per pixel expected");
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(width);
    image.height = static_cast<png_uint_32>(height);
    image.format = channels == 1 ? PNG_FORMAT_GRAY : channels == 4 ? PNG_FORMAT_RGBA : PNG_FORMAT_RGB;
    const png_int_32 upwards = -channels * width;
    std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(image), '\0');
    png_alloc_size_t size = bytes.size();
    const bool done = png_image_write_to_memory(&image, bytes.data(), &size, 0, values.data(), upwards, nullptr);
    check(done, image.message);
    bytes.resize(size);
    return bytes;
}

}  // namespace fovea::color
