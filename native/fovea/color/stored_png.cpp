// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/color/stored_png.h>

#include <csetjmp>
#include <cstring>
#include <png.h>

#include <fovea/base/check.h>

namespace fovea::color {
namespace {

/// What is left of the file.
struct Source {
    const std::uint8_t* at;
    const std::uint8_t* end;
};

void take(png_structp reader, png_bytep out, std::size_t count) {
    auto& source = *static_cast<Source*>(png_get_io_ptr(reader));
    if (std::size_t(source.end - source.at) < count) png_error(reader, "it breaks off");
    std::memcpy(out, source.at, count);
    source.at += count;
}

[[noreturn]] void leave(png_structp reader, png_const_charp) { png_longjmp(reader, 1); }

void ignore(png_structp, png_const_charp) {}

struct Reader {
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, leave, ignore);
    png_infop info = png ? png_create_info_struct(png) : nullptr;
    Reader() = default;
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;
    ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
};

// libpng leaves these by longjmp, so they have no objects with destructors.

bool read_header(const Reader& reader) {
    if (setjmp(png_jmpbuf(reader.png))) return false;
    png_set_crc_action(reader.png, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
    png_read_info(reader.png, reader.info);
    png_set_interlace_handling(reader.png);
    png_read_update_info(reader.png, reader.info);
    return true;
}

bool read_rows(const Reader& reader, png_bytepp rows) {
    if (setjmp(png_jmpbuf(reader.png))) return false;
    png_read_image(reader.png, rows);
    png_read_end(reader.png, nullptr);
    return true;
}

}  // namespace

StoredPng stored_png(In<std::uint8_t> file) {
    const Reader reader;
    check(reader.info, "PNG: memory is too small for it");
    Source source{file.data(), file.data() + file.size()};
    png_set_read_fn(reader.png, &source, take);
    constexpr auto broken = "PNG: the file is none, or broken";
    check(read_header(reader), broken);
    StoredPng image{int(png_get_image_width(reader.png, reader.info)),
                    int(png_get_image_height(reader.png, reader.info)),
                    png_get_channels(reader.png, reader.info),
                    png_get_bit_depth(reader.png, reader.info),
                    {}};
    const std::size_t stride = png_get_rowbytes(reader.png, reader.info);
    // No more than deflate can make of so many bytes, whatever the header says.
    check(stride * std::size_t(image.height) / 1100 <= file.size(), broken);
    image.values.resize(stride * std::size_t(image.height));
    std::vector<png_bytep> rows(std::size_t(image.height));
    for (std::size_t y = 0; y < rows.size(); ++y) rows[y] = image.values.data() + y * stride;
    check(read_rows(reader, rows.data()), broken);
    return image;
}

}  // namespace fovea::color
