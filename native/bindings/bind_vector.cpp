// SPDX-License-Identifier: GPL-3.0-or-later
// Frames as vectors.
#include <fovea/vector/compose.h>
#include <fovea/vector/svg.h>

#include "bindings/bind.h"
#include "bindings/records.h"

namespace fovea::bindings {
namespace {

py::dict figures_of(const vector::Drawing& drawing) {
    py::dict figures;
    style::for_each_field<vector::Figures>(
        [&](const auto& field) { figures[field.name] = drawing.figures.*field.member; });
    return figures;
}

}  // namespace

void bind_vector(py::module_& m) {
    bind_record<vector::Options>(m, "VectorOptions",
                                 "What a drawing is like as vectors; see native/fovea/vector/options.h.");
    m.attr("SHEETS") = choices<vector::Sheet>();
    m.attr("WIDTHS") = choices<vector::Widths>();
    py::class_<vector::Drawing, std::shared_ptr<vector::Drawing>>(m, "Drawing",
                                                                  "A frame's strokes as layers of curves.")
        .def(py::init([](Frame& frame, const vector::Options& options) {
                 return std::make_shared<vector::Drawing>(vector::compose(frame, options));
             }),
             NoGil(), py::arg("frame"), py::arg("options"), "Takes the frame's steps up to `ink`.")
        .def_property_readonly("figures", &figures_of, "{what there is: how much}")
        .def(
            "svg",
            [](const vector::Drawing& drawing) {
                return py::bytes(without_gil([&] { return vector::svg_bytes(drawing.document); }));
            },
            "The bytes of an SVG file.");
}

}  // namespace fovea::bindings
