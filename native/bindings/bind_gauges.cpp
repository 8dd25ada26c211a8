// SPDX-License-Identifier: GPL-3.0-or-later
// Gauges on pictures, and the reliefs that people see.
#include <cmath>

#include <fovea/study/bas_relief.h>
#include <fovea/study/gauges.h>

#include "bindings/arrays.h"
#include "bindings/bind.h"

namespace fovea::bindings {
namespace {

using study::BasRelief;

BasRelief make_relief(double depth, const dvec2& slope) {
    check(depth > 0.0 && std::isfinite(depth + slope.x + slope.y), "a relief has a depth above 0, and a slope");
    return {depth, slope};
}

BasRelief relief_of(const Arg<dvec3>& normals, const Arg<dvec3>& onto) {
    const In<dvec3> from = borrow<dvec3>(normals, "normals"), to = borrow<dvec3>(onto, "onto");
    return without_gil([&] { return study::fitted_relief(from, to); });
}

Array<dvec3> normals_of(const BasRelief& relief, const Arg<dvec3>& normals) {
    const In<dvec3> from = borrow<dvec3>(normals, "normals");
    return parallel_map<dvec3>(from.size(), [&](std::size_t i) { return relief.of_normal(from[i]); });
}

study::GaugePlaces places_of(const Tracer& tracer, const Arg<dvec2>& px, double radius) {
    const In<dvec2> places = borrow<dvec2>(px, "px");
    return without_gil([&] { return study::gauge_places(tracer, places, radius); });
}

}  // namespace

void bind_gauges(py::module_& m) {
    py::class_<BasRelief> relief(m, "BasRelief", "A surface with its depth scaled and sheared along the view.");
    relief.attr("least_depth") = study::least_depth;
    relief.attr("most_depth") = study::most_depth;
    relief.def(py::init(&make_relief), py::arg("depth") = 1.0, py::arg("slope") = dvec2(0.0))
        .def_static("fitted", &relief_of, py::arg("normals"), py::arg("onto"),
                    "The one that turns unit normals (n, 3) nearest to others, by the mean angle.")
        .def_readonly("depth", &BasRelief::depth)
        .def_readonly("slope", &BasRelief::slope)
        .def("of_normals", &normals_of, py::arg("normals"), "(n, 3) unit normals of the relief of (n, 3) of a surface.")
        .def("inverse", &BasRelief::inverse, "The one that undoes it.");
    py::class_<study::GaugePlaces> places(m, "GaugePlaces",
                                          "What is seen at places of a picture; see native/fovea/study/gauges.h.");
    bind_columns(places, study::GaugePlaces::columns);
    places.def_static("of", &places_of, py::arg("tracer"), py::arg("px"), py::arg("radius"),
                      "Of what a Tracer sees at (n, 2) pixels from the lower left; radius [px]: all within it is to be "
                      "one surface.");
}

}  // namespace fovea::bindings
