// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces.
#include <pybind11/stl.h>

#include <fovea/base/hash.h>
#include <fovea/field/fields.h>
#include <fovea/mesh/polygon_edges.h>
#include <fovea/mesh/refine.h>
#include <fovea/mesh/surface.h>
#include <fovea/repair/repair.h>

#include "bindings/arrays.h"
#include "bindings/bind.h"

namespace fovea::bindings {
namespace {

template <typename T>
using Optional = std::optional<Arg<T>>;

MeshArrays borrowed(const Arg<vec3>& positions, const Arg<glm::ivec2>& edge_verts, const Arg<int>& corner_verts,
                    const Arg<int>& corner_edges, const Arg<int>& polygon_offsets,
                    const Optional<glm::ivec3>& ngon_triangles, const Optional<int>& ngon_polygon,
                    const Optional<int>& material, const Optional<std::uint8_t>& occluding,
                    const Optional<std::uint8_t>& sharp_edges, const Optional<std::uint8_t>& seams,
                    const Optional<std::uint8_t>& edge_marks) {
    MeshArrays mesh;
    mesh.positions = borrow<vec3>(positions, "positions");
    mesh.edge_verts = borrow<glm::ivec2>(edge_verts, "edge_verts");
    mesh.corner_verts = borrow<int>(corner_verts, "corner_verts");
    mesh.corner_edges = borrow<int>(corner_edges, "corner_edges");
    mesh.polygon_offsets = borrow<int>(polygon_offsets, "polygon_offsets");
    mesh.ngon_triangles = borrow<glm::ivec3>(ngon_triangles, "ngon_triangles");
    mesh.ngon_polygon = borrow<int>(ngon_polygon, "ngon_polygon");
    mesh.material = borrow<int>(material, "material");
    mesh.occluding = borrow<std::uint8_t>(occluding, "occluding");
    mesh.sharp = borrow<std::uint8_t>(sharp_edges, "sharp_edges");
    mesh.seam = borrow<std::uint8_t>(seams, "seams");
    mesh.edge_mark = borrow<std::uint8_t>(edge_marks, "edge_marks");
    return mesh;
}

std::shared_ptr<Surface> make_surface(const std::string& name, const Arg<vec3>& positions,
                                      const Arg<glm::ivec2>& edge_verts, const Arg<int>& corner_verts,
                                      const Arg<int>& corner_edges, const Arg<int>& polygon_offsets,
                                      const Optional<glm::ivec3>& ngon_triangles, const Optional<int>& ngon_polygon,
                                      const Optional<int>& material, const Optional<std::uint8_t>& occluding,
                                      const Optional<std::uint8_t>& sharp_edges, const Optional<std::uint8_t>& seams,
                                      const Optional<std::uint8_t>& edge_marks) {
    const MeshArrays mesh = borrowed(positions, edge_verts, corner_verts, corner_edges, polygon_offsets, ngon_triangles,
                                     ngon_polygon, material, occluding, sharp_edges, seams, edge_marks);
    py::gil_scoped_release release;
    return std::make_shared<Surface>(name, mesh);
}

void set_field_options(Surface& surface, const std::string& estimator, int degree, int rings, double smoothing) {
    FieldOptions options{.degree = degree, .rings = rings, .smoothing = smoothing};
    if (estimator == "jets")
        options.estimator = Estimator::jets;
    else if (estimator == "one_ring")
        options.estimator = Estimator::one_ring;
    else
        check(estimator == "automatic", surface.name() + ": no estimator of curvature is called '" + estimator +
                                            "'; there are: automatic, jets, one_ring");
    surface.set_field_options(options);
}

std::shared_ptr<RefinedSurface> make_refined(
    const std::string& name, const Arg<vec3>& positions, const Arg<glm::ivec2>& edge_verts,
    const Arg<int>& corner_verts, const Arg<int>& corner_edges, const Arg<int>& polygon_offsets, int level,
    bool round_corners, const Optional<float>& edge_creases, const Optional<float>& vertex_creases,
    const Optional<int>& material, const Optional<std::uint8_t>& occluding, const Optional<std::uint8_t>& sharp_edges,
    const Optional<std::uint8_t>& seams, const Optional<std::uint8_t>& edge_marks) {
    const MeshArrays mesh = borrowed(positions, edge_verts, corner_verts, corner_edges, polygon_offsets, {}, {},
                                     material, occluding, sharp_edges, seams, edge_marks);
    const Refinement refinement{level, round_corners, borrow<float>(edge_creases, "edge_creases"),
                                borrow<float>(vertex_creases, "vertex_creases")};
    py::gil_scoped_release release;
    return std::make_shared<RefinedSurface>(name, mesh, refinement);
}

/// The arrays as Surface takes them, None for those that are empty and optional, and the report.
py::tuple repaired_arrays(const std::string& name, const Arg<vec3>& positions, const Arg<glm::ivec2>& edge_verts,
                          const Arg<int>& corner_verts, const Arg<int>& corner_edges, const Arg<int>& polygon_offsets,
                          const Optional<glm::ivec3>& ngon_triangles, const Optional<int>& ngon_polygon,
                          const Optional<int>& material, const Optional<std::uint8_t>& occluding,
                          const Optional<std::uint8_t>& sharp_edges, const Optional<std::uint8_t>& seams,
                          const Optional<std::uint8_t>& edge_marks, bool orient, int resample, double edge_length) {
    const MeshArrays mesh = borrowed(positions, edge_verts, corner_verts, corner_edges, polygon_offsets, ngon_triangles,
                                     ngon_polygon, material, occluding, sharp_edges, seams, edge_marks);
    RepairedMesh out;
    {
        py::gil_scoped_release release;
        out = repaired(name, mesh, {orient, resample, edge_length});
    }
    const auto array = [](const auto& values) {
        using T = typename std::decay_t<decltype(values)>::value_type;
        return to_numpy(Array<T>(values.begin(), values.end()));
    };
    const auto optional = [&](const auto& values) -> py::object {
        if (values.empty()) return py::none();
        return array(values);
    };
    const py::dict report(py::arg("turned_polygons") = out.report.turned_polygons,
                          py::arg("refused_polygons") = out.report.refused_polygons);
    return py::make_tuple(
        py::make_tuple(array(out.positions), array(out.edge_verts), array(out.corner_verts), array(out.corner_edges),
                       array(out.polygon_offsets), optional(out.ngon_triangles), optional(out.ngon_polygon),
                       optional(out.material), optional(out.occluding), optional(out.sharp), optional(out.seam),
                       optional(out.edge_mark)),
        report);
}

py::dict report(const Surface& surface) {
    const SurfaceReport& r = surface.report();
    py::dict counts;
    counts["non_finite_vertices"] = r.non_finite_vertices;
    counts["degenerate_polygons"] = r.degenerate_polygons;
    counts["duplicate_polygons"] = r.duplicate_polygons;
    counts["loose_edges"] = r.loose_edges;
    counts["non_manifold_edges"] = r.non_manifold_edges;
    counts["inconsistent_edges"] = r.inconsistent_edges;
    return counts;
}

}  // namespace

void bind_mesh(py::module_& m) {
    py::class_<Surface, std::shared_ptr<Surface>>(
        m, "Surface",
        "A mesh with its edge table, facets and what is derived from them; see native/fovea/mesh/surface.h.")
        .def(py::init(&make_surface), py::arg("name"), py::arg("positions"), py::arg("edge_verts"),
             py::arg("corner_verts"), py::arg("corner_edges"), py::arg("polygon_offsets"),
             py::arg("ngon_triangles") = py::none(), py::arg("ngon_polygon") = py::none(),
             py::arg("material") = py::none(), py::arg("occluding") = py::none(), py::arg("sharp_edges") = py::none(),
             py::arg("seams") = py::none(), py::arg("edge_marks") = py::none(),
             R"(positions (V, 3) float32 in object space; edge_verts (E, 2), corner_verts (C,), corner_edges (C,),
polygon_offsets (F + 1,) int32 as Blender stores them; ngon_triangles (T, 3) vertices with ngon_polygon (T,) ascending:
triangulation of polygons with more than four corners; material (F,) int32; occluding (F,), sharp_edges, seams,
edge_marks (E,) bool. Raises ValueError, naming the object, where sizes or indices do not fit together.)")
        .def(
            "set_positions",
            [](Surface& surface, const Arg<vec3>& positions, bool refit) {
                const In<vec3> moved = borrow<vec3>(positions, "positions");
                py::gil_scoped_release release;
                surface.set_positions(moved, refit);
            },
            py::arg("positions"), py::kw_only(), py::arg("refit") = false,
            R"(Moves the vertices, (V, 3) float32; the topology stays. refit: rays follow by a refitted BVH instead of a new
one, which is faster; distances then differ in their last bits from those of a new surface.)")
        .def("set_field_options", &set_field_options, py::arg("estimator") = "automatic", py::arg("degree") = 0,
             py::arg("rings") = 0, py::arg("smoothing") = 0.0,
             R"(How curvature is estimated from now on. estimator: automatic, jets or one_ring; degree (2 to 4) and
rings (1 to 32) of jets, 0: automatic; smoothing: deviation, in edge lengths, of the Gaussian it is averaged with.)")
        .def_property_readonly(
            "fields_reason", [](const Surface& surface) { return fields_reason(surface); },
            "How curvature was estimated, and why, in one sentence; empty while no line has asked for it.")
        .def_property_readonly("name", &Surface::name)
        .def_property_readonly("version", &Surface::version, "Changes whenever the positions do.")
        .def_property_readonly("report", &report, "Counts of what was skipped or looked wrong.")
        .def_property_readonly("positions",
                               [](py::object self) {
                                   const auto& surface = self.cast<const Surface&>();
                                   py::array all = view_numpy(surface.positions, self);
                                   return py::object(all[py::slice(0, surface.vertex_count(), 1)]);
                               })
        .def_property_readonly(
            "triangles", [](py::object self) { return view_numpy(self.cast<const Surface&>().triangles, self); },
            "(T, 3) uint32 vertices; occluding ones first")
        .def_property_readonly(
            "triangle_facet",
            [](py::object self) { return view_numpy(self.cast<const Surface&>().triangle_facet, self); })
        .def_property_readonly("occluding_triangles", [](const Surface& s) { return s.occluding_triangles; })
        .def_property_readonly("edges",
                               [](py::object self) { return view_numpy(self.cast<const Surface&>().edges, self); })
        .def_property_readonly("mesh_edges", [](const Surface& s) { return s.mesh_edges; })
        .def_property_readonly("facet_count", &Surface::facet_count)
        .def_property_readonly("polygon_count", &Surface::polygon_count);

    py::class_<RefinedSurface, Surface, std::shared_ptr<RefinedSurface>>(
        m, "RefinedSurface",
        "The refined mesh of a cage, on the limit of its subdivision; see native/fovea/mesh/refine.h.")
        .def(py::init(&make_refined), py::arg("name"), py::arg("positions"), py::arg("edge_verts"),
             py::arg("corner_verts"), py::arg("corner_edges"), py::arg("polygon_offsets"), py::arg("level"),
             py::arg("round_corners") = true, py::arg("edge_creases") = py::none(),
             py::arg("vertex_creases") = py::none(), py::arg("material") = py::none(),
             py::arg("occluding") = py::none(), py::arg("sharp_edges") = py::none(), py::arg("seams") = py::none(),
             py::arg("edge_marks") = py::none(),
             R"(The cage's arrays as Surface takes them; level 1 to 7; round_corners: also at corners of one polygon on
a border; edge_creases (E,) and vertex_creases (V,) float32, weights from 0 to 1. Raises ValueError, naming the object,
for a cage without a limit surface.)")
        .def(
            "set_positions",
            [](RefinedSurface& surface, const Arg<vec3>& positions, bool refit) {
                const In<vec3> moved = borrow<vec3>(positions, "positions");
                py::gil_scoped_release release;
                surface.move_cage(moved, refit);
            },
            py::arg("positions"), py::kw_only(), py::arg("refit") = false,
            "Moves the cage's vertices, (V, 3) float32; the topology stays. refit: as Surface has it.")
        .def(
            "mix_corners",
            [](const RefinedSurface& surface, const Arg<float>& values, const Arg<int>& polygon_offsets) {
                check(values.ndim() == 2, surface.name() + ": values of shape (C, columns) expected");
                const In<float> all(values.data(), std::size_t(values.size()));
                const In<int> offsets = borrow<int>(polygon_offsets, "polygon_offsets");
                const auto columns = values.shape(1);
                Array<float> mixed;
                {
                    py::gil_scoped_release release;
                    mixed = surface.mix_corners(all, int(columns), offsets);
                }
                const auto corners = py::ssize_t(mixed.size()) / columns;
                return to_numpy(std::move(mixed)).reshape({corners, columns});
            },
            py::arg("values"), py::arg("polygon_offsets"),
            "(C, k) float32 at the corners of the cage, mixed to those of the refined mesh.");

    m.def(
        "repaired", &repaired_arrays, py::arg("name"), py::arg("positions"), py::arg("edge_verts"),
        py::arg("corner_verts"), py::arg("corner_edges"), py::arg("polygon_offsets"),
        py::arg("ngon_triangles") = py::none(), py::arg("ngon_polygon") = py::none(), py::arg("material") = py::none(),
        py::arg("occluding") = py::none(), py::arg("sharp_edges") = py::none(), py::arg("seams") = py::none(),
        py::arg("edge_marks") = py::none(), py::arg("orient") = false, py::arg("resample") = 0,
        py::arg("edge_length") = 0.0,
        R"(A mesh put in order, see native/fovea/repair/repair.h: a tuple of the arrays that Surface takes after its name,
and a dict of counts. Raises ValueError, naming the object, as Surface does.)");

    m.def(
        "polygon_edges",
        [](const Arg<int>& polygon_offsets, const Arg<int>& corner_verts) {
            PolygonEdges edges = polygon_edges(borrow<int>(polygon_offsets, "polygon_offsets"),
                                               borrow<int>(corner_verts, "corner_verts"));
            return py::make_tuple(to_numpy(std::move(edges.edge_verts)), to_numpy(std::move(edges.corner_edges)));
        },
        py::arg("polygon_offsets"), py::arg("corner_verts"),
        "The edges (E, 2) of polygons without an edge list, and per corner the edge to the next, both int32.");

    m.def(
        "content_hash",
        [](const py::array& array) {
            check(array.flags() & py::array::c_style, "content_hash: a contiguous array is needed");
            const auto size = static_cast<std::size_t>(array.nbytes());
            const void* data = array.data();
            py::gil_scoped_release release;
            return hash_bytes(data, size);
        },
        py::arg("array"), "64-bit hash of an array's bytes.");
}

}  // namespace fovea::bindings
