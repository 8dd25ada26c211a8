// SPDX-License-Identifier: GPL-3.0-or-later
// A line definition: a named, stateless rule that finds lines on a surface, in a scene or in its image.
// To add one: a file in this folder that ends with a LineDefinition constant, one line in registry.cpp, and one page in
// addon/docs/lines. All that others must know of it are members of the constant.
#pragma once

#include <functional>
#include <utility>
#include <variant>
#include <vector>

#include <fovea/base/parallel.h>
#include <fovea/base/view.h>
#include <fovea/line/curves.h>
#include <fovea/line/parameter.h>
#include <fovea/mesh/surface.h>
#include <fovea/scene/tracer.h>

namespace fovea::line {

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
    /// Whether the placement does not go on behind a point in view space.
    bool ends_at(const vec3& point, const Ignore& ignore) const {
        const auto behind = tracer->behind(point, ignore);
        return !behind || behind->placement != placement;
    }
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

struct LineDefinition;

/// Lines along edges: sets `bit` in kinds[e] for every edge e of the surface (mesh edges and diagonals) that is one.
struct EdgeRule {
    std::function<void(const SurfaceView& seen, const Values& values, Kinds bit, Array<Kinds>& kinds)> mark;
};

/// What curves across triangles are, which decides what becomes of them once they are chained (path/find_curves.h).
enum class CurveType {
    level_set,  ///< of a quantity: all of them are lines
    feature,    ///< of the surface's shape: not where they double a contour, nor the spurs at their ends
    contour,    ///< on the smooth surface that the mesh stands for, not on its flat triangles, which hide them in part
};

/// Lines across triangles. A rule that depends on the view says which clusters of triangles cannot hold a line
/// (line/seen_cluster.h) and what it needs to know of a vertex of the others; line/cluster_trace.h does the rest.
struct CurveRule {
    CurveType type;
    std::function<Curves(const SurfaceView& seen, const Values& values)> find;
    /// Which stretches of chained pieces are lines.
    std::function<Selection(const Surface& surface, const Values& values)> select = [](const Surface&, const Values&) {
        return Selection{};
    };
    /// The definition of which this one finds some of the pieces: whichever line set comes first has them.
    const LineDefinition* part_of = nullptr;
};

/// Lines across triangles of the whole scene: those of the placements that are drawn.
struct SceneRule {
    std::function<std::vector<SceneCurves>(const Scene& scene, In<Index> drawn, const Values& values,
                                           const Cancel& cancel)>
        find;
};

/// Lines in the image, once per frame. Points in view space; triangles and sides are those of a lattice.
struct ImageRule {
    std::function<Curves(const FrameView& frame, const Values& values)> find;
};

/// What drafts draw where a definition is left out of them: another one, with some of its parameters by name.
struct StandIn {
    const LineDefinition* definition;
    std::vector<std::pair<const char*, double>> values = {};
};

struct LineDefinition {
    const char* name;  ///< the id used everywhere
    const char* label;
    const char* source;  ///< paper or common knowledge, with its section
    const char* description;
    Scope scope;
    double importance;  ///< in (0, 1]: of lines that crowd each other the more important one stays (elision/priority.h)
    std::vector<Parameter> parameters = {};
    std::variant<EdgeRule, CurveRule, SceneRule, ImageRule> rule;
    /// The same line of the smooth surface, which goes before this one of the mesh where both are drawn.
    const LineDefinition* smooth_twin = nullptr;
    bool slow = false;                    ///< takes long to find for each view: drafts leave it out
    std::vector<StandIn> stand_ins = {};  ///< in drafts, where they are the outer boundary of their object
    bool reads_edge_marks = false;        ///< of Freestyle, which are read from Blender only where they are asked for
};

/// Of all its parameters.
inline Values default_values(const LineDefinition& definition) {
    Values values;
    for (const Parameter& parameter : definition.parameters) values.push_back(parameter.value);
    return values;
}

}  // namespace fovea::line
