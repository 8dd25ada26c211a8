// SPDX-License-Identifier: GPL-3.0-or-later
// Elision: what the gpu backend's passes read, and what frames near by know of each other.
#include <pybind11/stl.h>

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
    std::vector<FrameNear> others;
    for (const auto& [away, lines] : near) others.push_back({away, *lines});
    return to_numpy(without_gil([&] { return smoothed_in_time(opacities, now, others, frames); }));
}

}  // namespace

void bind_elision(py::module_& m) {
    const auto own = [](auto member) {
        return [member](py::object self) { return view_numpy(self.cast<const Elision&>().own.*member, self); };
    };
    const auto bands = [](auto member) {
        return [member](py::object self) { return view_numpy(self.cast<const Elision&>().bands.*member, self); };
    };
    py::class_<Elision> elision(
        m, "Elision",
        "Bands of runs, of V corners, and the D atlas samples that runs cover; see native/fovea/elision/elide.h.");
    elision.def_property_readonly("place", own(&OwnBands::place), "(D, 4) float32: pixel position, direction")
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
        .def_property_readonly("triangles", bands(&Bands::triangles), "(T, 3) uint32, the highest rank first");
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
