// SPDX-License-Identifier: GPL-3.0-or-later
// The registry of line definitions, and lines on their way: paths, clipped paths, runs, polylines.
#include <pybind11/stl.h>
#include <pybind11/typing.h>

#include <fovea/draw/polylines.h>

#include "bindings/arrays.h"
#include "bindings/bind.h"
#include "bindings/records.h"
#include "bindings/words.h"

namespace fovea::bindings {
namespace {

py::list parameters_of(const LineDefinition& definition) {
    py::list parameters;
    for (const Parameter& p : definition.parameters)
        parameters.append(py::dict(py::arg("name") = p.name, py::arg("label") = p.label, py::arg("default") = p.value,
                                   py::arg("min") = p.low, py::arg("max") = p.high, py::arg("unit") = value_to(p.unit),
                                   py::arg("meaning") = p.meaning, py::arg("per_object") = p.per == Per::object));
    return parameters;
}

/// {definition: {parameter: value}} that drafts draw instead.
py::dict stand_ins_of(const LineDefinition& definition) {
    py::dict result;
    for (const StandIn& stand_in : definition.stand_ins) {
        py::dict values;
        for (const auto& [name, value] : stand_in.values) values[name] = value;
        result[stand_in.definition->name] = values;
    }
    return result;
}

py::typing::List<py::typing::Dict<std::string, py::object>> definitions() {
    py::list result;
    for (const LineDefinition* definition : line_definitions()) {
        const LineDefinition* twin = definition->smooth_twin;
        result.append(py::dict(
            py::arg("name") = definition->name, py::arg("label") = definition->label,
            py::arg("scope") = value_to(definition->scope), py::arg("source") = definition->source,
            py::arg("description") = definition->description, py::arg("parameters") = parameters_of(*definition),
            py::arg("in_image") = std::holds_alternative<ImageRule>(definition->rule),
            py::arg("view_dependent") = definition->scope >= Scope::view,
            py::arg("importance") = definition->importance, py::arg("slow") = definition->slow,
            py::arg("stand_ins") = stand_ins_of(*definition), py::arg("smooth_twin") = twin ? twin->name : nullptr,
            py::arg("reads_edge_marks") = definition->reads_edge_marks));
    }
    return result;
}

/// Rows of an owner's flat arrays.
template <typename Owner, typename Structure>
auto viewing_rows(Rows Structure::* rows) {
    return [rows](py::object self) { return view_numpy((self.cast<const Owner&>().*rows).offsets, self); };
}

void bind_polylines(py::module_& m) {
    using P = Polylines;
    py::class_<P>(m, "Polylines", "A frame's lines: R runs as polylines of M points in all, in path order.")
        .def("__len__", [](const P& lines) { return lines.path.size(); })
        .def_property_readonly("offsets", viewing_rows<P>(&P::rows),
                               "(R + 1,) uint32: points of run r are offsets[r] .. offsets[r + 1]")
        .def_property_readonly("path_id", viewing<P>(&P::path_id), "(R,) uint64 persistent id of the path")
        .def_property_readonly("path", viewing<P>(&P::path), "(R,) uint32 path of Paths")
        .def_property_readonly("piece", viewing<P>(&P::piece), "(R,) uint32 piece of ClippedPaths")
        .def_property_readonly("start_px", viewing<P>(&P::start_px),
                               "(R,) float64 arc length in pixels, 0 at the path's middle")
        .def_property_readonly("end_px", viewing<P>(&P::end_px), "(R,) float64")
        .def_property_readonly("invisibility", viewing<P>(&P::invisibility),
                               "(R,) uint8 surfaces that hide it; 0: visible")
        .def_property_readonly("line_set", viewing<P>(&P::line_set), "(R,) uint8")
        .def_property_readonly("closed", viewing<P>(&P::closed),
                               "(R,) uint8, 1: all of a closed path; the last point is the first again")
        .def_property_readonly("pen", viewing<P>(&P::pen), "(R,) uint32 of the style's pens; 0xffffffff: none")
        .def_property_readonly("shown", viewing<P>(&P::shown), "(R,) float32 in [0, 1] that elision leaves")
        .def_property_readonly("px", viewing<P>(&P::px), "(M, 2) float32 pixels, from the lower left corner, y up")
        .def_property_readonly("position_view", viewing<P>(&P::position_view),
                               "(M, 3) float32 view space: the eye at 0, looking along -z")
        .def_property_readonly("arc_px", viewing<P>(&P::arc_px), "(M,) float64 arc length in pixels")
        .def_property_readonly("strength", viewing<P>(&P::strength), "(M,) float32 in [0, 1]")
        .def_property_readonly("kinds", viewing<P>(&P::kinds),
                               "(M,) uint32 bits of what the segment from the point is; see line_definitions()");
}

}  // namespace

void bind_paths(py::module_& m) {
    m.def("line_definitions", &definitions,
          "The registry: one dict per definition, in the order of its bits, with its parameters.");

    py::class_<Paths, std::shared_ptr<Paths>> paths(m, "Paths",
                                                    "Segments chained into paths, in object space; N points, P paths.");
    paths.def("__len__", &Paths::count)
        .def_property_readonly("offsets", viewing_rows<Paths>(&Paths::rows),
                               "(P + 1,) uint32: points of path p are offsets[p] .. offsets[p + 1]");
    bind_columns(paths, Paths::path_columns);
    bind_columns(paths, Paths::point_columns);

    py::class_<ClippedPaths, std::shared_ptr<ClippedPaths>> clipped(
        m, "ClippedPaths",
        "Paths projected and clipped: Q pieces, M points; see native/fovea/project/clipped_paths.h.");
    clipped.def("__len__", [](const ClippedPaths& c) { return c.path.size(); })
        .def_property_readonly("offsets", viewing_rows<ClippedPaths>(&ClippedPaths::pieces),
                               "(Q + 1,) uint32: points of piece q")
        .def_readonly("samples", &ClippedPaths::samples, "size of the atlas");
    bind_columns(clipped, ClippedPaths::piece_columns);
    bind_columns(clipped, ClippedPaths::point_columns);

    py::class_<Runs, std::shared_ptr<Runs>> runs(
        m, "Runs", "Parts of pieces, sorted by piece, then by start; see native/fovea/visibility/runs.h.");
    runs.def("__len__", [](const Runs& runs) { return runs.piece.size(); })
        .def(
            "samples",
            [](const Runs& runs, const ClippedPaths& clipped) { return to_numpy(samples_from_runs(clipped, runs)); },
            py::arg("clipped"), "(samples,) float32 share of each atlas sample that visible runs cover.");
    bind_columns(runs, Runs::columns);
    bind_polylines(m);
}

}  // namespace fovea::bindings
