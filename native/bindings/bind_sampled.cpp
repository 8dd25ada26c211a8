// SPDX-License-Identifier: GPL-3.0-or-later
// Depth-buffer visibility: the cpu reference, and the tables that the gpu backend's passes read.
#include <glm/gtc/type_ptr.hpp>
#include <pybind11/stl.h>

#include <fovea/stroke/pen_table.h>
#include <fovea/visibility/depth_tiles.h>
#include <fovea/visibility/item_buffer.h>
#include <fovea/visibility/layout.h>
#include <fovea/visibility/sampled.h>

#include "bindings/arrays.h"
#include "bindings/bind.h"
#include "bindings/scene_depth.h"

namespace fovea::bindings {
namespace {

SceneDepth depth_of(std::shared_ptr<Scene> scene, const View& view, DepthBuffer layout, const Cancel* cancel) {
    py::gil_scoped_release release;
    const std::vector<RasterMesh> meshes = depth_meshes(*scene, view, DepthOptions().margin);
    DepthBuffer buffer = draw_depth_into(std::move(layout), view, meshes, cancel);
    return {std::move(scene), view, std::move(buffer)};
}

py::array sampled(const ClippedPaths& clipped, const SceneDepth& depth, int probes, const Cancel* cancel) {
    Array<float> visibility;
    {
        py::gil_scoped_release release;
        const OwnSides sides = own_sides(clipped, *depth.scene, depth.view);
        visibility = sampled_visibility(clipped, sides, depth.buffer, {.probes = probes}, cancel);
    }
    return to_numpy(std::move(visibility));
}

/// Corners of a surface's occluding triangles, one after the other: what the depth pass keeps on the GPU.
py::tuple depth_corners(const Surface& surface) {
    const std::size_t count = surface.occluding_triangles;
    Array<vec3> positions(3 * count);
    Array<Index> facets(3 * count);
    {
        py::gil_scoped_release release;
        parallel_for(count, [&](std::size_t t) {
            for (int k = 0; k < 3; ++k) {
                positions[3 * t + k] = surface.positions[surface.triangles[t][k]];
                facets[3 * t + k] = surface.triangle_facet[t];
            }
        });
    }
    return py::make_tuple(to_numpy(std::move(positions)), to_numpy(std::move(facets)));
}

/// Which side of its triangles need not be drawn, as Blender calls it.
const char* one_side(const Occluder& occluder) {
    if (!occluder.solid) return "NONE";
    return glm::determinant(dmat3(occluder.object_to_view)) < 0.0 ? "FRONT" : "BACK";
}

py::list depth_draws(const Scene& scene, const View& view, const DepthBuffer& layout) {
    py::list draws;
    const dmat4 to_clip = view_to_depth_clip(view, layout);
    for (const Occluder& occluder : occluders(scene, view, DepthOptions().margin)) {
        const mat4 matrix(to_clip * occluder.object_to_view);
        const py::array_t<float> columns(16, glm::value_ptr(matrix));
        draws.append(py::make_tuple(scene.placements[occluder.placement].surface->version(), occluder.placement,
                                    columns, scene.facet_base[occluder.placement] % facet_modulus, one_side(occluder)));
    }
    return draws;
}

py::tuple tables(const ClippedPaths& clipped, const OwnSides& sides, const AtlasBatch& batch) {
    AtlasTables tables;
    {
        py::gil_scoped_release release;
        tables = atlas_tables(clipped, sides, batch);
    }
    return py::make_tuple(to_numpy(std::move(tables.segments)), to_numpy(std::move(tables.owners)));
}

void bind_reference(py::module_& m) {
    PYBIND11_NUMPY_DTYPE(vec2, x, y);
    PYBIND11_NUMPY_DTYPE(DepthTexel, depth, ddx, ddy, facet, edges);
    py::class_<SceneDepth>(m, "SceneDepth", "The nearest surface of a scene at every texel of a view.")
        .def_property_readonly(
            "texels",
            [](py::object self) {
                const DepthBuffer& buffer = self.cast<const SceneDepth&>().buffer;
                return py::array_t<DepthTexel>({buffer.height, buffer.width}, buffer.texels.data(), self);
            },
            "(height, width) records depth, ddx, ddy, facet, edges (x, y); bottom row first; see "
            "native/fovea/visibility/depth.h.");
    m.def(
        "draw_depth",
        [](std::shared_ptr<Scene> scene, const View& view, int scale, const Cancel* cancel) {
            return depth_of(std::move(scene), view, depth_layout(view, {.scale = scale}), cancel);
        },
        py::arg("scene"), py::arg("view"), py::arg("scale") = 2, py::arg("cancel") = py::none(),
        "SceneDepth with so many texels per pixel, along each axis.");
    m.def("draw_depth", &depth_of, py::arg("scene"), py::arg("view"), py::arg("layout"), py::arg("cancel") = py::none(),
          "SceneDepth of a DepthLayout.");
    m.def("sampled_visibility", &sampled, py::arg("clipped"), py::arg("depth"), py::arg("probes") = 1,
          py::arg("cancel") = py::none(),
          "(samples,) float32 in [0, 1], by looking into the depth buffer; 0 where it does not decide.");
    m.def(
        "item_visibility",
        [](const ClippedPaths& clipped, const SceneDepth& depth, int layers, const Cancel* cancel) {
            Array<float> visibility;
            {
                py::gil_scoped_release release;
                visibility = item_visibility(clipped, depth.buffer, {.layers = layers}, cancel);
            }
            return to_numpy(std::move(visibility));
        },
        py::arg("clipped"), py::arg("depth"), py::arg("layers") = 1, py::arg("cancel") = py::none(),
        "(samples,) float32 in [0, 1], by the item buffer; 0 where the depth buffer does not decide.");
}

void bind_passes(py::module_& m) {
    m.attr("SAMPLED_BIAS") = SampledOptions().bias;
    m.attr("ITEM_SLOPE_FACTOR") = ItemOptions().slope_factor;
    m.attr("ITEM_BIAS") = ItemOptions().bias;
    m.attr("SAMPLED_SLACK_PX") = SampledOptions().slack_px;
    py::class_<DepthBuffer>(m, "DepthLayout", "Size of a view's depth buffer; see native/fovea/visibility/depth.h.")
        .def(py::init([](const View& view, int scale) { return depth_layout(view, {.scale = scale}); }),
             py::arg("view"), py::arg("scale") = 2)
        .def_readonly("scale", &DepthBuffer::scale)
        .def_readonly("border_x", &DepthBuffer::border_x, "pixels")
        .def_readonly("border_y", &DepthBuffer::border_y, "pixels")
        .def_readonly("width", &DepthBuffer::width, "texels")
        .def_readonly("height", &DepthBuffer::height, "texels")
        .def_property_readonly(
            "core", [](const DepthBuffer& b) { return std::array{b.core.x, b.core.y, b.core.z, b.core.w}; },
            "left, lower, right and upper edge of what it decides, in pixels");
    m.def(
        "depth_tiles",
        [](const View& view, int scale, int side, int overlap_px) {
            return depth_tiles(view, {.scale = scale}, side, overlap_px);
        },
        py::arg("view"), py::arg("scale"), py::arg("side"), py::arg("overlap_px"),
        "DepthLayouts of at most `side` texels; see native/fovea/visibility/depth_tiles.h.");
    m.def("depth_draws", &depth_draws, py::arg("scene"), py::arg("view"), py::arg("layout"),
          R"([(version of the surface, placement, object to depth clip space as 16 float32 by columns, facet base, side
to cull: NONE, FRONT or BACK)] of all that hides lines, in drawing order.)");
    m.def(
        "depth_reach",
        [](const Scene& scene, const View& view) { return depth_reach(scene, view, DepthOptions().margin); },
        py::arg("scene"), py::arg("view"), "How far away along the view anything that hides lines reaches.");
    m.def(
        "depth_corners",
        [](const Scene& scene, Index placement) { return depth_corners(*scene.placements.at(placement).surface); },
        py::arg("scene"), py::arg("placement"), "(positions (3 T, 3) float32, facets (3 T,) uint32)");

