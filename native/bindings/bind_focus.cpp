// SPDX-License-Identifier: GPL-3.0-or-later
// Focus and transfer functions.
#include <algorithm>

#include <fovea/focus/focus.h>
#include <fovea/focus/monotone_cubic.h>
#include <fovea/focus/transfer.h>

#include "bindings/arrays.h"
#include "bindings/bind.h"

namespace fovea::bindings {
namespace {

/// function(x) of each number, called without the GIL.
template <typename Function>
Array<float> mapped(In<float> numbers, const Function& function) {
    return without_gil([&] {
        Array<float> out(numbers.size());
        std::ranges::transform(numbers, out.begin(), function);
        return out;
    });
}

Array<float> answers(const Transfer& transfer, const Arg<float>& values) {
    return mapped(borrow<float>(values, "values"), transfer);
}

Array<float> interpolated(const Arg<vec2>& points, const Arg<float>& x) {
    const In<vec2> through = borrow<vec2>(points, "points");
    const In<float> at = borrow<float>(x, "x");
    const bool ascends = std::ranges::is_sorted(through, std::ranges::less_equal{}, &vec2::x);
    check(!through.empty() && ascends, "monotone cubic: points with ascending x expected, at least one");
    return mapped(at, MonotoneCubic(through));
}

}  // namespace

void bind_focus(py::module_& m) {
    py::class_<Transfer>(m, "Transfer",
                         "From focus in [0, 1] to how strong an effect is; see native/fovea/focus/transfer.h.")
        .def(py::init<float, float, float, const std::vector<vec2>&>(), py::arg("start") = 0.0f, py::arg("end") = 1.0f,
             py::arg("strength") = 1.0f, py::arg("curve") = std::vector<vec2>(),
             "curve: points (x, y) of the response, ascending in x; none: straight.")
        .def("__call__", &answers, py::arg("values"), "(n,) float32 mixes in [0, 1] of (n,) values.");
    m.def("monotone_cubic", &interpolated, py::arg("points"), py::arg("x"),
          "(n,) float32 of (n,) x: the response curve through (k, 2) points, ascending in x, that a Transfer follows.");
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
