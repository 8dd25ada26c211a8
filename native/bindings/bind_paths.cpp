// SPDX-License-Identifier: GPL-3.0-or-later
// The registry of line definitions, and stages of lines: paths, clipped paths, runs, polylines.
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

/// A definition's file; None: it is given none.
py::object file_of(const LineDefinition& definition) {
    if (!definition.file) return py::none();
    return py::dict(py::arg("name") = definition.file->name, py::arg("label") = definition.file->label,
                    py::arg("suffix") = definition.file->suffix, py::arg("meaning") = definition.file->meaning);
}

/// {definition: {parameter: value}} that replace a definition in drafts.
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
            py::arg("file") = file_of(*definition),
            py::arg("in_image") = std::holds_alternative<ImageRule>(definition->rule),
            py::arg("view_dependent") = definition->scope >= Scope::view,
            py::arg("importance") = definition->importance, py::arg("slow") = definition->slow,
            py::arg("stand_ins") = stand_ins_of(*definition), py::arg("smooth_twin") = twin ? twin->name : nullptr,
            py::arg("reads_edge_marks") = definition->reads_edge_marks, py::arg("usual") = definition->usual,
            py::arg("of_smooth") = definition->of_smooth));
    }
    return result;
}

}  // namespace

void bind_paths(py::module_& m) {
    m.def("line_definitions", &definitions,
          "The registry: one dict per definition, in the order of its bits, with its parameters.");
    py::class_<FileContent, std::shared_ptr<FileContent>>(m, "FileContent",
                                                          "What a file says that a line definition is given.");

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
            "samples", [](const Runs& runs, const ClippedPaths& clipped) { return samples_from_runs(clipped, runs); },
            py::arg("clipped"), "(samples,) float32 share of each atlas sample that visible runs cover.");
    bind_columns(runs, Runs::columns);

    py::class_<Polylines> polylines(m, "Polylines",
                                    "A frame's lines: R runs as polylines of M points in all, in path order.");
    polylines.def("__len__", [](const Polylines& lines) { return lines.path.size(); })
        .def_property_readonly("offsets", viewing_rows<Polylines>(&Polylines::rows),
                               "(R + 1,) uint32: points of run r are offsets[r] .. offsets[r + 1]");
    bind_columns(polylines, CompactRuns::run_columns);
    bind_columns(polylines, Polylines::pen_columns);
    bind_columns(polylines, CompactRuns::point_columns);
}

}  // namespace fovea::bindings
