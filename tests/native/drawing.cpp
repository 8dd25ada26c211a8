// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing.h"

namespace fovea::drawing {
using namespace draw;

Scene cut_open(std::vector<Placement> placements, const std::optional<dvec4>& section) {
    Scene scene(std::move(placements));
    scene.section = section;
    return scene;
}

Drawing::Drawing(std::vector<Placement> placements, const View& seen, const std::vector<LineSet>& sets,
                 const ProjectOptions& options, const std::optional<dvec4>& section)
    : scene(cut_open(std::move(placements), section)),
      view(seen),
      tracer(scene, view),
      paths(extract_paths(scene, view, sets, tracer, Cancel())),
      clipped(project::project(paths, scene, view, options, Cancel())),
      runs(exact_visibility(clipped, paths, tracer, Cancel())) {}

std::map<Index, Kinds> Drawing::lines(Index placement) const {
    std::map<Index, Kinds> found;
    for (Index p = 0; p < paths.count(); ++p) {
        if (paths.placement[p] != placement) continue;
        for (Index i = paths.rows.begin(p); i + 1 < paths.rows.end(p); ++i)
            if (!found.emplace(paths.place[i], paths.kinds[i]).second) found[none] = 0;
    }
    return found;
}

Drawing::Length Drawing::length_of(Index edge, Index placement) const {
    Length length;
    for (Index q = 0; q < clipped.pieces.count(); ++q) {
        if (paths.placement[clipped.path[q]] != placement) continue;
        for (Index i = clipped.pieces.begin(q); i + 1 < clipped.pieces.end(q); ++i) {
            if (paths.place[clipped.source[i]] != edge) continue;
            const double from = clipped.arc_px[i], to = clipped.arc_px[i + 1];
            length.all += to - from;
            for (std::size_t r = 0; r < runs.piece.size(); ++r)
                if (runs.piece[r] == q)
                    length.visible += std::max(0.0, std::min(to, runs.end_px[r]) - std::max(from, runs.start_px[r]));
        }
    }
    return length;
}

std::set<Index> Drawing::visible_edges(Index placement) const {
    std::set<Index> edges;
    for (const auto& [edge, kinds] : lines(placement)) {
        const Length length = length_of(edge, placement);
        if (length.visible > 0.5 * length.all) edges.insert(edge);
    }
    return edges;
}

double Drawing::visible_px(Index placement) const {
    double sum = 0.0;
    for (std::size_t r = 0; r < runs.piece.size(); ++r)
        if (paths.placement[clipped.path[runs.piece[r]]] == placement) sum += runs.end_px[r] - runs.start_px[r];
    return sum;
}

double Drawing::total_px(Index placement) const {
    double sum = 0.0;
    for (Index q = 0; q < clipped.pieces.count(); ++q)
        if (paths.placement[clipped.path[q]] == placement)
            sum += clipped.arc_px[clipped.pieces.end(q) - 1] - clipped.arc_px[clipped.pieces.begin(q)];
    return sum;
}

dmat4 look_at(dvec3 eye, dvec3 target) {
    const bool vertical = glm::length(glm::cross(target - eye, dvec3(0, 0, 1))) < 1e-9;
    return glm::lookAt(eye, target, vertical ? dvec3(0, 1, 0) : dvec3(0, 0, 1));
}

View perspective(dvec3 eye, dvec3 target, double lens, int width, int height) {
    View view;
    view.world_to_view = look_at(eye, target);
    view.width = width;
    view.height = height;
    const double right = view.near_clip * 18.0 / lens, top = right * height / width;
    view.view_to_clip = glm::frustum(-right, right, -top, top, view.near_clip, view.far_clip);
    return view;
}

View orthographic(dvec3 eye, dvec3 target, double across, int width, int height) {
    View view;
    view.world_to_view = look_at(eye, target);
    view.width = width;
    view.height = height;
    view.orthographic = true;
    const double right = across / 2.0, top = right * height / width;
    view.view_to_clip = glm::ortho(-right, right, -top, top, view.near_clip, view.far_clip);
    return view;
}

View with_near(View view, double near_clip) {
    const dmat4& old = view.view_to_clip;
    const double right = near_clip / old[0][0], top = near_clip / old[1][1];
    view.near_clip = near_clip;
    view.view_to_clip = view.orthographic ? glm::ortho(-1.0 / old[0][0], 1.0 / old[0][0], -1.0 / old[1][1],
                                                       1.0 / old[1][1], near_clip, view.far_clip)
                                          : glm::frustum(-right, right, -top, top, near_clip, view.far_clip);
    return view;
}

dvec2 pixel_of(const View& view, dvec3 world) {
    return to_pixels(view, view.view_to_clip * view.world_to_view * dvec4(world, 1.0));
}

Kinds bit_of(const char* definition) { return Kinds(1 << definition_index(definition)); }

LineSet line_set(const std::vector<const char*>& names, double corner_degrees) {
    LineSet set;
    set.corner_angle_rad = glm::radians(corner_degrees);
    for (const char* name : names)
        set.kinds.push_back({definition_index(name), default_values(definition_called(name))});
    return set;
}

LineSet line_set_with(const char* name, const Values& values, double corner_degrees) {
    LineSet set = line_set({name}, corner_degrees);
    std::ranges::copy(values, set.kinds[0].values.begin());
    return set;
}

LineSet all_edges() { return line_set_with("crease", {0, 1}); }

Placement place(const meshes::Mesh& mesh, dmat4 object_to_world, std::uint64_t id, int usage) {
    return {mesh.surface(), object_to_world, id, std::uint8_t(usage)};
}

dmat4 moved(dvec3 by) { return glm::translate(dmat4(1.0), by); }

dmat4 scaled(dvec3 by) { return glm::scale(dmat4(1.0), by); }

}  // namespace fovea::drawing
