// SPDX-License-Identifier: GPL-3.0-or-later
// Frames as vectors.
#include <fovea/vector/center_lines.h>
#include <fovea/vector/compose.h>
#include <fovea/vector/file.h>
#include <fovea/vector/page.h>

#include "bindings/bind.h"
#include "bindings/records.h"

namespace fovea::bindings {
namespace {

/// A drawing for files of a kind.
struct KindOfDrawing : vector::Drawing {
    vector::Kind kind;
};

std::shared_ptr<KindOfDrawing> compose(Frame& frame, const vector::Options& options, const py::str& kind) {
    const auto of = value_from<vector::Kind>(kind, "kind");
    return without_gil([&] {
        return std::make_shared<KindOfDrawing>(KindOfDrawing{vector::compose(frame, vector::fitting(of, options)), of});
    });
}

py::dict figures_of(const KindOfDrawing& drawing) {
    py::dict figures;
    drawing.for_each_figure([&](const char* name, auto number) { figures[name] = number; });
    return figures;
}

py::bytes bytes_of(const KindOfDrawing& drawing) {
    return without_gil([&] { return vector::bytes_of(drawing.document, drawing.kind); });
}

}  // namespace

void bind_center_lines(py::module_& m) {
    using vector::CenterLines;
    py::class_<CenterLines> lines(m, "CenterLines",
                                  "A frame's strokes as R polylines of M points in all, with what their pens make of "
                                  "them; takes the frame's steps up to `ink`.");
    lines.def(py::init(&vector::center_lines_of), NoGil(), py::arg("frame"))
        .def("__len__", [](const CenterLines& lines) { return lines.pen.size(); })
        .def_property_readonly("offsets", viewing_rows<CenterLines>(&CenterLines::rows),
                               "(R + 1,) uint32: points of line i are offsets[i] .. offsets[i + 1]");
    bind_columns(lines, CenterLines::line_columns);
    bind_columns(lines, CenterLines::point_columns);
}

void bind_vector(py::module_& m) {
    bind_center_lines(m);
    bind_record<vector::Options>(m, "VectorOptions",
                                 "What a drawing is like as vectors; see native/fovea/vector/options.h.");
    m.attr("SHEETS") = choices<vector::Sheet>();
    m.attr("WIDTHS") = choices<vector::Widths>();
    m.attr("VECTORS") = choices<vector::Kind>();
    m.def(
        "sheet_size",
        [](const py::str& sheet) {
            const dvec2 size = vector::sheet_size(value_from<vector::Sheet>(sheet, "sheet"));
            return py::make_tuple(size.x, size.y);
        },
        py::arg("sheet"), "Width and height of an upright sheet of paper in millimeters.");
    py::class_<KindOfDrawing, std::shared_ptr<KindOfDrawing>>(m, "Drawing", "A frame's strokes as layers of curves.")
        .def(py::init(&compose), py::arg("frame"), py::arg("options"), py::arg("kind") = "svg",
             "Takes the frame's steps up to `ink`; kind: of files, svg, pdf or dxf.")
        .def_property_readonly("figures", &figures_of, "{what there is: how much}")
        .def("file", &bytes_of, "The bytes of a file.");
}

}  // namespace fovea::bindings
