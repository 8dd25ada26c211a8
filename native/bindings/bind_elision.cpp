// SPDX-License-Identifier: GPL-3.0-or-later
// Priorities, ranks and line elision: the cpu reference, and what the gpu backend's passes read.
#include <pybind11/stl.h>

#include <fovea/draw/backend.h>
#include <fovea/elision/elide.h>
#include <fovea/elision/opacity.h>
#include <fovea/elision/priority.h>
#include <fovea/elision/rank.h>

#include "bindings/arrays.h"
#include "bindings/bind.h"

namespace fovea::bindings {
namespace {

std::shared_ptr<Elision> prepare(const ClippedPaths& clipped, const Runs& runs, const Arg<Index>& rank_of_run,
                                 const Arg<float>& half_width_px, float reach_px) {
    const auto ranks = borrow<Index>(rank_of_run, "ranks");
    const auto half_width = borrow<float>(half_width_px, "half_width_px");
    py::gil_scoped_release release;
    return std::make_shared<Elision>(elision_of(clipped, runs, ranks, half_width, reach_px));
}

py::array crowding_of(const Elision& elision, int width, int height, const Cancel* cancel) {
    Array<vec2> sums;
    {
        py::gil_scoped_release release;
        sums = crowding(elision.own, draw_priorities(elision.bands, width, height, cancel), cancel);
    }
    return to_numpy(std::move(sums));
}

py::array opacities_of(const Elision& elision, const ClippedPaths& clipped, const Arg<vec2>& crowding, float fade_from,
                       float cut, double stub_px) {
    const auto sums = borrow<vec2>(crowding, "crowding");
    Array<float> opacities;
    {
        py::gil_scoped_release release;
        opacities =
            elision_opacities(clipped, elision.own, elision_scores(elision.own, sums), {fade_from, cut, stub_px});
    }
    return to_numpy(std::move(opacities));
}

void bind_priority(py::module_& m) {
    const PriorityWeights weights;
    py::class_<PriorityWeights>(m, "PriorityWeights", "What each term of a line's priority counts for; 0: nothing.")
        .def(py::init([](double length, double kind, double strength, double depth, double object, double painted) {
                 return PriorityWeights{length, kind, strength, depth, object, painted};
             }),
             py::kw_only(), py::arg("length") = weights.length, py::arg("kind") = weights.kind,
             py::arg("strength") = weights.strength, py::arg("depth") = weights.depth,
             py::arg("object") = weights.object, py::arg("painted") = weights.painted)
        .def_readonly("length", &PriorityWeights::length)
        .def_readonly("kind", &PriorityWeights::kind)
        .def_readonly("strength", &PriorityWeights::strength)
        .def_readonly("depth", &PriorityWeights::depth)
        .def_readonly("object", &PriorityWeights::object)
        .def_readonly("painted", &PriorityWeights::painted);
    m.def(
        "path_priorities",
        [](const Paths& paths, const Scene& scene, const View& view, const PriorityWeights& weights,
           const std::optional<Arg<float>>& object, const std::optional<Arg<float>>& painted) {
            const auto of_object = borrow<float>(object, "object");
            const auto paint = borrow<float>(painted, "painted");
            Array<float> priorities;
            {
                py::gil_scoped_release release;
                priorities = path_priorities(paths, scene, view, weights, of_object, paint);
            }
            return to_numpy(std::move(priorities));
        },
        py::arg("paths"), py::arg("scene"), py::arg("view"), py::arg("weights") = weights,
        py::arg("object") = py::none(), py::arg("painted") = py::none(),
        R"((P,) float32 in [0, 1], the same for a scene of any size. object: per placement, None: .5; painted: per point
of Paths or per path, None: the term is left out.)");
    m.def(
        "rank_runs",
        [](const ClippedPaths& clipped, const Runs& runs, const Arg<float>& priority, const Arg<std::uint64_t>& ids) {
            return to_numpy(
                rank_runs(clipped, runs, borrow<float>(priority, "priority"), borrow<std::uint64_t>(ids, "ids")));
        },
        py::arg("clipped"), py::arg("runs"), py::arg("priority"), py::arg("ids"),
        "(R,) uint32 from 1: the higher goes before the lower; visible runs before hidden ones.");
}

}  // namespace

void bind_elision(py::module_& m) {
    bind_priority(m);
    m.attr("ELISION_COLUMNS") = window_columns;
    m.attr("ELISION_LENGTH_PX") = window_length_px;
    m.attr("ELISION_END_REACH") = end_reach;
    m.attr("ELISION_ROWS") = most_window_rows;
    const ElisionOptions options;
    const auto own = [](auto member) {
        return [member](py::object self) { return view_numpy(self.cast<const Elision&>().own.*member, self); };
    };
    const auto bands = [](auto member) {
        return [member](py::object self) { return view_numpy(self.cast<const Elision&>().bands.*member, self); };
    };
    py::class_<Elision, std::shared_ptr<Elision>>(
        m, "Elision", "Bands of runs, of V corners, and the D atlas samples that runs cover; see native/elision.")
        .def(py::init(&prepare), py::arg("clipped"), py::arg("runs"), py::arg("ranks"), py::arg("half_width_px"),
             py::arg("reach_px"),
             "ranks (R,) uint32 of rank_runs; half_width_px (samples,) float32, half the distance to others; reach_px: "
             "how far before its end a line hands over to one that goes on.")
        .def_property_readonly("place", own(&OwnBands::place), "(D, 4) float32: pixel position, direction")
        .def_property_readonly("band", own(&OwnBands::band),
                               "(D, 4) float32: half width, rank, pixels to the run's ends")
        .def_property_readonly("ends", own(&OwnBands::ends), "(D, 4) float32: where the run starts, and where it ends")
        .def_property_readonly(
            "reach_px", [](const Elision& elision) { return elision.own.reach_px; },
            "pixels from its end over which a band hands over to a line that goes on")
        .def_property_readonly("px", bands(&Bands::px), "(V, 2) float32")
        .def_property_readonly("across", bands(&Bands::across),
                               "(V, 3) float32: pixels across, half width, how near the end is")
        .def_property_readonly("owner", bands(&Bands::owner), "(V, 3) float32: unit vector across, rank")
        .def_property_readonly("triangles", bands(&Bands::triangles), "(T, 3) uint32, the highest rank first")
        .def("crowding", &crowding_of, py::arg("width"), py::arg("height"), py::arg("cancel") = py::none(),
             "(D, 2) float32: pixels of each sample's band that others take, pixels that it has.")
        .def("opacities", &opacities_of, py::arg("clipped"), py::arg("crowding"),
             py::arg("fade_from") = options.fade_from, py::arg("cut") = options.cut,
             py::arg("stub_px") = options.stub_px,
             "(samples,) float32 in [0, 1], 1 for lines that stay; see native/fovea/elision/opacity.h.");
}

}  // namespace fovea::bindings
