// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings/overrides.h"
#include "bindings/records.h"

namespace fovea::bindings {
namespace {

/// A flat array of numbers, copied.
template <typename T>
std::vector<T> numbers(const Arg<T>& given, const char* name) {
    const In<T> values = borrow<T>(given, name);
    return {values.begin(), values.end()};
}

/// Per-placement values of a definition's parameters, by the parameter's name.
using ByParameter = std::map<std::string, Arg<double>>;

void add_parameters(OwnLines& lines, const std::string& name, const ByParameter& given) {
    const Index definition = definition_index(name);
    const std::vector<Parameter>& known = line_definitions()[definition]->parameters;
    for (const auto& [called, of_placements] : given) {
        const auto it = std::ranges::find_if(known, [&](const Parameter& p) { return p.name == called; });
        check(it != known.end(), name + ": unknown parameter '" + called + "'");
        lines.parameters.push_back(
            {definition, static_cast<Index>(it - known.begin()), numbers<double>(of_placements, called.c_str())});
    }
}

/// Arrays of all placements, by the source and the name of what is painted.
template <typename T>
using ByPaint = std::map<std::pair<std::string, std::string>, std::vector<Optional<T>>>;

template <typename T>
void add_painted(std::map<style::Paint, std::vector<In<T>>>& painted, const ByPaint<T>& given,
                 std::vector<py::object>& owners) {
    for (const auto& [paint, arrays] : given) {
        const style::Paint known{value_from<style::PaintSource>(py::str(paint.first), "painted: source"), paint.second};
        for (const auto& array : arrays) painted[known].push_back(kept<T>(array, "painted", owners));
    }
}

OwningOverrides make_overrides(const Optional<float>& importance, const ByPaint<float>& painted,
                               const ByPaint<vec3>& painted_colors, std::vector<std::vector<std::string>> objects,
                               std::vector<std::string> names, const Optional<Index>& of_placement,
                               std::shared_ptr<ColorTexture> density_map,
                               const std::vector<Optional<std::uint8_t>>& placements,
                               const std::vector<std::optional<MaterialFilter>>& materials,
                               const Optional<Kinds>& shown, const std::map<std::string, ByParameter>& parameters,
                               const std::optional<MaterialFilter>& lined) {
    OwningOverrides made;
    Overrides& overrides = made.overrides;
    overrides.importance = kept<float>(importance, "importance", made.owners);
    add_painted(overrides.painted, painted, made.owners);
    add_painted(overrides.painted_colors, painted_colors, made.owners);
    check(names.empty() || names.size() == objects.size(), "names: one per entry of `objects` expected");
    overrides.objects = std::move(objects);
    overrides.names = std::move(names);
    overrides.objects_of_placement = kept<Index>(of_placement, "objects_of_placement", made.owners);
    for (const Index i : overrides.objects_of_placement)
        check(i < overrides.objects.size(), "objects_of_placement: numbers of `objects` expected");
    overrides.density_map = std::move(density_map);
    if (shown) overrides.lines.kinds = numbers<Kinds>(*shown, "shown");
    for (const auto& [definition, given] : parameters) add_parameters(overrides.lines, definition, given);
    if (lined) overrides.lines.materials = *lined;
    overrides.line_sets.resize(std::max(placements.size(), materials.size()));
    for (std::size_t i = 0; i < placements.size(); ++i)
        if (const auto& given = placements[i])
            overrides.line_sets[i].placements = numbers<std::uint8_t>(*given, "placements");
    for (std::size_t i = 0; i < materials.size(); ++i)
        if (const auto& given = materials[i]) overrides.line_sets[i].materials = *given;
    return made;
}

}  // namespace

void bind_overrides(py::module_& m) {
    py::class_<MaterialFilter>(m, "MaterialFilter", "Materials that have lines, by their number on a surface.")
        .def(py::init([](const Arg<Index>& mask_of_placement, const std::vector<Arg<std::uint8_t>>& masks) {
                 MaterialFilter filter{numbers<Index>(mask_of_placement, "mask_of_placement"), {}};
                 for (const auto& mask : masks) filter.masks.push_back(numbers<std::uint8_t>(mask, "masks"));
                 return filter;
             }),
             py::arg("mask_of_placement"), py::arg("masks"),
             "mask_of_placement (n,) uint32; masks: uint8 by the material's number, 0: its faces have no lines.");
    py::class_<OwningOverrides>(m, "Overrides", "What an artist has said of a scene's n placements.")
        .def(
            py::init(&make_overrides), py::kw_only(), py::arg("importance") = py::none(),
            py::arg("painted") = py::dict(), py::arg("painted_colors") = py::dict(), py::arg("objects") = py::list(),
            py::arg("names") = py::list(), py::arg("objects_of_placement") = py::none(),
            py::arg("density_map") = py::none(), py::arg("placements") = py::list(), py::arg("materials") = py::list(),
            py::arg("shown") = py::none(), py::arg("parameters") = py::dict(), py::arg("lined") = py::none(),
            R"(importance: (n,) float32 in [0, 1]; painted: {(source of a pen's paint, name): n arrays (K,) float32 at the
mesh's K corners (its vertices if it has no faces), for K materials or, of objects, 1, or None}, painted_colors: the same
(K, 3); objects: lists of names, names: of each of these the object's own, for mattes, and objects_of_placement (n,)
uint32: the list of each; density_map: over the camera's
frame. By line set: placements (n,) uint8 whose lines are for it, and materials whose faces' lines are, None: all. Of all
sets: shown (n,) uint32 registry bits of what each placement shows, parameters {definition: {parameter: (n,) float64 that
placements have instead, NaN: none}}, and lined: the materials that have lines at all.)");
}

}  // namespace fovea::bindings
