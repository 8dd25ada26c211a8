// SPDX-License-Identifier: GPL-3.0-or-later
// Pens, strokes and the reference rasterizer.
#include <fovea/stroke/ink.h>
#include <fovea/stroke/raster.h>

#include "bindings/arrays.h"
#include "bindings/bind.h"

namespace fovea::bindings {
namespace {

Numpy<vec4> draw(const Strokes& strokes, const std::vector<Pen>& pens, const std::vector<PenTexture>& textures,
                 int width, int height) {
    return to_image(without_gil([&] { return rasterize(strokes, pens, textures, width, height); }), width, height);
}

}  // namespace

void bind_stroke(py::module_& m) {
    py::class_<Pen>(m, "Pen", "A style's pen as one picture has it.");
    py::class_<PenTexture>(m, "PenTexture", "Ink of a pen, repeated along the stroke.");
    py::class_<PenTable, std::shared_ptr<PenTable>>(
        m, "PenTable", "N pens and their ink as the gpu's stroke pass reads them; see native/fovea/stroke/ink.h.")
        .def(py::init([](const std::vector<Pen>& pens, const std::vector<PenTexture>& textures) {
                 return std::make_shared<PenTable>(pen_table(pens, textures));
             }),
             py::arg("pens"), py::arg("textures"))
        .def_property_readonly("pens", viewing<PenTable>(&PenTable::pens), "(3 N, 4) float32")
        .def_property_readonly("ink", viewing<PenTable>(&PenTable::ink), "(I,) float32");
    py::class_<Strokes, std::shared_ptr<Strokes>> strokes(
        m, "Strokes", "Visible runs shaped into V vertices and T triangles; see native/fovea/stroke/strokes.h.");
    strokes.def("__len__", [](const Strokes& s) { return s.count; })
        .def_property_readonly("triangles", viewing<Strokes>(&Strokes::triangles), "(T, 3) uint32, in drawing order")
        .def_readonly("count", &Strokes::count, "strokes")
        .def("raster", &draw, py::arg("pens"), py::arg("textures"), py::arg("width"), py::arg("height"),
             "(height, width, 4) float32: the reference picture, premultiplied, bottom row first.");
    bind_columns(strokes, Strokes::vertex_columns);
}

}  // namespace fovea::bindings
