// SPDX-License-Identifier: GPL-3.0-or-later
// Fields of surfaces, and the pieces of curves that one definition finds: what research and benchmarks ask for.
#include <array>
#include <pybind11/stl.h>

#include <fovea/field/fields.h>
#include <fovea/line/registry.h>
#include <fovea/style/line_set.h>

#include "bindings/arrays.h"
#include "bindings/bind.h"
#include "bindings/records.h"

namespace fovea::bindings {
namespace {

FieldOptions options(const std::string& estimator, int degree, int rings) {
    static const std::pair<const char*, Estimator> known[] = {
        {"automatic", Estimator::automatic}, {"jets", Estimator::jets}, {"one_ring", Estimator::one_ring}};
    for (const auto& [name, value] : known)
        if (estimator == name) return {.estimator = value, .degree = degree, .rings = rings};
    check(false, "fields: no estimator is called '" + estimator + "'; there are: automatic, jets, one_ring");
    return {};
}

template <typename T, typename Value>
py::array per_element(std::size_t count, const Value& value) {
    Array<T> column(count);
    for (std::size_t i = 0; i < count; ++i) column[i] = value(i);
    return to_numpy(std::move(column));
}

py::dict fields(const Surface& surface, const std::string& estimator, int degree, int rings) {
    std::shared_ptr<const Fields> found;
    {
        py::gil_scoped_release release;
        found = fields_of(surface, options(estimator, degree, rings));
    }
    const Array<Curvature>& all = found->curvature;
    py::dict result;
    result["feature_size"] = found->feature_size;
    result["reason"] = found->reason;
    result["normal"] = per_element<vec3>(all.size(), [&](std::size_t v) { return all[v].normal; });
    result["k1"] = per_element<float>(all.size(), [&](std::size_t v) { return all[v].k1; });
    result["k2"] = per_element<float>(all.size(), [&](std::size_t v) { return all[v].k2; });
    return result;
}

struct Pieces {
    Curves curves;
};

/// One value of every piece.
template <typename T, typename Value>
auto column(const Value& value) {
    return [value](const Pieces& p) {
        return per_element<T>(p.curves.size(), [&](std::size_t i) { return value(p.curves[i]); });
    };
}

Pieces find_curves(const Surface& surface, const std::string& name, const py::dict& given,
                   const std::array<double, 3>& eye, bool orthographic) {
    const LineDefinition& definition = definition_called(name);
    const auto* rule = std::get_if<CurveRule>(&definition.rule);
    check(rule && definition.scope != Scope::scene, name + " is no line across triangles of a surface");
    const Values values = values_of(definition, Member<style::Parameters>::from(given));
    py::gil_scoped_release release;
    SurfaceView seen{.surface = surface};
    seen.eye_obj = {eye[0], eye[1], eye[2]};
    seen.orthographic = orthographic;
    return {rule->find(seen, values)};
}

}  // namespace

void bind_field(py::module_& m) {
    m.def("fields", &fields, py::arg("surface"), py::arg("estimator") = "automatic", py::arg("degree") = 0,
          py::arg("rings") = 0,
          R"(Curvature at the vertices, kept with the surface: feature_size, reason (which estimator was taken and why),
normal (V, 3), k1, k2 (V,) float32, |k1| >= |k2|. estimator: automatic, jets, one_ring; degree and rings of jets, 0 for
automatic.)");

    py::class_<Pieces>(m, "Curves", "Pieces of curves in triangles, before they are chained.")
        .def("__len__", [](const Pieces& p) { return p.curves.size(); })
        .def_property_readonly("triangle", column<Index>([](const CurvePiece& p) { return p.triangle; }), "(P,) uint32")
        .def_property_readonly("start", column<vec3>([](const CurvePiece& p) { return p.point[0]; }),
                               "(P, 3) float32, object space")
        .def_property_readonly("end", column<vec3>([](const CurvePiece& p) { return p.point[1]; }),
                               "(P, 3) float32, object space");

    m.def(
        "find_curves", &find_curves, py::arg("surface"), py::arg("definition"), py::arg("parameters") = py::dict(),
        py::arg("eye") = std::array<double, 3>{0, 0, 1}, py::arg("orthographic") = true,
        R"(What a definition finds across the triangles of a surface alone, before chaining. eye: in object space; for an
orthographic view the direction towards the viewer.)");
}

}  // namespace fovea::bindings
