// Depth-buffer visibility: the cpu reference, and the tables that the gpu backend's passes read.
#include <glm/gtc/type_ptr.hpp>

#include "atlas/layout.h"
#include "atlas/sampled.h"
#include "bindings/arrays.h"

namespace fovea::bindings {
namespace {

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

/// What the depth pass draws: (key of the surface's content, placement, 16 numbers of object_to_depth_clip by
/// columns, facet_base) each, in drawing order.
py::list depth_draws(const Scene& scene, const View& view, const DepthBuffer& layout) {
    py::list draws;
    const dmat4 to_clip = view_to_depth_clip(view, layout);
    for (const Occluder& occluder : occluders(scene, view, DepthOptions().margin)) {
        const mat4 matrix(to_clip * occluder.object_to_view);
        py::array_t<float> columns(16, glm::value_ptr(matrix));
        draws.append(py::make_tuple(scene.placements[occluder.placement].surface->version(), occluder.placement,
                                    columns, scene.facet_base[occluder.placement] % facet_modulus));
    }
    return draws;
}

py::array sampled(const ClippedPaths& clipped, const DepthBuffer& buffer, int probes) {
    SampledOptions options;
    options.probes = probes;
    Array<float> visibility;
    {
        py::gil_scoped_release release;
        visibility = sampled_visibility(clipped, buffer, options);
    }
    return to_numpy(std::move(visibility));
}

py::list batches(const ClippedPaths& clipped, Index limit) {
    py::list result;
    for (const AtlasBatch& batch : atlas_batches(clipped, limit)) result.append(batch);
    return result;
}

py::tuple tables(const ClippedPaths& clipped, const AtlasBatch& batch) {
    AtlasTables tables;
    {
        py::gil_scoped_release release;
        tables = atlas_tables(clipped, batch);
    }
    return py::make_tuple(to_numpy(std::move(tables.segments)), to_numpy(std::move(tables.owners)));
}

}  // namespace

void bind_sampled(py::module_& m) {
    PYBIND11_NUMPY_DTYPE(DepthTexel, depth, ddx, ddy, facet);
    py::class_<DepthBuffer>(m, "DepthBuffer", "The nearest surface at every texel.")
        .def_readonly("scale", &DepthBuffer::scale)
        .def_readonly("border_x", &DepthBuffer::border_x)
        .def_readonly("border_y", &DepthBuffer::border_y)
        .def_readonly("width", &DepthBuffer::width)
        .def_readonly("height", &DepthBuffer::height)
        .def_property_readonly("texels", [](py::object self) {
            const auto& buffer = self.cast<const DepthBuffer&>();
            return py::array_t<DepthTexel>({buffer.height, buffer.width}, buffer.texels.data(), self);
        }, "(height, width) records depth, ddx, ddy, facet; bottom row first.");
    m.def("draw_depth", [](const Scene& scene, const View& view, int scale) {
        py::gil_scoped_release release;
        const DepthOptions options{.scale = scale};
        return draw_depth(view, depth_meshes(scene, view, options.margin), options);
    }, py::arg("scene"), py::arg("view"), py::arg("scale") = 2);
    m.def("depth_layout", [](const View& view, int scale) { return depth_layout(view, {.scale = scale}); },
          py::arg("view"), py::arg("scale") = 2, "A DepthBuffer without texels.");
    m.def("sampled_visibility", &sampled, py::arg("clipped"), py::arg("depth_buffer"), py::arg("probes") = 1,
          "(samples,) float32 in [0, 1].");
    m.def("depth_draws", &depth_draws, py::arg("scene"), py::arg("view"), py::arg("layout"));
    m.def("depth_corners", [](const Scene& scene, Index placement) {
        return depth_corners(*scene.placements.at(placement).surface);
    }, py::arg("scene"), py::arg("placement"), "(positions (3 T, 3) float32, facets (3 T,) uint32).");

    py::class_<AtlasBatch>(m, "AtlasBatch", "Whole pieces that share a texture.")
        .def_readonly("sample_begin", &AtlasBatch::sample_begin)
        .def_readonly("sample_end", &AtlasBatch::sample_end);
    m.def("atlas_batches", &batches, py::arg("clipped"), py::arg("limit") = batch_samples);
    m.def("atlas_tables", &tables, py::arg("clipped"), py::arg("batch"),
          "(segments (3 N, 4) float32, owners (B,) float32); see native/atlas/layout.h.");
}

}  // namespace fovea::bindings
