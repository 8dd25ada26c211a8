// SPDX-License-Identifier: GPL-3.0-or-later
// Cameras by eye and target, and the whole way from placements to visible runs.
#pragma once

#include <glm/gtc/matrix_transform.hpp>
#include <set>

#include <fovea/path/extract.h>
#include <fovea/project/project.h>
#include <fovea/visibility/exact.h>

#include "meshes.h"

namespace fovea::drawing {
using namespace draw;

dmat4 look_at(dvec3 eye, dvec3 target);

/// A camera with a lens in millimetres over a sensor 36 mm wide.
View perspective(dvec3 eye, dvec3 target, double lens = 50.0, int width = 640, int height = 480);

/// An orthographic camera that sees `across` units from the left to the right border.
View orthographic(dvec3 eye, dvec3 target, double across, int width = 640, int height = 480);

/// The same camera with another near plane.
View with_near(View view, double near_clip);

/// Where a point of the world falls in the image.
dvec2 pixel_of(const View& view, dvec3 world);

Kinds bit_of(const char* definition);

/// A line set of definitions with their defaults.
LineSet line_set(const std::vector<const char*>& names, double corner_degrees = 60.0);

/// One definition with values of its own.
LineSet line_set_with(const char* name, const Values& values, double corner_degrees = 60.0);

/// Every edge of a mesh. A function, as definitions are not there yet where the constants of other files are made.
LineSet all_edges();

Placement place(const meshes::Mesh& mesh, dmat4 object_to_world = dmat4(1.0), std::uint64_t id = 1,
                int usage = usage_draw | usage_occlude);
dmat4 moved(dvec3 by);
dmat4 scaled(dvec3 by);

/// A scene that a plane (with a unit normal) cuts open.
Scene cut_open(std::vector<Placement> placements, const std::optional<dvec4>& section);

/// From the right, in front and above.
inline const View corner_view = perspective({4, -5, 3}, {0, 0, 0});

/// One picture, from placements to runs.
struct Drawing {
    Scene scene;
    View view;
    Tracer tracer;
    Paths paths;
    ClippedPaths clipped;
    Runs runs;

    Drawing(std::vector<Placement> placements, const View& seen, const std::vector<LineSet>& sets,
            const ProjectOptions& options = {}, const std::optional<dvec4>& section = {});
    Drawing(const Drawing&) = delete;

    /// Edges of a placement that are lines, each with its kinds; `none` is among them when an edge appears twice.
    std::map<Index, Kinds> lines(Index placement = 0) const;

    /// Pixels of a mesh edge inside the frame, and how many of them are visible.
    struct Length {
        double all = 0.0, visible = 0.0;
    };
    Length length_of(Index edge, Index placement = 0) const;

    /// Edges of a placement that are visible over more than half of their length.
    std::set<Index> visible_edges(Index placement = 0) const;

    double visible_px(Index placement) const;
    double total_px(Index placement) const;
};

}  // namespace fovea::drawing
