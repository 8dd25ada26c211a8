// SPDX-License-Identifier: GPL-3.0-or-later
// Filters of runs along their paths.
#include <pybind11/stl.h>

#include <fovea/path/paths.h>
#include <fovea/runs/filters.h>
#include <fovea/runs/outer_parts.h>

#include "bindings/arrays.h"
#include "bindings/bind.h"

namespace fovea::bindings {

namespace {

py::tuple outer(const ClippedPaths& clipped, const Paths& paths, const Tracer& tracer, const Runs& runs,
                const Arg<Kinds>& sure, double step_px, const Cancel* cancel) {
    const auto kinds = borrow<Kinds>(sure, "sure");
    const Cancel never;
    auto parts = std::make_shared<Runs>();
    OuterParts found;
    {
        py::gil_scoped_release release;
        found = outer_parts(clipped, paths, tracer, runs, kinds, step_px, cancel ? *cancel : never);
        *parts = std::move(found.runs);
    }
    return py::make_tuple(parts, to_numpy(std::move(found.outer)), to_numpy(std::move(found.source)));
}

}  // namespace

void bind_filters(py::module_& m) {
    m.def("outer_parts", &outer, py::arg("clipped"), py::arg("paths"), py::arg("tracer"), py::arg("runs"),
          py::arg("sure"), py::arg("step_px"), py::arg("cancel") = py::none(),
          R"((Runs, outer, source): runs parted where they are the outer boundary of their object; outer (R,) uint8, and
source (R,) uint32 the point of Paths whose segment each begins on. Asked every step_px pixels at most. sure: (P,)
uint32 per path of Paths, bits of kinds whose segments are outer unasked.)");
    m.def(
        "close_gaps",
        [](const ClippedPaths& clipped, const Runs& runs, double gap_px, const Arg<float>& spur_px, double speck_px) {
            const In<float> spurs = borrow<float>(spur_px, "spur_px");
            py::gil_scoped_release release;
            return std::make_shared<Runs>(close_gaps(clipped, runs, gap_px, spurs, speck_px));
        },
        py::arg("clipped"), py::arg("runs"), py::arg("gap_px"), py::arg("spur_px"), py::arg("speck_px") = 0.0,
        R"(Joins visible runs over gaps shorter than gap_px, drops those that are shorter than spur_px and hidden on
both sides, or than speck_px and hidden on one. spur_px: (P,) float32 per path of Paths.)");
    m.def(
        "trim_folds",
        [](const ClippedPaths& clipped, const Runs& runs, const Paths& paths, double fold_px) {
            py::gil_scoped_release release;
            return std::make_shared<Runs>(trim_folds(clipped, runs, paths.of_view, fold_px));
        },
        py::arg("clipped"), py::arg("runs"), py::arg("paths"), py::arg("fold_px"),
        "Cuts folds of at most fold_px off the ends of contours.");
    m.def(
        "meet_ends",
        [](const ClippedPaths& clipped, const Runs& runs, const Paths& paths, double reach_px) {
            py::gil_scoped_release release;
            return std::make_shared<Runs>(meet_ends(clipped, runs, paths.of_view, paths.placement, reach_px));
        },
        py::arg("clipped"), py::arg("runs"), py::arg("paths"), py::arg("reach_px"),
        "Visible runs of contours drawn on by at most reach_px where another line goes on from their end.");
    m.def(
        "halo",
        [](const ClippedPaths& clipped, const Runs& runs, const Paths& paths, const Arg<float>& gap_px) {
            const In<float> gaps = borrow<float>(gap_px, "gap_px");
            py::gil_scoped_release release;
            return std::make_shared<Runs>(halo(clipped, runs, gaps, paths.of_view));
        },
        py::arg("clipped"), py::arg("runs"), py::arg("paths"), py::arg("gap_px"),
        R"(Visible runs that stop gap_px short of visible lines that they pass behind. gap_px: (P,) float32 per path
of Paths, 0 or more; 0 leaves a path as it is. Comes before overshoot.)");
    m.def(
        "overshoot",
        [](const ClippedPaths& clipped, const Runs& runs, const Arg<float>& amount_px,
           const std::optional<Arg<float>>& other_px, const std::optional<Arg<float>>& mix) {
            const In<float> amounts = borrow<float>(amount_px, "amount_px");
            const In<float> others = borrow<float>(other_px, "other_px"), mixes = borrow<float>(mix, "mix");
            const bool mixed = other_px.has_value();
            py::gil_scoped_release release;
            return std::make_shared<Runs>(mixed ? overshoot(clipped, runs, amounts, others, mixes)
                                                : overshoot(clipped, runs, amounts));
        },
        py::arg("clipped"), py::arg("runs"), py::arg("amount_px"), py::arg("other_px") = py::none(),
        py::arg("mix") = py::none(),
        R"(Visible runs longer by amount_px where their paths end, straight on, or shorter at all ends where it is less
than 0. amount_px: (P,) float32 per path of Paths; 0 leaves a path as it is. other_px (P,) and
mix (samples,) in [0, 1]: amounts out of focus, and how far each sample is on the way to them.)");
}

}  // namespace fovea::bindings
