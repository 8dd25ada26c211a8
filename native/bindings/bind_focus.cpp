// SPDX-License-Identifier: GPL-3.0-or-later
// Focus and transfer functions.
#include <pybind11/stl.h>

#include <fovea/focus/focus.h>
#include <fovea/focus/transfer.h>

#include "bindings/arrays.h"
#include "bindings/bind.h"
#include "bindings/painted.h"

namespace fovea::bindings {
namespace {

Transfer make_transfer(float start, float end, float strength, const std::vector<std::array<float, 2>>& curve) {
    std::vector<vec2> points;
    for (const auto& [x, y] : curve) points.emplace_back(x, y);
    return Transfer(start, end, strength, points);
}

using Distances = std::vector<std::shared_ptr<SurfaceDistance>>;

Focus make_focus(bool in_scene, const std::vector<std::array<float, 5>>& points, bool sum, const Distances& surfaces) {
    check(surfaces.empty() || (in_scene && surfaces.size() == points.size()),
          "focus: surfaces lie in the scene, one or None per point");
    Focus focus{in_scene ? FocusSpace::scene : FocusSpace::image, {}, sum};
    for (const auto& p : points) {
        check(p[3] >= 0.0f && p[4] >= p[3], "focus: radii must not be negative, and far not less than near");
        const std::size_t i = focus.points.size();
        focus.points.push_back({{p[0], p[1], p[2]}, p[3], p[4], surfaces.empty() ? nullptr : surfaces[i]});
    }
    return focus;
}

template <typename Make>
py::array made(const Make& make) {
    Array<float> values;
    {
        py::gil_scoped_release release;
        values = make();
    }
    return to_numpy(std::move(values));
}

}  // namespace

void bind_focus(py::module_& m) {
    py::class_<Transfer>(m, "Transfer",
                         "From focus in [0, 1] to how strong an effect is; see native/fovea/focus/transfer.h.")
        .def(py::init(&make_transfer), py::arg("start") = 0.0f, py::arg("end") = 1.0f, py::arg("strength") = 1.0f,
             py::arg("curve") = py::list(), "curve: points (x, y) of the response, ascending in x; none: straight.")
        .def(
            "__call__",
            [](const Transfer& transfer, const Arg<float>& values) {
                const In<float> in = borrow<float>(values, "values");
                return made([&] {
                    Array<float> out(in.size());
                    std::ranges::transform(in, out.begin(), transfer);
                    return out;
                });
            },
            py::arg("values"), "(n,) float32 mixes in [0, 1] of (n,) values.");
    py::class_<SurfaceDistance, std::shared_ptr<SurfaceDistance>>(
        m, "SurfaceDistance", "How far places are from some placements' surfaces; see native/fovea/scene/distance.h.")
        .def(py::init([](const Scene& scene, const View& view, const Arg<Index>& placements) {
                 const In<Index> in = borrow<Index>(placements, "placements");
                 py::gil_scoped_release release;
                 return std::make_shared<SurfaceDistance>(scene, view, in);
             }),
             py::arg("scene"), py::arg("view"), py::arg("placements"), "placements (k,) uint32: which of the scene's.");
    py::class_<Focus>(m, "Focus", "Where the viewer shall look; see native/fovea/focus/focus.h.")
        .def(
            py::init(&make_focus), py::arg("in_scene") = false, py::arg("points") = py::list(), py::arg("sum") = false,
            py::arg("surfaces") = Distances(),
            R"(points: (x, y, z, near, far), in view space and units of the scene, or (without in_scene) in pixels of the
image, z unused. Of several the nearest counts, or (sum) they add up. surfaces: for each point the SurfaceDistance that
counts instead of its place, or None.)");
    m.def(
        "focus_of_samples",
        [](const ClippedPaths& clipped, const Focus& focus) {
            return made([&] { return focus_of_samples(clipped, focus); });
        },
        py::arg("clipped"), py::arg("focus"), "(samples,) float32 in [0, 1]; 0: in focus.");
    m.def(
        "focus_of_pixels",
        [](const View& view, const py::array_t<float, py::array::c_style | py::array::forcecast>& distance,
           const Focus& focus) {
            const In<float> in(distance.data(), std::size_t(distance.size()));
            return made([&] { return focus_of_pixels(view, in, focus); }).reshape({view.height, view.width});
        },
        py::arg("view"), py::arg("distance"), py::arg("focus"),
        "(H, W) float32 in [0, 1]. distance (H, W): along the view, of what each pixel shows; inf: nothing.");
    m.def(
        "values_on_paths",
        [](const Paths& paths, const Scene& scene, const PaintedArrays& painted) {
            const Painted in = borrow_painted(painted);
            return made([&] { return values_on_paths(paths, scene, in); });
        },
        py::arg("paths"), py::arg("scene"), py::arg("painted"),
        R"((N,) float32 in [0, 1]: what is painted at each point of Paths. painted: per placement (C,) float32 at the corners of
its mesh, or None: .5.)");
    m.def(
        "values_of_samples",
        [](const ClippedPaths& clipped, const Arg<float>& values) {
            const In<float> in = borrow<float>(values, "values");
            return made([&] { return values_of_samples(clipped, in); });
        },
        py::arg("clipped"), py::arg("values"), "(samples,) float32 of (N,) values at the points of Paths.");
    m.def(
        "distance_of_samples",
        [](const ClippedPaths& clipped, float near, float far) {
            return made([&] { return distance_of_samples(clipped, near, far); });
        },
        py::arg("clipped"), py::arg("near"), py::arg("far"),
        "(samples,) float32: 0 up to near, 1 from far on, along the view.");
}

}  // namespace fovea::bindings
