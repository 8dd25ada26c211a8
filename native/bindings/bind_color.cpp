// SPDX-License-Identifier: GPL-3.0-or-later
// Color sources of a scene, and picture files.
#include <fovea/color/displayed.h>
#include <fovea/color/light.h>
#include <fovea/color/png.h>
#include <fovea/color/source.h>
#include <fovea/color/stored_png.h>

#include "bindings/bind.h"
#include "bindings/records.h"

namespace fovea::bindings {
namespace {

std::shared_ptr<ColorTexture> make_texture(const Pixels& image, bool encoded) {
    check(image.ndim() == 3 && image.shape(0) < (1 << 16) && image.shape(1) < (1 << 16),
          "texture: expected pixels of shape (height, width, channels)");
    const In<float> all(image.data(), std::size_t(image.size()));
    const int width = int(image.shape(1)), height = int(image.shape(0)), channels = int(image.shape(2));
    return without_gil([&] { return std::make_shared<ColorTexture>(all, width, height, channels, encoded); });
}

std::shared_ptr<SurfaceColor> make_surface_color(const std::vector<ColorSlot>& slots, const Optional<vec3>& normals,
                                                 const std::vector<Arg<vec2>>& uvs,
                                                 const std::vector<Arg<vec3>>& attributes) {
    auto color = std::make_shared<SurfaceColor>();
    color->slots = slots;
    if (normals) color->normals = copy<vec3>(*normals, "normals");
    for (const auto& uv : uvs) color->uvs.push_back(copy<vec2>(uv, "uvs"));
    for (const auto& attribute : attributes) color->attributes.push_back(copy<vec3>(attribute, "attributes"));
    return color;
}

StoredPng stored(const py::bytes& file) {
    const std::string_view bytes(file);
    return without_gil(
        [bytes] { return stored_png({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}); });
}

py::bytes png(const py::array_t<std::uint8_t, py::array::c_style>& rgb) {
    check(rgb.ndim() == 3 && rgb.shape(2) == 3, "rgb: expected shape (height, width, 3)");
    return py::bytes(png_bytes({rgb.data(), std::size_t(rgb.size())}, int(rgb.shape(1)), int(rgb.shape(0))));
}

Numpy<std::uint8_t> pixels_of_png(const py::bytes& file) {
    const std::string_view bytes(file);
    RgbImage read =
        without_gil([bytes] { return rgb_png({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}); });
    return to_numpy(std::move(read.values))
        .reshape({py::ssize_t(read.height), py::ssize_t(read.width), py::ssize_t(3)});
}

Numpy<std::uint8_t> displayed(const Pixels& image) {
    check(image.ndim() == 3 && image.shape(2) == 4, "image: expected shape (height, width, 4)");
    const In<vec4> pixels(reinterpret_cast<const vec4*>(image.data()), std::size_t(image.size()) / 4);
    auto bytes = without_gil([pixels] { return displayed_bytes(pixels, false); });
    return to_numpy(std::move(bytes)).reshape({image.shape(0), image.shape(1), py::ssize_t(3)});
}

}  // namespace

void bind_color(py::module_& m) {
    py::class_<ColorTexture, std::shared_ptr<ColorTexture>>(m, "ColorTexture", "An image of base colors.")
        .def(py::init(&make_texture), py::arg("pixels"), py::arg("encoded"),
             "(height, width, 1 to 4 channels) float32, bottom row first; encoded: as sRGB, else scene-linear.");
    py::class_<ColorSlot>(m, "ColorSlot", "What a material says about color.")
        .def(py::init([](const vec3& color, std::shared_ptr<ColorTexture> texture, std::optional<Index> uv,
                         std::optional<Index> attribute, bool unlit, float opacity) {
                 return ColorSlot{color,  std::move(texture), uv.value_or(none), attribute.value_or(none), unlit,
                                  opacity};
             }),
             py::arg("color"), py::arg("texture") = py::none(), py::arg("uv") = py::none(),
             py::arg("attribute") = py::none(), py::arg("unlit") = false, py::arg("opacity") = 0.0f);
    py::class_<SurfaceColor, std::shared_ptr<SurfaceColor>>(m, "SurfaceColor",
                                                            "Colors of a surface; see native/fovea/color/source.h.")
        .def(py::init(&make_surface_color), py::arg("slots"), py::arg("normals") = py::none(),
             py::arg("uvs") = std::vector<Arg<vec2>>(), py::arg("attributes") = std::vector<Arg<vec3>>(),
             "normals (C, 3), each of uvs (C, 2), each of attributes (C, 3): float32 per corner of the mesh.");
    py::class_<StoredPng>(m, "StoredPng", "The pixels of a PNG file as it stores them.")
        .def_readonly("width", &StoredPng::width)
        .def_readonly("height", &StoredPng::height)
        .def_readonly("channels", &StoredPng::channels, "of a palette: 1, its entry")
        .def_readonly("bits", &StoredPng::bits, "of a value: 1, 2, 4, 8 or 16")
        .def_property_readonly(
            "values",
            [](const StoredPng& image) {
                return py::bytes(reinterpret_cast<const char*>(image.values.data()), image.values.size());
            },
            "Rows from the top, each begins with a byte; of 16 bits the higher byte is first.");
    m.def("stored_png", &stored, py::arg("file"),
          "The pixels of a PNG file, of all of its bytes. ValueError if it is broken.");
    m.def("png_bytes", &png, py::arg("rgb"),
          "The bytes of a PNG file of (height, width, 3) uint8 sRGB, bottom row first.");
    m.def("pixels_of_png", &pixels_of_png, py::arg("file"),
          "The same pixels of the bytes of a PNG file of any kind; transparent parts lie on white.");
    m.def("displayed", &displayed, py::arg("image"),
          "The same of (height, width, 4) float32, scene-linear and premultiplied, on white.");
}

}  // namespace fovea::bindings
