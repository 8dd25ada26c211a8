// SPDX-License-Identifier: GPL-3.0-or-later
// Runs read back as polylines.
#include <fovea/runs/compaction.h>

#include "bindings/arrays.h"
#include "bindings/bind.h"

namespace fovea::bindings {

void bind_compaction(py::module_& m) {
    const auto array = [](auto member) {
        return [member](py::object self) { return view_numpy(self.cast<const CompactRuns&>().*member, self); };
    };
    py::class_<CompactRuns>(m, "CompactRuns",
                            "R runs as polylines of M points in all, in path order; arrays without copies.")
        .def_property_readonly(
            "offsets", [](py::object self) { return view_numpy(self.cast<const CompactRuns&>().rows.offsets, self); },
            "(R + 1,) uint32: points of run r are offsets[r] .. offsets[r + 1]")
        .def_property_readonly("path_id", array(&CompactRuns::path_id), "(R,) uint64 persistent id of the path")
        .def_property_readonly("path", array(&CompactRuns::path), "(R,) uint32 path of Paths")
        .def_property_readonly("piece", array(&CompactRuns::piece), "(R,) uint32 piece of ClippedPaths")
        .def_property_readonly("start_px", array(&CompactRuns::start_px),
                               "(R,) float64 arc length in pixels, 0 at the path's middle")
        .def_property_readonly("end_px", array(&CompactRuns::end_px), "(R,) float64")
        .def_property_readonly("invisibility", array(&CompactRuns::invisibility),
                               "(R,) uint8 surfaces that hide it; 0: visible")
        .def_property_readonly("line_set", array(&CompactRuns::line_set), "(R,) uint8")
        .def_property_readonly("closed", array(&CompactRuns::closed),
                               "(R,) uint8, 1: all of a closed path; the last point is the first again")
        .def_property_readonly("px", array(&CompactRuns::px), "(M, 2) float32 pixels, from the lower left corner, y up")
        .def_property_readonly("position_view", array(&CompactRuns::position_view),
                               "(M, 3) float32 view space: the eye at 0, looking along -z")
        .def_property_readonly("arc_px", array(&CompactRuns::arc_px), "(M,) float64 arc length in pixels")
        .def_property_readonly("strength", array(&CompactRuns::strength), "(M,) float32 in [0, 1]")
        .def_property_readonly("kinds", array(&CompactRuns::kinds),
                               "(M,) bits of what the segment from the point is; see line_definitions()")
        .def("__len__", [](const CompactRuns& runs) { return runs.path.size(); });
    m.def(
        "compact",
        [](const ClippedPaths& clipped, const Paths& paths, const Runs& runs) {
            py::gil_scoped_release release;
            return compact(clipped, paths, runs);
        },
        py::arg("clipped"), py::arg("paths"), py::arg("runs"),
        R"(CompactRuns: the points of the paths within each run, its ends interpolated; see native/fovea/runs/compaction.h.
Visible runs, or with_hidden ones: invisibility tells.)");
}

}  // namespace fovea::bindings
