// SPDX-License-Identifier: GPL-3.0-or-later
// Input of the GPU backend's passes that draw and probe a depth buffer.
#include <glm/gtc/type_ptr.hpp>

#include <fovea/visibility/depth.h>
#include <fovea/visibility/item_buffer.h>
#include <fovea/visibility/layout.h>
#include <fovea/visibility/sampled.h>
#include <fovea/visibility/spine.h>

#include "bindings/arrays.h"
#include "bindings/bind.h"

namespace fovea::bindings {
namespace {

constexpr double margin = DepthOptions().margin;

/// Draw call of the depth pass for one placement, or for its one-sided triangles.
struct DepthDraw {
    Index placement;
    std::uint64_t surface_version;
    mat4 object_to_depth_clip;
    Index facet_base;
    const char* culled;
    vec4 cut;
    Index first, count;
};

/// Vertices of a surface's occluding triangles, three per triangle, unshared: vertex buffers of the depth pass.
struct DepthCorners {
    Array<vec3> positions;
    Array<Index> facets;
};

/// The back of an occluder's triangles, as a name of Blender's gpu module.
const char* back(const Occluder& occluder) {
    return glm::determinant(dmat3(occluder.object_to_view)) < 0.0 ? "FRONT" : "BACK";
}

std::vector<DepthDraw> depth_draws(const DepthBuffer& layout, const Scene& scene, const View& view) {
    std::vector<DepthDraw> draws;
    const dmat4 to_clip = view_to_depth_clip(view, layout);
    for (const Occluder& occluder : occluders(scene, view, margin)) {
        const Surface& surface = *scene.placements[occluder.placement].surface;
        const Index one_sided = occluder.one_sided_from(surface), end = surface.occluding_triangles;
        const auto draw = [&](const char* culled, Index from, Index to) {
            if (from < to)
                draws.push_back({occluder.placement, surface.version(), mat4(to_clip * occluder.object_to_view),
                                 scene.facet_base[occluder.placement] % facet_modulus, culled,
                                 vec4(occluder.cut.value_or(dvec4(0.0, 0.0, 0.0, -1.0))), 3 * from, 3 * (to - from)});
        };
        draw("NONE", 0, one_sided);
        draw(back(occluder), one_sided, end);
    }
    return draws;
}

/// The depth buffer of the CPU backend.
py::array texels(const DepthBuffer& layout, const Scene& scene, const View& view) {
    const DepthBuffer drawn = without_gil([&] { return draw_depth(layout, view, depth_meshes(scene, view, margin)); });
    return py::array_t<DepthTexel>({drawn.height, drawn.width}, drawn.texels.data());
}

std::shared_ptr<DepthCorners> depth_corners(const Surface& surface) {
    const std::size_t count = surface.occluding_triangles;
    auto corners = std::make_shared<DepthCorners>(Array<vec3>(3 * count), Array<Index>(3 * count));
    parallel_for(count, [&](std::size_t t) {
        for (int k = 0; k < 3; ++k) {
            corners->positions[3 * t + k] = surface.positions[surface.triangles[t][k]];
            corners->facets[3 * t + k] = surface.triangle_facet[t];
        }
    });
    return corners;
}

void bind_draws(py::module_& m) {
    PYBIND11_NUMPY_DTYPE(vec2, x, y);
    PYBIND11_NUMPY_DTYPE(DepthTexel, depth, ddx, ddy, facet, edges);
    py::class_<DepthDraw>(m, "DepthDraw", "What hides lines, as the depth pass draws it.")
        .def_readonly("placement", &DepthDraw::placement)
        .def_readonly("surface_version", &DepthDraw::surface_version, "Surface.version")
        .def_property_readonly(
            "object_to_depth_clip",
            [](const DepthDraw& draw) { return py::array_t<float>(16, glm::value_ptr(draw.object_to_depth_clip)); },
            "(16,) float32, column by column")
        .def_readonly("facet_base", &DepthDraw::facet_base, "number of its first facet")
        .def_readonly("culled", &DepthDraw::culled, "side that is not drawn: NONE, FRONT or BACK")
        .def_readonly("cut", &DepthDraw::cut, "plane in object space: what is before it is cut away")
        .def_readonly("first", &DepthDraw::first, "the first of the corners to draw")
        .def_readonly("count", &DepthDraw::count, "and their number");
    py::class_<DepthCorners, std::shared_ptr<DepthCorners>>(m, "DepthCorners",
                                                            "Corners of T occluding triangles, one after the other.")
        .def(py::init([](const Surface& surface) { return without_gil([&] { return depth_corners(surface); }); }),
             py::arg("surface"))
        .def_property_readonly("positions", viewing<DepthCorners>(&DepthCorners::positions), "(3 T, 3) float32")
        .def_property_readonly("facets", viewing<DepthCorners>(&DepthCorners::facets), "(3 T,) uint32");

    py::class_<DepthBuffer>(m, "DepthLayout", "Size of a view's depth buffer; see native/fovea/visibility/depth.h.")
        .def(py::init([](const View& view, int scale) { return depth_layout(view, {.scale = scale}); }),
             py::arg("view"), py::arg("scale") = DepthOptions().scale, "scale: texels per pixel, along each axis.")
        .def("texels", &texels, py::arg("scene"), py::arg("view"),
             "(height, width) records depth, ddx, ddy, facet, edges (x, y) of the nearest surface; bottom row first.")
        .def("draws", &depth_draws, py::arg("scene"), py::arg("view"), "All that hides lines, in drawing order.")
        .def_readonly("scale", &DepthBuffer::scale)
        .def_readonly("border_x", &DepthBuffer::border_x, "pixels")
        .def_readonly("border_y", &DepthBuffer::border_y, "pixels")
        .def_readonly("width", &DepthBuffer::width, "texels")
        .def_readonly("height", &DepthBuffer::height, "texels")
        .def_readonly("core", &DepthBuffer::core, "left, lower, right and upper edge of what it decides, in pixels");
    m.def(
        "has_section", [](const Scene& scene) { return scene.section.has_value(); }, py::arg("scene"),
        "Whether a section plane cuts the scene open.");
    m.def(
        "depth_reach", [](const Scene& scene, const View& view) { return depth_reach(scene, view, margin); },
        py::arg("scene"), py::arg("view"), "How far away along the view anything that hides lines reaches.");
}

void bind_options(py::module_& m) {
    py::class_<SampledOptions>(m, "SampledOptions",
                               "How the segment atlas looks; see native/fovea/visibility/sampled.h.")
        .def(py::init<>())
        .def_readonly("bias", &SampledOptions::bias)
        .def_readonly("slack_px", &SampledOptions::slack_px);
    py::class_<ItemOptions>(m, "ItemOptions",
                            "How lines are drawn by number; see native/fovea/visibility/item_buffer.h.")
        .def(py::init<>())
        .def_readonly("slope_factor", &ItemOptions::slope_factor)
        .def_readonly("bias", &ItemOptions::bias);
}

void bind_tables(py::module_& m) {
    py::class_<OwnSides>(m, "OwnSides",
                         "What the facets at each line's own edge tell; see native/fovea/visibility/own_sides.h.")
        .def(py::init([](const ClippedPaths& clipped, const Scene& scene, const View& view) {
                 return without_gil([&] { return own_sides(clipped, scene, view); });
             }),
             py::arg("clipped"), py::arg("scene"), py::arg("view"))
        .def(
            "spine_table",
            [](const OwnSides& sides, const ClippedPaths& clipped) { return spine_table(clipped, sides); }, NoGil(),
            py::arg("clipped"), "(3 M, 4) float32; see native/fovea/visibility/spine.h.");
    py::class_<AtlasTables, std::shared_ptr<AtlasTables>>(m, "AtlasTables",
                                                          "N segments; see native/fovea/visibility/layout.h.")
        .def_property_readonly("segments", viewing<AtlasTables>(&AtlasTables::segments), "(3 N, 4) float32")
        .def_property_readonly("owners", viewing<AtlasTables>(&AtlasTables::owners), "(B,) float32");
    py::class_<AtlasBatch> batch(m, "AtlasBatch", "Whole pieces whose samples share a texture.");
    batch.attr("ROW_WIDTH") = atlas_width;
    batch.attr("OWNER_STRIDE") = owner_stride;
    batch
        .def_static("of", &atlas_batches, py::arg("clipped"), py::arg("limit") = batch_samples,
                    "Of at most so many samples, or one piece.")
        .def(
            "tables",
            [](const AtlasBatch& batch, const ClippedPaths& clipped, const OwnSides& sides) {
                return atlas_tables(clipped, sides, batch);
            },
            NoGil(), py::arg("clipped"), py::arg("sides"))
        .def_readonly("sample_begin", &AtlasBatch::sample_begin)
        .def_readonly("sample_end", &AtlasBatch::sample_end);
}

}  // namespace

void bind_depth(py::module_& m) {
    bind_draws(m);
    bind_options(m);
    bind_tables(m);
}

}  // namespace fovea::bindings
