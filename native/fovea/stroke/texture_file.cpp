// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/stroke/texture_file.h>

#include <png.h>

#include <fovea/base/check.h>

namespace fovea {

PenTexture read_texture(const std::string& path) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    check(png_image_begin_read_from_file(&image, path.c_str()), path + ": " + image.message);
    image.format = PNG_FORMAT_GRAY;
    std::vector<std::uint8_t> grey(PNG_IMAGE_SIZE(image));
    check(png_image_finish_read(&image, nullptr, grey.data(), 0, nullptr), path + ": " + image.message);
    PenTexture texture{int(image.width), int(image.height), Array<float>(grey.size())};
    for (std::size_t i = 0; i < grey.size(); ++i) texture.ink[i] = static_cast<float>(grey[i]) / 255.0f;
    return texture;
}

}  // namespace fovea
