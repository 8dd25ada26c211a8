// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes and surfaces.
#include <fovea/field/fields.h>
#include <fovea/field/shape.h>
#include <fovea/mesh/equal_polygons.h>
#include <fovea/mesh/polygon_surface.h>
#include <fovea/mesh/refine.h>
#include <fovea/mesh/spheres.h>
#include <fovea/mesh/strands.h>
#include <fovea/mesh/surface.h>
#include <fovea/repair/repair.h>

#include "bindings/arrays.h"
#include "bindings/bind.h"
#include "bindings/mesh.h"
#include "bindings/records.h"
#include "bindings/words.h"

namespace fovea::bindings {
namespace {

Mesh make_mesh(const Arg<vec3>& positions, const Arg<glm::ivec2>& edge_verts, const Arg<int>& corner_verts,
               const Arg<int>& corner_edges, const Arg<int>& polygon_offsets,
               const Optional<glm::ivec3>& ngon_triangles, const Optional<int>& ngon_polygon,
               const Optional<int>& material, const Optional<std::uint8_t>& occluding,
               const Optional<std::uint8_t>& sharp_edges, const Optional<std::uint8_t>& seams,
               const Optional<std::uint8_t>& edge_marks, const Optional<std::uint8_t>& smooth_edges,
               const Optional<std::uint8_t>& one_sided) {
    Mesh mesh;
    auto& [arrays, owners] = mesh;
    arrays.positions = kept<vec3>(positions, "positions", owners);
    arrays.edge_verts = kept<glm::ivec2>(edge_verts, "edge_verts", owners);
    arrays.corner_verts = kept<int>(corner_verts, "corner_verts", owners);
    arrays.corner_edges = kept<int>(corner_edges, "corner_edges", owners);
    arrays.polygon_offsets = kept<int>(polygon_offsets, "polygon_offsets", owners);
    arrays.ngon_triangles = kept<glm::ivec3>(ngon_triangles, "ngon_triangles", owners);
    arrays.ngon_polygon = kept<int>(ngon_polygon, "ngon_polygon", owners);
    arrays.material = kept<int>(material, "material", owners);
    arrays.occluding = kept<std::uint8_t>(occluding, "occluding", owners);
    arrays.sharp = kept<std::uint8_t>(sharp_edges, "sharp_edges", owners);
    arrays.seam = kept<std::uint8_t>(seams, "seams", owners);
    arrays.edge_mark = kept<std::uint8_t>(edge_marks, "edge_marks", owners);
    arrays.smooth = kept<std::uint8_t>(smooth_edges, "smooth_edges", owners);
    arrays.one_sided = kept<std::uint8_t>(one_sided, "one_sided", owners);
    return mesh;
}

std::shared_ptr<RefinedSurface> make_refined(const std::string& name, const Mesh& cage, int level, bool round_corners,
                                             const Optional<float>& edge_creases,
                                             const Optional<float>& vertex_creases) {
    const Refinement refinement{level, round_corners, borrow<float>(edge_creases, "edge_creases"),
                                borrow<float>(vertex_creases, "vertex_creases")};
    return without_gil([&] { return std::make_shared<RefinedSurface>(name, cage.arrays, refinement); });
}

Numpy<float> mix_corners(const RefinedSurface& surface, const Arg<float>& values, const Arg<int>& polygon_offsets) {
    check(values.ndim() == 2, surface.name() + ": values of shape (C, columns) expected");
    const In<float> all(values.data(), std::size_t(values.size()));
    const In<int> offsets = borrow<int>(polygon_offsets, "polygon_offsets");
    const auto columns = values.shape(1);
    Array<float> mixed = without_gil([&] { return surface.mix_corners(all, int(columns), offsets); });
    const auto corners = py::ssize_t(mixed.size()) / columns;
    return to_numpy(std::move(mixed)).reshape({corners, columns});
}

void bind_meshes(py::module_& m) {
    py::class_<Mesh>(m, "Mesh", "A mesh as Blender holds it; it keeps the arrays that it is made of.")
        .def(py::init(&make_mesh), py::kw_only(), py::arg("positions"), py::arg("edge_verts"), py::arg("corner_verts"),
             py::arg("corner_edges"), py::arg("polygon_offsets"), py::arg("ngon_triangles") = py::none(),
             py::arg("ngon_polygon") = py::none(), py::arg("material") = py::none(), py::arg("occluding") = py::none(),
             py::arg("sharp_edges") = py::none(), py::arg("seams") = py::none(), py::arg("edge_marks") = py::none(),
             py::arg("smooth_edges") = py::none(), py::arg("one_sided") = py::none(),
             R"(positions (V, 3) float32 in object space; edge_verts (E, 2), corner_verts (C,), corner_edges (C,),
polygon_offsets (F + 1,) int32 as Blender stores them; ngon_triangles (T, 3) vertices with ngon_polygon (T,) ascending:
triangulation of polygons with more than four corners; material (F,) int32; occluding (F,), sharp_edges, seams,
edge_marks, smooth_edges (across which shading is continuous) (E,) bool; one_sided (F,) bool: their backs are not
seen.)");

    m.def(
        "all_polygons_have",
        [](int corners, const Arg<glm::ivec2>& edge_verts, const Arg<int>& corner_verts, const Arg<int>& corner_edges) {
            check(corners == 3 || corners == 4, "all_polygons_have: 3 or 4 corners expected");
            const auto edges = borrow<glm::ivec2>(edge_verts, "edge_verts");
            const auto verts = borrow<int>(corner_verts, "corner_verts"),
                       along = borrow<int>(corner_edges, "corner_edges");
            return without_gil([&] { return all_polygons_have(corners, edges, verts, along); });
        },
        py::arg("corners"), py::arg("edge_verts"), py::arg("corner_verts"), py::arg("corner_edges"),
        "Whether the polygons of a mesh all have 3, or all 4 corners, as their edges tell.");
    py::class_<PolygonEdges, std::shared_ptr<PolygonEdges>>(m, "PolygonEdges",
                                                            "The edges of polygons that come without any.")
        .def(py::init([](const Arg<int>& polygon_offsets, const Arg<int>& corner_verts) {
                 return std::make_shared<PolygonEdges>(polygon_edges(borrow<int>(polygon_offsets, "polygon_offsets"),
                                                                     borrow<int>(corner_verts, "corner_verts")));
             }),
             py::arg("polygon_offsets"), py::arg("corner_verts"))
        .def_property_readonly("edge_verts", viewing<PolygonEdges>(&PolygonEdges::edge_verts), "(E, 2) int32")
        .def_property_readonly("corner_edges", viewing<PolygonEdges>(&PolygonEdges::corner_edges),
                               "(C,) int32: the edge from each corner to the next");

    py::class_<RepairReport>(m, "RepairReport", "How much a repair has done; counts of elements.")
        .def_readonly("turned_polygons", &RepairReport::turned_polygons)
        .def_readonly("refused_polygons", &RepairReport::refused_polygons)
        .def_readonly("too_many_triangles", &RepairReport::too_many_triangles);
    py::class_<RepairedMesh, std::shared_ptr<RepairedMesh>>(m, "RepairedMesh",
                                                            "A mesh put in order; see native/fovea/repair/repair.h.")
        .def(
            py::init([](const std::string& name, const Mesh& mesh, bool orient, int resample, double edge_length,
                        std::optional<std::uint64_t> most_triangles) {
                Repair repair{orient, resample, edge_length};
                repair.most_triangles = most_triangles.value_or(repair.most_triangles);
                return without_gil([&] { return std::make_shared<RepairedMesh>(repaired(name, mesh.arrays, repair)); });
            }),
            py::arg("name"), py::arg("mesh"), py::kw_only(), py::arg("orient") = false, py::arg("resample") = 0,
            py::arg("edge_length") = 0.0, py::arg("most_triangles") = py::none(),
            "Raises ValueError, naming the object, as Surface does.")
        .def_property_readonly("mesh",
                               [](py::object self) { return Mesh{self.cast<const RepairedMesh&>().arrays(), {self}}; })
        .def_readonly("report", &RepairedMesh::report);
}

OwnedMesh make_strands(const std::string& name, const Arg<vec3>& points, const Arg<float>& radii,
                       const Arg<int>& offsets, int steps, bool ribbons, bool occludes) {
    const Strands given{borrow<vec3>(points, "points"), borrow<float>(radii, "radii"), borrow<int>(offsets, "offsets")};
    return without_gil([&] {
        const OwnedStrands rounded = steps > 1 ? rounded_strands(name, given, steps) : OwnedStrands();
        const Strands strands = steps > 1 ? rounded.strands() : given;
        return ribbons ? strand_prisms(name, strands, occludes) : strand_wires(name, strands);
    });
}

OwnedMesh make_spheres(const std::string& name, const Arg<vec3>& centers, const Arg<float>& radii, bool occludes) {
    const auto at = borrow<vec3>(centers, "centers");
    const auto wide = borrow<float>(radii, "radii");
    return without_gil([&] { return spheres(name, at, wide, occludes); });
}

void bind_shapes(py::module_& m) {
    py::class_<OwnedMesh, std::shared_ptr<OwnedMesh>>(m, "ShapeMesh", "The mesh of what has no faces in Blender.")
        .def_static("strands", &make_strands, py::arg("name"), py::arg("points"), py::arg("radii"), py::arg("offsets"),
                    py::kw_only(), py::arg("steps") = 1, py::arg("ribbons") = true, py::arg("occludes") = true,
                    R"(points (P, 3), radii (P,) float32, offsets (S + 1,) int32: strand s has the points offsets[s] to
offsets[s + 1], two or more. steps: segments on the Catmull-Rom curve for each one; ribbons: prisms as wide as the strands,
else edges without faces; occludes: whether they hide what lies behind. Raises ValueError, naming the object.)")
        .def_static("spheres", &make_spheres, py::arg("name"), py::arg("centers"), py::arg("radii"), py::kw_only(),
                    py::arg("occludes") = true, "A sphere around each point; centers (P, 3), radii (P,) float32.")
        .def_property_readonly("mesh",
                               [](py::object self) { return Mesh{self.cast<const OwnedMesh&>().arrays(), {self}}; })
        .def_property_readonly(
            "positions",
            [](py::object self) {
                const auto& of = self.cast<const OwnedMesh&>().positions;
                return Numpy<vec3>(shape_of<vec3>(of.size()), reinterpret_cast<const float*>(of.data()), self);
            },
            "(V, 3) float32");
}

void bind_report(py::module_& m) {
    py::class_<SurfaceReport>(m, "SurfaceReport", "What of a mesh was skipped or looked wrong; counts of elements.")
        .def_readonly("non_finite_vertices", &SurfaceReport::non_finite_vertices)
        .def_readonly("degenerate_polygons", &SurfaceReport::degenerate_polygons)
        .def_readonly("duplicate_polygons", &SurfaceReport::duplicate_polygons)
        .def_readonly("loose_edges", &SurfaceReport::loose_edges)
        .def_readonly("non_manifold_edges", &SurfaceReport::non_manifold_edges)
        .def_readonly("inconsistent_edges", &SurfaceReport::inconsistent_edges);
}

void bind_arrays(SurfaceClass& surface) {
    surface
        .def_property_readonly("positions",
                               [](py::object self) {
                                   const auto& of = self.cast<const Surface&>();
                                   const Numpy<vec3> all = view_numpy(of.positions, self);
                                   return Numpy<vec3>(all[py::slice(0, of.vertex_count(), 1)]);
                               })
        .def_property_readonly("triangles", viewing<Surface>(&Surface::triangles),
                               "(T, 3) uint32 vertices; occluding ones first")
        .def_property_readonly("triangle_facet", viewing<Surface>(&Surface::triangle_facet), "(T,) uint32")
        .def_property_readonly("edges", viewing<Surface>(&Surface::edges),
                               "(E, 2) uint32 vertices; those of the mesh first")
        .def_readonly("mesh_edges", &Surface::mesh_edges)
        .def_property_readonly("facet_count", &Surface::facet_count)
        .def_property_readonly("polygon_count", &Surface::polygon_count);
}

void bind_surface(SurfaceClass& surface) {
    surface
        .def(py::init([](const std::string& name, const Mesh& mesh) {
                 return without_gil([&] { return std::make_shared<Surface>(name, mesh.arrays); });
             }),
             py::arg("name"), py::arg("mesh"),
             "Raises ValueError, naming the object, where sizes or indices do not fit together.")
        .def(
            "set_positions",
            [](Surface& surface, const Arg<vec3>& positions, bool refit) {
                const In<vec3> moved = borrow<vec3>(positions, "positions");
                without_gil([&] { surface.set_positions(moved, refit); });
            },
            py::arg("positions"), py::kw_only(), py::arg("refit") = false,
            R"(Moves the vertices, (V, 3) float32; the topology stays. refit: rays follow by a refitted BVH instead of a new
one, which is faster; which triangle a ray through the side of two hits then depends on earlier positions.)")
        .def(
            "set_rest",
            [](Surface& surface, const Optional<vec3>& positions) {
                surface.set_rest(borrow<vec3>(positions, "positions"));
            },
            py::arg("positions"),
            "Sets where the vertices, (V, 3) float32, are before what deforms the surface; None: where they are.")
        .def(
            "set_field_options",
            [](Surface& surface, const py::str& estimator, int degree, int rings, double smoothing) {
                const std::string name = surface.name() + ": estimator";
                surface.set_field_options({.estimator = value_from<Estimator>(estimator, name),
                                           .degree = degree,
                                           .rings = rings,
                                           .smoothing = smoothing});
            },
            py::arg("estimator") = "automatic", py::arg("degree") = 0, py::arg("rings") = 0, py::arg("smoothing") = 0.0,
            R"(How curvature is estimated from now on. estimator: automatic, jets or one_ring; degree (2 to 4) and
rings (1 to 32) of jets, 0: automatic; smoothing: deviation, in edge lengths, of the Gaussian it is averaged with.)")
        .def_property_readonly(
            "fields_reason", [](const Surface& surface) { return fields_reason(surface); },
            "How curvature was estimated, and why, in one sentence; empty while no line has asked for it.")
        .def(
            "set_shape",
            [](Surface& surface, const py::str& shape) {
                surface.set_shape(value_from<Shape>(shape, surface.name() + ": shape"));
            },
            py::arg("shape"),
            "What its polygons stand for from now on: hard, rounded, smooth, or automatic; see "
            "native/fovea/mesh/shape.h.")
        .def_property_readonly(
            "shape", [](const Surface& surface) { return value_to(decided_shape(surface)->shape); },
            "hard, rounded or smooth, as set or decided; see native/fovea/field/shape.h.")
        .def_property_readonly(
            "known_shape",
            [](const Surface& surface) {
                const auto known = known_shape(surface);
                return known ? std::optional(std::pair(value_to(known->shape), known->reason)) : std::nullopt;
            },
            "(shape, reason in one sentence), or None while no line has asked for it.")
        .def_property_readonly("name", &Surface::name)
        .def_property_readonly("version", &Surface::version, "Changes whenever the positions do.")
        .def_property_readonly("report", &Surface::report);
}

void bind_refined(py::module_& m) {
    py::class_<RefinedSurface, Surface, std::shared_ptr<RefinedSurface>>(
        m, "RefinedSurface",
        "The refined mesh of a cage, on the limit of its subdivision; see native/fovea/mesh/refine.h.")
        .def(py::init(&make_refined), py::arg("name"), py::arg("cage"), py::arg("level"),
             py::arg("round_corners") = true, py::arg("edge_creases") = py::none(),
             py::arg("vertex_creases") = py::none(),
             R"(level 1 to 7; round_corners: also at corners of one polygon on a border; edge_creases (E,) and
vertex_creases (V,) float32, weights from 0 to 1. Raises ValueError, naming the object, for a cage without a limit
surface.)")
        .def(
            "set_positions",
            [](RefinedSurface& surface, const Arg<vec3>& positions, bool refit) {
                const In<vec3> moved = borrow<vec3>(positions, "positions");
                without_gil([&] { surface.move_cage(moved, refit); });
            },
            py::arg("positions"), py::kw_only(), py::arg("refit") = false,
            "Moves the cage's vertices, (V, 3) float32; the topology stays. refit: as Surface has it.")
        .def(
            "set_rest",
            [](RefinedSurface& surface, const Optional<vec3>& positions) {
                const In<vec3> at_rest = borrow<vec3>(positions, "positions");
                without_gil([&] { surface.set_cage_rest(at_rest); });
            },
            py::arg("positions"), "As Surface has it, of the cage's vertices.")
        .def("mix_corners", &mix_corners, py::arg("values"), py::arg("polygon_offsets"),
             "(C, k) float32 at the corners of the cage, mixed to those of the refined mesh.");
}

}  // namespace

void bind_mesh(py::module_& m) {
    bind_meshes(m);
    bind_shapes(m);
    bind_report(m);
    SurfaceClass surface(m, "Surface", "A mesh with all that is derived from it; see native/fovea/mesh/surface.h.");
    bind_surface(surface);
    bind_arrays(surface);
    bind_fields(m, surface);
    bind_refined(m);
}

}  // namespace fovea::bindings
