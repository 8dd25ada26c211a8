// SPDX-License-Identifier: GPL-3.0-or-later
// Pens, strokes and their reference picture.
#include <pybind11/stl.h>

#include <fovea/stroke/pen_table.h>
#include <fovea/stroke/raster.h>

#include "bindings/bind.h"

namespace fovea::bindings {
namespace {

Pen make_pen(const style::Pen& look, float width_px, float texture_length_px, std::optional<Index> texture,
             std::optional<Index> away) {
    check(width_px > 0.0f, "pen: the width must be positive");
    check(texture_length_px > 0.0f, "pen: the length of the texture must be positive");
    return {look, width_px, texture_length_px, texture.value_or(none), away.value_or(none)};
}

PenTexture make_pen_texture(const Pixels& ink) {
    check(ink.ndim() == 2 && ink.size() > 0, "pen texture: expected ink of shape (rows, columns)");
    return {int(ink.shape(1)), int(ink.shape(0)), Array<float>(ink.data(), ink.data() + ink.size())};
}

Strokes make_strokes(const Arg<vec2>& px, const Arg<vec4>& arc, const Arg<float>& half_width, const Arg<float>& opacity,
                     const Arg<Index>& pen, const Arg<glm::uvec3>& triangles, Index count, const Optional<vec2>& mix,
                     const Optional<float>& path_px) {
    const In<vec2> mixes = borrow<vec2>(mix, "mix");
    const In<float> lengths = borrow<float>(path_px, "path_px");
    return {copy<vec2>(px, "px"),
            copy<vec4>(arc, "arc"),
            copy<float>(half_width, "half_width"),
            copy<float>(opacity, "opacity"),
            mix ? Array<vec2>(mixes.begin(), mixes.end()) : Array<vec2>(std::size_t(px.shape(0)), vec2(0.0f)),
            path_px ? Array<float>(lengths.begin(), lengths.end()) : Array<float>(std::size_t(px.shape(0)), 0.0f),
            copy<Index>(pen, "pen"),
            {},
            copy<glm::uvec3>(triangles, "triangles"),
            count};
}

Numpy<vec4> draw(const Strokes& strokes, const std::vector<Pen>& pens, const std::vector<PenTexture>& textures,
                 int width, int height) {
    Array<vec4> image;
    without_gil([&] { raster(strokes, pens, textures, width, height, image); });
    return to_image(std::move(image), width, height);
}

void bind_pens(py::module_& m) {
    const Pen pen;
    py::class_<Pen>(m, "Pen", "A style's pen as one picture has it.")
        .def(
            py::init(&make_pen), py::kw_only(), py::arg("look"), py::arg("width_px") = pen.width_px,
            py::arg("texture_length_px") = pen.texture_length_px, py::arg("texture") = py::none(),
            py::arg("away") = py::none(),
            R"(look: of the style, its lengths in pixels of the picture; texture: index into the frame's textures, None:
solid; away: index of the pen that this one becomes out of focus, None: it stays as it is.)");
    py::class_<PenTexture>(m, "PenTexture", "Ink of a pen, repeated along the stroke.")
        .def(py::init(&make_pen_texture), py::arg("ink"),
             "(rows, columns) float32 in [0, 1]; first row: left side of the way.");
    py::class_<PenTable, std::shared_ptr<PenTable>>(
        m, "PenTable", "N pens and their ink as the gpu's stroke pass reads them; see native/fovea/stroke/pen_table.h.")
        .def(py::init([](const std::vector<Pen>& pens, const std::vector<PenTexture>& textures) {
                 return std::make_shared<PenTable>(pen_table(pens, textures));
             }),
             py::arg("pens"), py::arg("textures"))
        .def_property_readonly("pens", viewing<PenTable>(&PenTable::pens), "(3 N, 4) float32")
        .def_property_readonly("ink", viewing<PenTable>(&PenTable::ink), "(I,) float32");
}

void bind_strokes(py::module_& m) {
    py::class_<Strokes, std::shared_ptr<Strokes>> strokes(
        m, "Strokes", "Visible runs shaped into V vertices and T triangles; see native/fovea/stroke/strokes.h.");
    strokes
        .def(py::init(&make_strokes), py::arg("px"), py::arg("arc"), py::arg("half_width"), py::arg("opacity"),
             py::arg("pen"), py::arg("triangles"), py::arg("count") = 0, py::arg("mix") = py::none(),
             py::arg("path_px") = py::none())
        .def("__len__", [](const Strokes& s) { return s.count; })
        .def_property_readonly("triangles", viewing<Strokes>(&Strokes::triangles), "(T, 3) uint32, in drawing order")
        .def_readonly("count", &Strokes::count, "strokes")
        .def("raster", &draw, py::arg("pens"), py::arg("textures"), py::arg("width"), py::arg("height"),
             "(height, width, 4) float32: the reference picture, premultiplied, bottom row first.");
    bind_columns(strokes, Strokes::vertex_columns);
}

}  // namespace

void bind_stroke(py::module_& m) {
    bind_pens(m);
    bind_strokes(m);
}

}  // namespace fovea::bindings