    py::class_<OwnSides>(m, "OwnSides",
                         "What the facets at each line's own edge tell; see native/fovea/visibility/own_sides.h.")
        .def(py::init([](const ClippedPaths& clipped, const Scene& scene, const View& view) {
                 py::gil_scoped_release release;
                 return own_sides(clipped, scene, view);
             }),
             py::arg("clipped"), py::arg("scene"), py::arg("view"));
    py::class_<AtlasBatch>(m, "AtlasBatch", "Whole pieces that share a texture.")
        .def_readonly("sample_begin", &AtlasBatch::sample_begin)
        .def_readonly("sample_end", &AtlasBatch::sample_end);
    m.def(
        "atlas_batches",
        [](const ClippedPaths& clipped, Index limit) {
            const Array<AtlasBatch> batches = atlas_batches(clipped, limit);
            return std::vector<AtlasBatch>(batches.begin(), batches.end());
        },
        py::arg("clipped"), py::arg("limit") = batch_samples, "AtlasBatches of at most so many samples, or one piece.");
    m.def("atlas_tables", &tables, py::arg("clipped"), py::arg("sides"), py::arg("batch"),
          "(segments (3 N, 4) float32, owners (B,) float32); see native/fovea/visibility/layout.h.");
    m.def(
        "pen_table",
        [](const std::vector<Pen>& pens, const std::vector<PenTexture>& textures) {
            PenTable table = pen_table(pens, textures);
            return py::make_tuple(to_numpy(std::move(table.pens)), to_numpy(std::move(table.ink)));
        },
        py::arg("pens"), py::arg("textures"),
        "(pens (3 N, 4) float32, ink (I,) float32); see native/fovea/stroke/pen_table.h.");
}

}  // namespace

void bind_sampled(py::module_& m) {
    bind_passes(m);
    bind_reference(m);
}

}  // namespace fovea::bindings
