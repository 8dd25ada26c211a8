// SPDX-License-Identifier: GPL-3.0-or-later
// Fields of surfaces, and pieces of curves traced by one line definition, for research and benchmarks.
#include <fovea/field/fields.h>
#include <fovea/line/registry.h>
#include <fovea/style/line_set.h>

#include "bindings/arrays.h"
#include "bindings/bind.h"
#include "bindings/records.h"
#include "bindings/words.h"

namespace fovea::bindings {
namespace {

template <typename T, typename Value>
Numpy<T> per_element(std::size_t count, const Value& value) {
    Array<T> column(count);
    for (std::size_t i = 0; i < count; ++i) column[i] = value(i);
    return to_numpy(std::move(column));
}

/// Getter of one member of the curvature at every vertex.
template <typename T>
auto curvature(T Curvature::* member) {
    return [member](const Fields& fields) {
        return per_element<T>(fields.curvature.size(), [&](std::size_t v) { return fields.curvature[v].*member; });
    };
}

struct Pieces {
    Curves curves;
};

/// Getter of one value per piece.
template <typename T, typename Value>
auto column(const Value& value) {
    return [value](const Pieces& p) {
        return per_element<T>(p.curves.size(), [&](std::size_t i) { return value(p.curves[i]); });
    };
}

std::shared_ptr<Fields> fields(const Surface& surface, const py::str& estimator, int degree, int rings) {
    const std::string name = surface.name() + ": estimator";
    const FieldOptions options{.estimator = value_from<Estimator>(estimator, name), .degree = degree, .rings = rings};
    return std::const_pointer_cast<Fields>(without_gil([&] { return fields_of(surface, options); }));
}

Pieces find_curves(const Surface& surface, const std::string& name, const std::map<std::string, double>& given,
                   const dvec3& eye, bool orthographic) {
    const LineDefinition& definition = definition_called(name);
    const auto* rule = std::get_if<CurveRule>(&definition.rule);
    check(rule && definition.scope != Scope::scene, name + " is no line across triangles of a surface");
    const Values values = values_of(definition, style::Parameters(given.begin(), given.end()));
    SurfaceView seen{.surface = surface};
    seen.eye_obj = eye;
    seen.orthographic = orthographic;
    return without_gil([&] { return Pieces{rule->find(seen, values)}; });
}

}  // namespace

void bind_fields(py::module_& m, SurfaceClass& surface) {
    py::class_<Fields, std::shared_ptr<Fields>>(m, "Fields", "Curvature at the V vertices of a surface.")
        .def_property_readonly("normal", curvature(&Curvature::normal), "(V, 3) float32")
        .def_property_readonly("k1", curvature(&Curvature::k1), "(V,) float32 per object unit, |k1| >= |k2|")
        .def_property_readonly("k2", curvature(&Curvature::k2), "(V,) float32")
        .def_readonly("feature_size", &Fields::feature_size, "the length that thresholds are relative to")
        .def_readonly("reason", &Fields::reason, "which estimator was taken, and why");
    py::class_<Pieces>(m, "Curves", "P pieces of curves in triangles, before they are chained.")
        .def("__len__", [](const Pieces& p) { return p.curves.size(); })
        .def_property_readonly("triangle", column<Index>([](const CurvePiece& p) { return p.triangle; }), "(P,) uint32")
        .def_property_readonly("start", column<vec3>([](const CurvePiece& p) { return p.point[0]; }),
                               "(P, 3) float32, object space")
        .def_property_readonly("end", column<vec3>([](const CurvePiece& p) { return p.point[1]; }),
                               "(P, 3) float32, object space");

    surface.def(
        "fields", &fields, py::arg("estimator") = "automatic", py::arg("degree") = 0, py::arg("rings") = 0,
        R"(Fields by an estimator: automatic, jets, one_ring; degree and rings of jets, 0: automatic. Kept with the
surface.)");
    surface.def(
        "find_curves", &find_curves, py::arg("definition"), py::arg("parameters") = std::map<std::string, double>(),
        py::arg("eye") = dvec3(0, 0, 1), py::arg("orthographic") = true,
        R"(Curves that a definition finds across the triangles of this surface alone. eye: in object space; for an
orthographic view the direction towards the viewer.)");
}

}  // namespace fovea::bindings
