// SPDX-License-Identifier: GPL-3.0-or-later
// Line definitions and paths.
#include <pybind11/stl.h>

#include <fovea/path/extract.h>
#include <fovea/style/line_set.h>

#include "bindings/arrays.h"
#include "bindings/bind.h"
#include "bindings/line_filters.h"
#include "bindings/records.h"

namespace fovea::bindings {
namespace {

const char* scope_name(Scope scope) {
    return scope == Scope::surface ? "surface" : scope == Scope::view ? "view" : "scene";
}

const char* unit_name(Unit unit) {
    switch (unit) {
        case Unit::degrees:
            return "degrees";
        case Unit::pixels:
            return "pixels";
        case Unit::boolean:
            return "bool";
        case Unit::none:
            break;
    }
    return "";
}

py::list parameters_of(const LineDefinition& definition) {
    py::list parameters;
    for (const Parameter& p : definition.parameters)
        parameters.append(py::dict(py::arg("name") = p.name, py::arg("label") = p.label, py::arg("default") = p.value,
                                   py::arg("min") = p.low, py::arg("max") = p.high, py::arg("unit") = unit_name(p.unit),
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

py::list definitions() {
    py::list result;
    for (const LineDefinition* definition : line_definitions()) {
        const LineDefinition* twin = definition->smooth_twin;
        result.append(py::dict(
            py::arg("name") = definition->name, py::arg("label") = definition->label,
            py::arg("scope") = scope_name(definition->scope), py::arg("source") = definition->source,
            py::arg("description") = definition->description, py::arg("parameters") = parameters_of(*definition),
            py::arg("in_image") = std::holds_alternative<ImageRule>(definition->rule),
            py::arg("view_dependent") = definition->scope >= Scope::view,
            py::arg("importance") = definition->importance, py::arg("slow") = definition->slow,
            py::arg("stand_ins") = stand_ins_of(*definition), py::arg("smooth_twin") = twin ? twin->name : nullptr,
            py::arg("reads_edge_marks") = definition->reads_edge_marks));
    }
    return result;
}

/// {definition: {parameter: value}} with defaults filled in.
LineSet line_set(const py::dict& kinds, double corner_angle_degrees) {
    LineSet set;
    set.corner_angle_rad = glm::radians(corner_angle_degrees);
    for (const auto& [name, given] : kinds) {
        LineKind kind;
        kind.definition = definition_index(name.cast<std::string>());
        const LineDefinition& definition = *line_definitions()[kind.definition];
        kind.values = values_of(definition, Member<style::Parameters>::from(given));
        set.kinds.push_back(std::move(kind));
    }
    return set;
}

std::vector<LineSet> line_sets(const py::sequence& sets) {
    std::vector<LineSet> result;
    for (const auto& item : sets) {
        const auto pair = item.cast<py::tuple>();
        result.push_back(line_set(pair[0].cast<py::dict>(), pair[1].cast<double>()));
        if (pair.size() > 2 && !pair[2].is_none()) result.back().placements = numbers<std::uint8_t>(pair[2]);
        if (pair.size() > 3) result.back().materials = material_filter(pair[3]);
    }
    return result;
}

}  // namespace

MaterialFilter material_filter(const py::handle& given) {
    MaterialFilter filter;
    if (given.is_none()) return filter;
    const auto pair = given.cast<py::tuple>();
    filter.row = numbers<Index>(pair[0]);
    for (const auto& mask : pair[1].cast<py::sequence>()) filter.masks.push_back(numbers<std::uint8_t>(mask));
    return filter;
}

std::vector<OwnLines::Parameter> own_parameters(const py::dict& given) {
    std::vector<OwnLines::Parameter> result;
    for (const auto& [name, values] : given) {
        const Index definition = definition_index(name.cast<std::string>());
        const std::vector<Parameter>& known = line_definitions()[definition]->parameters;
        for (const auto& [parameter, of_placements] : values.cast<py::dict>()) {
            const auto called = parameter.cast<std::string>();
            const auto is_it = [&](const Parameter& p) { return p.name == called; };
            const auto it = std::find_if(known.begin(), known.end(), is_it);
            check(it != known.end(), name.cast<std::string>() + ": unknown parameter '" + called + "'");
            result.push_back({definition, static_cast<Index>(it - known.begin()), numbers<double>(of_placements)});
        }
    }
    return result;
}

void bind_line(py::module_& m) {
    m.def("line_definitions", &definitions,
          "The registry: one dict per definition, in the order of its bits, with its parameters.");

    py::class_<Paths, std::shared_ptr<Paths>> paths(m, "Paths",
                                                    "Segments chained into paths, in object space; N points, P paths.");
    paths
        .def_property_readonly(
            "offsets", [](py::object self) { return view_numpy(self.cast<const Paths&>().rows.offsets, self); },
            "(P + 1,) uint32: points of path p are offsets[p] .. offsets[p + 1]")
        .def("__len__", &Paths::count);
    bind_columns(paths, Paths::path_columns);
    bind_columns(paths, Paths::point_columns);

    m.def(
        "extract_paths",
        [](const Tracer& tracer, const py::sequence& sets, const Cancel* cancel, const py::object& shown,
           const py::dict& parameters, const py::object& materials) {
            const std::vector<LineSet> parsed = line_sets(sets);
            const std::vector<Kinds> kinds = shown.is_none() ? std::vector<Kinds>() : numbers<Kinds>(shown);
            const OwnLines own{kinds, own_parameters(parameters), material_filter(materials)};
            const Cancel never;
            py::gil_scoped_release release;
            return std::make_shared<Paths>(
                extract_paths(tracer.scene(), tracer.view(), parsed, tracer, cancel ? *cancel : never, own));
        },
        py::arg("tracer"), py::arg("line_sets"), py::arg("cancel") = py::none(), py::kw_only(),
        py::arg("shown") = py::none(), py::arg("parameters") = py::dict(), py::arg("materials") = py::none(),
        R"(Paths of everything the line sets find. line_sets: list of ({definition: {parameter: value}},
corner angle in degrees[, for each placement whether its lines are for the set; None: all[, materials whose lines are
for the set]]); an edge belongs to the first set that finds it, and to a material if a face beside it has that. Of all
sets: shown: (n,) uint32 registry bits of what each of n placements shows, None: all; parameters: {definition:
{parameter: (n,) float64 that placements have instead, NaN: none}}; materials: those that have lines at all. Materials
are a pair: (n,) uint32 mask of each placement, and a list of masks, uint8 by the material's number, 0: it has no lines;
None: all have.)");
}

}  // namespace fovea::bindings
