// SPDX-License-Identifier: GPL-3.0-or-later
// Lines across triangles that line sets request.
#pragma once

#include <fovea/path/chain_curves.h>
#include <fovea/path/placed_set.h>

namespace fovea::path {

/// Traces, chains and smooths the curves of one definition. Contours are then projected onto the smooth surface; from
/// features, spurs at the ends and stretches that duplicate a contour are removed (`near`: from near_smooth_contour;
/// empty: none are). Of both, the intervals that the rule selects by hysteresis are returned.
CurveChains curves_of(const CurveRule& rule, const SurfaceView& seen, const Values& values, In<std::uint8_t> near = {});

/// Curves of one definition for one line set.
struct FoundCurves {
    Index line_set, definition;
    std::shared_ptr<const CurveChains> chains;
    Index other = none;  // second placement that they lie on
};

/// Curves on one placement's surface: of view-independent definitions (`of_surface`) or of the others. `near`, `hard`:
/// per vertex, from doubles.h, or empty. On each triangle, curves of a definition belong to the first line set that
/// requests it there.
std::vector<FoundCurves> find_curves(const SurfaceView& seen, const std::vector<PlacedSet>& sets, bool of_surface,
                                     In<std::uint8_t> near = {}, In<std::uint8_t> hard = {});

/// Curves of scene-wide definitions, each with the placement that it belongs to. Such a curve lies on faces of two
/// placements: a set has it if one of them is in the set, and the overrides of both must show its definition.
std::vector<std::pair<Index, FoundCurves>> find_curves_in_scene(const Scene& scene, In<Index> drawn,
                                                                const std::vector<LineSet>& sets, const OwnLines& own,
                                                                const Cancel& cancel);

/// Calls visit(index of set, kind, rule) for all requested definitions whose rule is a Rule, except those already
/// requested by an earlier set that is for all surfaces.
template <typename Rule, typename Visit>
void each_with_rule(const std::vector<LineSet>& sets, const Visit& visit) {
    Kinds done = 0;
    for (Index s = 0; s < sets.size(); ++s)
        for (const LineKind& kind : sets[s].kinds) {
            const auto* rule = std::get_if<Rule>(&line_definitions()[kind.definition]->rule);
            if (!rule || (done >> kind.definition & 1)) continue;
            if (sets[s].is_for_all_shapes()) done |= Kinds(1) << kind.definition;
            visit(s, kind, *rule);
        }
}

/// Curves in image space, in view-space coordinates. They belong to no placement: line sets filtered by collection,
/// object or material have none of them.
std::vector<FoundCurves> find_curves_in_image(const std::vector<LineSet>& sets, const Tracer& tracer,
                                              const Cancel& cancel);

}  // namespace fovea::path
