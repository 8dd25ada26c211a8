// SPDX-License-Identifier: GPL-3.0-or-later
// Elision smoothed in time.
#include <pybind11/stl.h>

#include <fovea/elision/in_time.h>

#include "bindings/arrays.h"
#include "bindings/bind.h"

namespace fovea::bindings {
namespace {

std::shared_ptr<ShownLines> make_shown(const ClippedPaths& clipped, const Paths& paths, const Scene& scene,
                                       const Runs& runs, const Arg<float>& shown, int width, int height) {
    const auto opacities = borrow<float>(shown, "shown");
    py::gil_scoped_release release;
    return std::make_shared<ShownLines>(shown_lines(clipped, paths, scene, runs, opacities, width, height));
}

py::array smoothed(const Arg<float>& shown, const ShownLines& now,
                   const std::vector<std::pair<int, std::shared_ptr<ShownLines>>>& near, int frames) {
    const auto opacities = borrow<float>(shown, "shown");
    Array<float> smooth;
    {
        py::gil_scoped_release release;
        std::vector<FrameNear> others;
        for (const auto& [away, lines] : near) others.push_back({away, *lines});
        smooth = smoothed_in_time(opacities, now, others, frames);
    }
    return to_numpy(std::move(smooth));
}

}  // namespace

void bind_in_time(py::module_& m) {
    py::class_<ShownLines, std::shared_ptr<ShownLines>>(
        m, "ShownLines", "What elision leaves of the lines of a frame that no view makes.")
        .def(py::init(&make_shown), py::arg("clipped"), py::arg("paths"), py::arg("scene"), py::arg("runs"),
             py::arg("shown"), py::arg("width"), py::arg("height"), "shown (samples,) float32 in [0, 1].");
    m.def("smoothed_in_time", &smoothed, py::arg("shown"), py::arg("now"), py::arg("near"), py::arg("frames"),
          R"((samples,) float32: the mean over so many frames to each side, see native/fovea/elision/in_time.h. now: the
frame's ShownLines; near: pairs of how many frames later another is and its ShownLines.)");
}

}  // namespace fovea::bindings
