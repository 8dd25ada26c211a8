// SPDX-License-Identifier: GPL-3.0-or-later
// A line definition: a named, stateless rule that finds lines on a surface seen from a view.
// To add one: a file in this folder that ends with a LineDefinition constant, and one line in registry.cpp.
#pragma once

#include <vector>

#include <fovea/base/parallel.h>
#include <fovea/base/view.h>
#include <fovea/line/curves.h>
#include <fovea/mesh/surface.h>
#include <fovea/scene/tracer.h>

namespace fovea {

/// A number the artist may set. Declared here once; panels, files and the command line read it from the registry.
struct Parameter {
    const char* name;
    const char* label;
    double value;  ///< default
    double low, high;
    const char* unit;  ///< "degrees", "" for a plain number, "bool" for a switch
    const char* meaning;
};

/// Values of a definition's parameters, in the order they are declared.
using Values = std::vector<double>;

/// A surface as one placement of it is seen. Its space is that of the object where the placement keeps angles, else the
/// stretched one of mesh/stretch.h, so that definitions never see a scale that is uneven.
struct SurfaceView {
    const Surface& surface;
    /// Eye in the surface's space; for an orthographic camera the direction towards it.
    dvec3 eye_obj{0.0};
    bool orthographic = false;
    /// Per facet: 1 where it faces the viewer (zero counts as facing). Empty when no definition asked for it.
    Array<std::uint8_t> facing{};
    /// For definitions of the scene: the placement and rays through the view; null for definitions of a surface.
    Index placement = 0;
    dmat4 object_to_view{1.0};  ///< from the surface's space
    const Tracer* tracer = nullptr;
    /// Clusters that cannot hold a line are passed over; the result is the same without.
    bool pass_over = true;

    /// From a point or vertex towards the viewer, in the surface's space; not normalized.
    vec3 to_viewer(const vec3& point) const { return orthographic ? vec3(eye_obj) : vec3(eye_obj - dvec3(point)); }
    vec3 to_viewer(Index vertex) const { return to_viewer(surface.positions[vertex]); }
};

/// A frame, for definitions that look at a picture of the scene.
struct FrameView {
    const Tracer& tracer;
    const Cancel& cancel;
    Cache& shared;  ///< of the frame: pictures that several definitions look at
};

/// What an edge is: bit b is set where the definition with bit b in the registry finds it.
using Kinds = std::uint32_t;

/// Which quantities a definition depends on.
enum class Scope {
    surface,     ///< the surface alone: found once and kept
    placements,  ///< all surfaces and where they are, not the view: found once for the scene, and kept
    view,        ///< the surface and the eye
    scene,       ///< also what lies around and behind it
};

struct LineDefinition {
    const char* name;  ///< the id used everywhere
    const char* label;
    const char* source;  ///< paper or common knowledge, with its section
    const char* description;
    Scope scope;
    std::vector<Parameter> parameters;
    bool on_by_default;
    /// Lines along edges: sets `bit` in kinds[e] for every edge e of the surface (mesh edges and diagonals) that is
    /// one.
    void (*trace)(const SurfaceView& seen, const Values& values, Kinds bit, Array<Kinds>& kinds) = nullptr;
    /// Lines across triangles, instead. One that depends on the view says which clusters of triangles cannot hold it
    /// (line/seen_cluster.h) and what it needs to know of a vertex of the others; line/cluster_trace.h does the rest.
    Curves (*find)(const SurfaceView& seen, const Values& values) = nullptr;
    /// Lines in the image, instead: once per frame. Points in view space; triangles and sides are those of a lattice.
    Curves (*find_in_image)(const FrameView& frame, const Values& values) = nullptr;
    /// Of such lines, which chains of pieces stay; null: all.
    Selection (*select)(const Surface& surface, const Values& values) = nullptr;
    /// Such lines are where the smooth surface is that the mesh stands for, not on its flat triangles: there contours
    /// are seen from the side.
    bool on_smooth_surface = false;
    /// The definition of which this one finds some of the pieces: whichever line set comes first has them.
    const LineDefinition* part_of = nullptr;
    /// Lines across triangles of the whole scene, instead: those of the placements that are drawn.
    std::vector<SceneCurves> (*find_in_scene)(const Scene& scene, In<Index> drawn, const Values& values,
                                              const Cancel& cancel) = nullptr;
};

}  // namespace fovea
