// SPDX-License-Identifier: GPL-3.0-or-later
// Prints how many edges of a box one sees.
#include <glm/gtc/matrix_transform.hpp>
#include <iostream>

#include <fovea/mesh/polygon_edges.h>
#include <fovea/path/extract.h>
#include <fovea/project/project.h>
#include <fovea/visibility/exact.h>

int main() {
    using namespace fovea;
    std::vector<vec3> corners;
    for (int i = 0; i < 8; ++i) corners.push_back(vec3(i & 1, i >> 1 & 1, i >> 2));
    const std::vector<int> verts{0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
    const std::vector<int> polygons{0, 4, 8, 12, 16, 20, 24};
    const PolygonEdges edges = polygon_edges(polygons, verts);
    MeshArrays mesh;
    mesh.positions = corners;
    mesh.edge_verts = edges.edge_verts;
    mesh.corner_verts = verts;
    mesh.corner_edges = edges.corner_edges;
    mesh.polygon_offsets = polygons;
    const auto box = std::make_shared<Surface>("box", mesh);
    const Scene scene(std::vector<Placement>{{box}});

    View view;
    view.width = view.height = 400;
    view.world_to_view = glm::lookAt(dvec3(4, -3, 2.5), dvec3(0.5), dvec3(0, 0, 1));
    view.view_to_clip = glm::perspective(0.5, 1.0, view.near_clip, view.far_clip);

    const Tracer tracer(scene, view);
    const Cancel cancel;
    const LineSet creases{.kinds = {{definition_index("crease"), {30.0, 1.0}}}, .corner_angle_rad = 0.5};
    const Paths paths = extract_paths(scene, view, {creases}, tracer, cancel);
    const ClippedPaths clipped = project(paths, scene, view, {}, cancel);
    std::cout << exact_visibility(clipped, paths, tracer, cancel).size() << " visible lines\n";
}
