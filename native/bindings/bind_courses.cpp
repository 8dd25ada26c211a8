// SPDX-License-Identifier: GPL-3.0-or-later
// How hands draw: strokes beside the lines that they were drawn after.
#include <fovea/study/stroke_course.h>
#include <fovea/study/wobble.h>

#include "bindings/arrays.h"
#include "bindings/bind.h"

namespace fovea::bindings {
namespace {

using study::StrokeCourses;

StrokeCourses courses_of(const GrayImage& picture, const Arg<vec2>& px, const Arg<std::int64_t>& offsets,
                         const Arg<std::uint8_t>& is_free, const study::Bitmap& every, double reach, double cap) {
    const In<vec2> points = borrow<vec2>(px, "px");
    const In<std::int64_t> rows = borrow<std::int64_t>(offsets, "offsets");
    const In<std::uint8_t> free = borrow<std::uint8_t>(is_free, "is_free");
    return without_gil([&] { return study::courses_of(picture, points, rows, free, every, {reach, cap}); });
}

py::object wobble_of(const Arg<float>& away, const Arg<std::int64_t>& first, double longest) {
    const In<float> values = borrow<float>(away, "away");
    const In<std::int64_t> rows = borrow<std::int64_t>(first, "first");
    const study::Wobble found = without_gil([&] { return study::fitted_wobble(values, rows, longest); });
    return py::make_tuple(found.amount, found.length);
}

}  // namespace

void bind_courses(py::module_& m) {
    py::class_<StrokeCourses> courses(m, "StrokeCourses",
                                      "Where strokes run beside lines; see native/fovea/study/stroke_course.h.");
    bind_columns(courses, StrokeCourses::columns);
    courses.def_static(
        "of", &courses_of, py::arg("picture"), py::arg("px"), py::arg("offsets"), py::arg("is_free"), py::arg("every"),
        py::arg("reach"), py::arg("cap"),
        "Of a GrayImage and polylines as for Bitmap.of_lines. is_free: (2 R,) uint8, whether their starts "
        "and ends are told; every: the Bitmap of all lines that may be drawn; reach [px]: farthest that "
        "strokes are from lines; cap: of a stroke's width, beyond its end.");
    m.def("wobble_of", &wobble_of, py::arg("away"), py::arg("first"), py::arg("longest"),
          "(amount, wavelength) [px] of a pen's wobble, from `away` and `first` of StrokeCourses; 0, 0: none. longest: "
          "wave [px] that is looked for.");
}

}  // namespace fovea::bindings
