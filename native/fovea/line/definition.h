// SPDX-License-Identifier: GPL-3.0-or-later
// A line definition: a named, stateless rule that finds lines on a surface, in a scene or in its image. To add one: a
// file in this folder that ends with a LineDefinition constant, one line in registry.cpp, and one page in
// addon/docs/lines. Everything that other code needs to know is a member of the constant.
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include <fovea/base/parallel.h>
#include <fovea/base/view.h>
#include <fovea/line/curves.h>
#include <fovea/line/parameter.h>
#include <fovea/mesh/surface.h>
#include <fovea/scene/shade.h>
#include <fovea/scene/tracer.h>

namespace fovea::line {

/// A surface seen in one placement. Its space is the object's if the placement preserves angles, else the pre-stretched
/// space of mesh/stretch.h, so that definitions never deal with non-uniform scale.
struct SurfaceView {
    const Surface& surface;
    /// Eye position in the surface's space; for an orthographic camera the direction towards the viewer.
    dvec3 eye_obj{0.0};
    bool orthographic = false;
    /// Per facet: 1 if it is front-facing (edge-on does not count as front-facing). Empty if no definition needs it.
    Array<std::uint8_t> facing{};
    /// The placement, and the ray caster of the view; null for definitions that depend on the surface alone.
    Index placement = 0;
    dmat4 object_to_view{1.0};  ///< from the surface's space
    const Tracer* tracer = nullptr;
    Cache* shared = nullptr;  ///< per frame: what surfaces share; null: nothing
    /// Skip clusters that cannot contain a line; does not change the result.
    bool pass_over = true;

    /// Vector from a point or vertex to the viewer, in the surface's space; not normalized.
    vec3 to_viewer(const vec3& point) const { return orthographic ? vec3(eye_obj) : vec3(eye_obj - dvec3(point)); }
    vec3 to_viewer(Index vertex) const { return to_viewer(surface.positions[vertex]); }
    /// Whether the nearest surface behind a view-space point is of a placement with another outline, or there is none.
    bool ends_at(const vec3& point, const Ignore& ignore) const {
        return !tracer->continues_behind(point, ignore, placement);
    }
};

/// Input of definitions in image space.
struct FrameView {
    const Tracer& tracer;
    const Cancel& cancel;
    Cache& shared;  ///< per frame: shaded images shared by definitions
};

/// Set of definitions that an edge belongs to, as bits; bit b stands for the definition with index b in the registry.
using Kinds = std::uint32_t;

/// What the result of a definition depends on.
enum class Scope {
    surface,     ///< the surface: computed once and cached with it
    placements,  ///< all surfaces and their transforms, not the view: computed once per scene and cached
    view,        ///< the surface and the eye position
    scene,       ///< the view and the other surfaces of the scene
};

struct LineDefinition;

/// Lines along edges: the edges (mesh edges and diagonals) that belong to the definition, ascending.
struct EdgeRule {
    std::function<Array<Index>(const SurfaceView& seen, const Values& values)> find;
    /// A definition among whose edges this one chooses: short gaps along its chains are closed (path/bridge_folds.h).
    const LineDefinition* part_of = nullptr;
};

/// Types of curves across triangles, which decide how they are processed once chained (path/find_curves.h).
enum class CurveType {
    level_set,  ///< level set of a quantity: all of it is drawn
    tone,       ///< one of many that make a tone: drawn as it is found; other lines do not go on where it ends
    feature,    ///< feature of shape: duplicates of contours and spurs at its ends are removed
    contour,    ///< contour of the fitted smooth surface; the flat triangles of the mesh partly hide it
};

/// Lines across triangles. A view-dependent rule supplies a test for clusters of triangles that cannot contain a line
/// (line/seen_cluster.h) and the quantities it needs per vertex of the others; line/cluster_trace.h does the rest.
struct CurveRule {
    CurveType type;
    std::function<Curves(const SurfaceView& seen, const Values& values)> find;
    /// Thresholds that select intervals of chained segments.
    std::function<Selection(const Surface& surface, const Values& values)> select = [](const Surface&, const Values&) {
        return Selection{};
    };
    /// A definition whose curves include those of this one; where both are drawn, the first line set keeps them.
    const LineDefinition* part_of = nullptr;
};

/// Lines across triangles that depend on the whole scene. `drawn`: indices of the placements whose lines are drawn.
struct SceneRule {
    std::function<std::vector<SceneCurves>(const Scene& scene, In<Index> drawn, const Values& values,
                                           const Cancel& cancel)>
        find;
    /// Computes and caches with a surface what `find` will need of it alone.
    std::function<void(const Surface& surface, const Values& values, const Cancel& cancel)> find_ahead;
};

/// Lines in image space, found once per frame. Points are in view space; triangles and sides are those of a lattice.
struct ImageRule {
    std::function<Curves(const FrameView& frame, const Values& values)> find;
};

/// Substitute in drafts: another definition, with values for some of its parameters by name.
struct StandIn {
    const LineDefinition* definition;
    std::vector<std::pair<const char*, double>> values = {};
};

struct LineDefinition {
    const char* name;  ///< id, the same everywhere
    const char* label;
    const char* source;  ///< paper (with section), or common knowledge
    const char* description;
    Scope scope;
    /// In (0, 1]: among lines that crowd each other, the more important is kept (elision/priority.h). Definitions
    /// between which a line changes at once as the view turns, as contours and silhouettes, share one.
    double importance;
    std::vector<Parameter> parameters = {};
    /// Only definitions that depend on the scene are given one: what surfaces keep does not know of files.
    std::optional<FileParameter> file = {};
    std::variant<EdgeRule, CurveRule, SceneRule, ImageRule> rule;
    /// For a definition on mesh edges: the same line on the smooth surface, which replaces this one where both are
    /// drawn.
    const LineDefinition* smooth_twin = nullptr;
    bool slow = false;  ///< expensive for each view: drafts omit it
    /// Substitutes in drafts, drawn where they are the outer silhouette of their object.
    std::vector<StandIn> stand_ins = {};
    /// Needs Freestyle edge marks, which are only read from Blender if some definition needs them.
    bool reads_edge_marks = false;
    /// Runs where a surface hides what is behind it: left out between placements of one outline group. Rules that ask
    /// SurfaceView::ends_at leave it out themselves.
    bool outlines = false;
    /// Lies on what the section plane cuts: drawn where the viewer sees the cut, whatever faces away behind it.
    bool in_section = false;
    /// Ends at other lines wherever it ends, as hatching does at outlines.
    bool ends_at_lines = false;
    bool usual = false;      ///< what artists draw with; panels fold the others
    bool of_smooth = false;  ///< lines of a smooth shape: line sets that suit lines to surfaces draw it on such alone
    /// That of all its lines, which lie where shade ends. Unset: as surfaces are there.
    std::optional<Shade> shade = {};
};

/// Default values of a definition's parameters.
inline Values default_values(const LineDefinition& definition) {
    Values values;
    for (const Parameter& parameter : definition.parameters) values.push_back(parameter.value);
    return values;
}

}  // namespace fovea::line
