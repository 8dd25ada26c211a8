// SPDX-License-Identifier: GPL-3.0-or-later
#include "wires.h"

namespace fovea::wires {
using namespace draw;

Wires::Wires(const std::vector<std::vector<dvec3>>& lines, dmat4 object_to_world,
             const std::vector<Placement>& others) {
    meshes::Mesh mesh("wires", {});
    for (const auto& line : lines) {
        const int begin = static_cast<int>(mesh.positions.size());
        for (const dvec3& point : line) mesh.positions.push_back(vec3(point));
        const int first_edge = static_cast<int>(mesh.edge_verts.size());
        for (std::size_t i = 0; i + 1 < line.size(); ++i) mesh.edge(begin + int(i), begin + int(i) + 1);
        double arc = 0.0;
        for (std::size_t i = 0; i < line.size(); ++i) {
            const int last_edge = static_cast<int>(mesh.edge_verts.size()) - 1;
            paths.points_obj.push_back(vec3(line[i]));
            arc = i > 0 ? arc + glm::distance(line[i - 1], line[i]) : 0.0;
            paths.arc_obj.push_back(arc);
            paths.place.push_back(Index(std::max(0, std::min(first_edge + int(i), last_edge))));
            paths.edge_t.push_back(i + 1 == line.size() && i > 0 ? 1.0f : 0.0f);
            paths.kinds.push_back(1);
            paths.strength.push_back(1.0f);
        }
        paths.closed.push_back(line.size() > 2 && line.front() == line.back());
        paths.id.push_back(paths.id.size());
        paths.placement.push_back(0);
        paths.line_set.push_back(0);
        paths.free_ends.push_back(0);
        paths.of_view.push_back(0);
        paths.rows.offsets.push_back(Index(paths.points_obj.size()));
    }
    if (mesh.edge_verts.empty()) {  // a path of one point still names an edge
        mesh.positions.resize(std::max<std::size_t>(mesh.positions.size(), 1));
        mesh.edge(0, 0);
    }
    std::vector<Placement> placements{drawing::place(mesh, object_to_world)};
    placements.insert(placements.end(), others.begin(), others.end());
    scene = Scene(std::move(placements));
}

ClippedPaths Wires::project(const View& view, const ProjectOptions& options) const {
    return project::project(paths, scene, view, options, Cancel());
}

View camera(double near_clip, bool orthographic) {
    View view;
    view.width = 640;
    view.height = 480;
    view.near_clip = near_clip;
    view.orthographic = orthographic;
    const double n = near_clip;
    view.view_to_clip = orthographic ? glm::ortho(-0.8, 0.8, -0.6, 0.6, n, view.far_clip)
                                     : glm::frustum(-0.8 * n, 0.8 * n, -0.6 * n, 0.6 * n, n, view.far_clip);
    return view;
}

View cropped(const View& view, int x0, int y0, int x1, int y1) {
    View crop = view;
    crop.width = x1 - x0;
    crop.height = y1 - y0;
    const double sx = double(view.width) / crop.width, sy = double(view.height) / crop.height;
    const dvec2 middle((x0 + x1) / double(view.width) - 1.0, (y0 + y1) / double(view.height) - 1.0);
    crop.view_to_clip =
        glm::scale(dmat4(1.0), dvec3(sx, sy, 1)) * glm::translate(dmat4(1.0), dvec3(-middle, 0)) * view.view_to_clip;
    return crop;
}

ClippedPaths project_line(const std::vector<dvec3>& line, const View& view, const ProjectOptions& options) {
    return Wires({line}).project(view, options);
}

Index first_of(const ClippedPaths& clipped, Index piece) { return clipped.pieces.begin(piece); }

Index last_of(const ClippedPaths& clipped, Index piece) { return clipped.pieces.end(piece) - 1; }

}  // namespace fovea::wires
