// Depth-buffer visibility: the cpu reference, and the tables that the gpu backend's passes read.
#include <pybind11/stl.h>

#include <glm/gtc/type_ptr.hpp>

#include "atlas/layout.h"
#include "atlas/sampled.h"
#include "bindings/arrays.h"
#include "bindings/bind.h"
#include "stroke/pen_table.h"

namespace fovea::bindings {
namespace {

/// A depth buffer with what it shows.
struct SceneDepth {
    std::shared_ptr<Scene> scene;
    View view;
    DepthBuffer buffer;
};

SceneDepth draw(std::shared_ptr<Scene> scene, const View& view, int scale, const Cancel* cancel) {
    py::gil_scoped_release release;
    const DepthOptions options{.scale = scale};
    DepthBuffer buffer = draw_depth(view, depth_meshes(*scene, view, options.margin), options, cancel);
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

py::list depth_draws(const Scene& scene, const View& view, const DepthBuffer& layout) {
    py::list draws;
    const dmat4 to_clip = view_to_depth_clip(view, layout);
    for (const Occluder& occluder : occluders(scene, view, DepthOptions().margin)) {
        const mat4 matrix(to_clip * occluder.object_to_view);
        const py::array_t<float> columns(16, glm::value_ptr(matrix));
        draws.append(py::make_tuple(scene.placements[occluder.placement].surface->version(), occluder.placement,
                                    columns, scene.facet_base[occluder.placement] % facet_modulus));
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
            "(height, width) records depth, ddx, ddy, facet, edges (x, y); bottom row first; see native/atlas/depth.h.");
    m.def("draw_depth", &draw, py::arg("scene"), py::arg("view"), py::arg("scale") = 2, py::arg("cancel") = py::none(),
          "SceneDepth with so many texels per pixel, along each axis.");
    m.def("sampled_visibility", &sampled, py::arg("clipped"), py::arg("depth"), py::arg("probes") = 1,
          py::arg("cancel") = py::none(), "(samples,) float32 in [0, 1], by looking into the depth buffer.");
}

void bind_passes(py::module_& m) {
    m.attr("SAMPLED_BIAS") = SampledOptions().bias;
    m.attr("SAMPLED_SLACK_PX") = SampledOptions().slack_px;
    py::class_<DepthBuffer>(m, "DepthLayout", "Size of a view's depth buffer; see native/atlas/depth.h.")
        .def(py::init([](const View& view, int scale) { return depth_layout(view, {.scale = scale}); }),
             py::arg("view"), py::arg("scale") = 2)
        .def_readonly("scale", &DepthBuffer::scale)
        .def_readonly("border_x", &DepthBuffer::border_x, "pixels")
        .def_readonly("border_y", &DepthBuffer::border_y, "pixels")
        .def_readonly("width", &DepthBuffer::width, "texels")
        .def_readonly("height", &DepthBuffer::height, "texels");
    m.def("depth_draws", &depth_draws, py::arg("scene"), py::arg("view"), py::arg("layout"),
          R"([(version of the surface, placement, object to depth clip space as 16 float32 by columns, facet base)] of all
that hides lines, in drawing order.)");
    m.def(
        "depth_corners",
        [](const Scene& scene, Index placement) { return depth_corners(*scene.placements.at(placement).surface); },
        py::arg("scene"), py::arg("placement"), "(positions (3 T, 3) float32, facets (3 T,) uint32)");

    py::class_<OwnSides>(m, "OwnSides", "What the facets at each line's own edge tell; see native/atlas/own_sides.h.")
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
          "(segments (3 N, 4) float32, owners (B,) float32); see native/atlas/layout.h.");
    m.def(
        "pen_table",
        [](const std::vector<Pen>& pens, const std::vector<PenTexture>& textures) {
            PenTable table = pen_table(pens, textures);
            return py::make_tuple(to_numpy(std::move(table.pens)), to_numpy(std::move(table.ink)));
        },
        py::arg("pens"), py::arg("textures"), "(pens (3 N, 4) float32, ink (I,) float32); see native/stroke/pen_table.h.");
}

}  // namespace

void bind_sampled(py::module_& m) {
    bind_reference(m);
    bind_passes(m);
}

}  // namespace fovea::bindings
