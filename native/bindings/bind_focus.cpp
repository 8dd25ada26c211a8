// SPDX-License-Identifier: GPL-3.0-or-later
// Focus and transfer functions.
#include <algorithm>
#include <pybind11/stl.h>

#include <fovea/focus/focus.h>
#include <fovea/focus/transfer.h>

#include "bindings/arrays.h"
#include "bindings/bind.h"

namespace fovea::bindings {
namespace {

Transfer make_transfer(float start, float end, float strength, const std::vector<vec2>& curve) {
    return Transfer(start, end, strength, curve);
}

Numpy<float> answers(const Transfer& transfer, const Arg<float>& values) {
    const In<float> in = borrow<float>(values, "values");
    return to_numpy(without_gil([&] {
        Array<float> out(in.size());
        std::ranges::transform(in, out.begin(), transfer);
        return out;
    }));
}

}  // namespace

void bind_focus(py::module_& m) {
    py::class_<Transfer>(m, "Transfer",
                         "From focus in [0, 1] to how strong an effect is; see native/fovea/focus/transfer.h.")
        .def(py::init(&make_transfer), py::arg("start") = 0.0f, py::arg("end") = 1.0f, py::arg("strength") = 1.0f,
             py::arg("curve") = std::vector<vec2>(),
             "curve: points (x, y) of the response, ascending in x; none: straight.")
        .def("__call__", &answers, py::arg("values"), "(n,) float32 mixes in [0, 1] of (n,) values.");
    py::class_<Focus>(m, "Focus", "Where the viewer shall look; see native/fovea/focus/focus.h.")
        .def(
            "of_pixels",
            [](const Focus& focus, const View& view, const Pixels& distance) {
                const In<float> in(distance.data(), std::size_t(distance.size()));
                return to_image(without_gil([&] { return focus_of_pixels(view, in, focus); }), view.width, view.height);
            },
            py::arg("view"), py::arg("distance"),
            "(H, W) float32 in [0, 1]; 0: in focus. distance (H, W): along the view, of what each pixel shows; inf: "
            "nothing.");
}

}  // namespace fovea::bindings
