// SPDX-License-Identifier: GPL-3.0-or-later
// The spine test: its reference picture, and the table that the gpu's stroke pass reads.
#include <pybind11/stl.h>

#include <fovea/stroke/raster.h>
#include <fovea/visibility/spine.h>

#include "bindings/arrays.h"
#include "bindings/bind.h"
#include "bindings/scene_depth.h"

namespace fovea::bindings {
namespace {

py::array draw_seen(const Strokes& strokes, const std::vector<Pen>& pens, const std::vector<PenTexture>& textures,
                    const ClippedPaths& clipped, const SceneDepth& depth, int probes) {
    Array<vec4> image;
    {
        py::gil_scoped_release release;
        const OwnSides sides = own_sides(clipped, *depth.scene, depth.view);
        const SpineTest spine(clipped, sides, depth.buffer, {.probes = probes});
        raster(strokes, pens, textures, depth.view.width, depth.view.height, image, &spine);
    }
    return to_numpy(std::move(image)).reshape({depth.view.height, depth.view.width, 4});
}

}  // namespace

void bind_spine(py::module_& m) {
    m.def(
        "whole_runs", [](const ClippedPaths& clipped) { return std::make_shared<Runs>(whole_pieces(clipped)); },
        py::arg("clipped"), "Runs over the whole of every piece.");
    m.def("raster_seen", &draw_seen, py::arg("strokes"), py::arg("pens"), py::arg("textures"), py::arg("clipped"),
          py::arg("depth"), py::arg("probes") = 1,
          "As raster, over a SceneDepth's view, by the spine test; see native/fovea/visibility/spine.h.");
    m.def(
        "spine_table",
        [](const ClippedPaths& clipped, const OwnSides& sides) {
            Array<vec4> table;
            {
                py::gil_scoped_release release;
                table = spine_table(clipped, sides);
            }
            return to_numpy(std::move(table));
        },
        py::arg("clipped"), py::arg("sides"), "(3 M, 4) float32; see native/fovea/visibility/spine.h.");
}

}  // namespace fovea::bindings
