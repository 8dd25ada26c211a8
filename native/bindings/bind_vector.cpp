// SPDX-License-Identifier: GPL-3.0-or-later
// Frames as files of other programs: vectors, layers, and pictures of black and white alone.
#include <algorithm>

#include <fovea/color/screentone.h>
#include <fovea/draw/layered.h>
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

py::dict layered_picture(Frame& frame) {
    const LayeredPicture made = without_gil([&] { return layered(frame); });
    py::list layers;
    for (const PictureLayer& layer : made.layers)
        layers.append(py::make_tuple(layer.group, layer.name, py::bytes(layer.png)));
    return py::dict(py::arg("layers") = layers, py::arg("merged") = py::bytes(made.merged),
                    py::arg("thumbnail") = py::bytes(made.thumbnail));
}

Numpy<std::uint8_t> one_bit(Frame& frame, const Screen& screen) {
    const View& view = frame.job.view;
    const Array<std::uint8_t> bits = without_gil([&] {
        frame.picture();
        return screentone(frame.passes.lines, frame.ground(), frame.job.style.paper.color, view.width, screen);
    });
    return Numpy<std::uint8_t>({view.height, view.width}, bits.data());
}

}  // namespace

void bind_center_lines(py::module_& m) {
    using vector::CenterLines;
    py::class_<CenterLines> lines(m, "CenterLines",
                                  "A frame's strokes as R polylines of M points in all, with what their pens make of "
                                  "them; takes the frame's steps up to `shape`.");
    lines.def(py::init(&vector::center_lines_of), NoGil(), py::arg("frame"))
        .def("__len__", [](const CenterLines& lines) { return lines.pen.size(); })
        .def_property_readonly("offsets", viewing_rows<CenterLines>(&CenterLines::rows),
                               "(R + 1,) uint32: points of line i are offsets[i] .. offsets[i + 1]");
    bind_columns(lines, CenterLines::line_columns);
    bind_columns(lines, CenterLines::point_columns);
}

void bind_vector(py::module_& m) {
    bind_center_lines(m);
    bind_part<vector::Titles>(m, "Titles", "What a title block says; see native/fovea/vector/titles.h.");
    bind_part<vector::Options>(m, "VectorOptions",
                               "What a drawing is like as vectors; see native/fovea/vector/options.h.");
    m.attr("SHEETS") = choices<vector::Sheet>();
    m.attr("WIDTHS") = choices<vector::Widths>();
    m.attr("VECTORS") = choices<vector::Kind>();
    m.def(
        "sheet_size",
        [](const py::str& sheet) {
            const dvec2 size = vector::sheet_size(value_from<vector::Sheet>(sheet, "sheet"));
            return py::dict(py::arg("width") = size.x, py::arg("height") = size.y);
        },
        py::arg("sheet"), "{width, height} of an upright sheet of paper [mm]; 0: that of the picture.");
    m.def(
        "room_on_sheet",
        [](const vector::Options& options, bool upright) {
            dvec2 size = vector::sheet_size(options.sheet);
            if (!upright) std::swap(size.x, size.y);
            const auto rooms = vector::rooms_of(size, options);
            const dvec2 room = std::ranges::max_element(rooms, {}, [](const vector::Room& room) {
                                   return room.size.x * room.size.y;
                               })->size;
            return py::dict(py::arg("width") = room.x, py::arg("height") = room.y);
        },
        py::arg("options"), py::arg("upright"),
        "{width, height} of the largest picture within the margins of a sheet, without its title block [mm].");
    py::class_<KindOfDrawing, std::shared_ptr<KindOfDrawing>>(m, "Drawing", "A frame's strokes as layers of curves.")
        .def(py::init(&compose), py::arg("frame"), py::arg("options"), py::arg("kind") = "svg",
             "Takes the frame's steps up to `shape`; kind: of files, svg, pdf or dxf.")
        .def_property_readonly("figures", &figures_of, "{what there is: how much}")
        .def("file", &bytes_of, "The bytes of a file.");
    m.def("layered_picture", &layered_picture, py::arg("frame"),
          "{layers: [(line set or '', name, PNG of a layer) from below], merged: PNG of the picture, thumbnail: PNG}; "
          "takes all steps of the frame.");
    bind_part<Screen>(m, "Screen", "How a picture becomes black and white; see native/fovea/color/screentone.h.")
        .def("page_height", &page_height, py::arg("height_mm"), "Height in pixels of a page.");
    m.def("one_bit", &one_bit, py::arg("frame"), py::arg("screen"),
          "(H, W) uint8, bottom row first: 1 is white, 0 black; takes all steps of the frame.");
}

}  // namespace fovea::bindings
