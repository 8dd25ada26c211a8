// SPDX-License-Identifier: GPL-3.0-or-later
// Elision: input of the GPU backend's passes, and lines of neighboring frames.
#include <fovea/draw/backend.h>
#include <fovea/elision/elide.h>
#include <fovea/elision/in_time.h>

#include "bindings/arrays.h"
#include "bindings/bind.h"

namespace fovea::bindings {
namespace {

Numpy<float> smoothed(const ShownLines& now, const Arg<float>& shown,
                      const std::map<int, std::shared_ptr<ShownLines>>& near, int frames) {
    const auto opacities = borrow<float>(shown, "shown");
    const std::vector<FrameNear> others(near.begin(), near.end());
    return to_numpy(without_gil([&] { return smoothed_in_time(opacities, now, others, frames); }));
}

}  // namespace

void bind_elision(py::module_& m) {
    py::class_<Elision> elision(
        m, "Elision",
        "Bands of runs, of V corners, and the D atlas samples that runs cover; see native/fovea/elision/elide.h.");
    elision
        .def_property_readonly(
            "reach_px", [](const Elision& elision) { return elision.reach_px; },
            "pixels from its end over which a band hands over to a line that goes on")
        .def_property_readonly("figure_of_rank", viewing<Elision>(&OwnBands::figure_of_rank),
                               "(R,) float32, per rank: number of the figure of its run; -1: none")
        .def_property_readonly("triangles", viewing<Elision>(&Bands::triangles),
                               "(T, 3) uint32, the highest rank first");
    bind_columns(elision, OwnBands::columns);
    bind_columns(elision, Bands::vertex_columns);
    elision.attr("WINDOW_COLUMNS") = window_columns;
    elision.attr("WINDOW_LENGTH_PX") = window_length_px;
    elision.attr("MOST_WINDOW_ROWS") = most_window_rows;
    elision.attr("END_REACH") = end_reach;

    py::class_<ShownLines, std::shared_ptr<ShownLines>>(
        m, "ShownLines", "What elision leaves of the lines of a frame that no view makes.")
        .def("smoothed", &smoothed, py::arg("shown"), py::arg("near"), py::arg("frames"),
             R"((samples,) float32: the mean of what is shown of this frame over so many frames to each side, see
native/fovea/elision/in_time.h. shown: (samples,) float32; near: {how many frames later another is: its ShownLines}.)");
}

}  // namespace fovea::bindings
