// SPDX-License-Identifier: GPL-3.0-or-later
// The lines across triangles that line sets ask for.
#pragma once

#include <fovea/path/chain_curves.h>
#include <fovea/path/placed_set.h>

namespace fovea::path {

/// Traces, chains and smooths the curves of one definition. Contours are then projected to the smooth surface; features
/// lose the spurs at their ends and the stretches that duplicate a contour (`near` of doubles.h; empty: none). Of both,
/// the stretches that the rule selects by hysteresis.
CurveChains curves_of(const CurveRule& rule, const SurfaceView& seen, const Values& values, In<std::uint8_t> near = {});

/// Curves across triangles that one definition finds for one line set.
struct FoundCurves {
    Index line_set, definition;
    std::shared_ptr<const CurveChains> chains;
    Index other = none;  // the second placement on which they lie
};

/// Of one placement's surface: of definitions that hold for all views, or those that do not. `near`, `hard`: of
/// doubles.h, or empty. On every triangle a definition goes to the first line set that has it there.
std::vector<FoundCurves> find_curves(const SurfaceView& seen, const std::vector<PlacedSet>& sets, bool of_surface,
                                     In<std::uint8_t> near = {}, In<std::uint8_t> hard = {});

/// Of the whole scene, each with the placement that it is reported of. Such a line lies on faces of two placements: it
/// is for a set that one of them is for, and both must show its definition. `placed`: per placement; empty if not
/// drawn.
std::vector<std::pair<Index, FoundCurves>> find_curves_in_scene(const Scene& scene, In<Index> drawn,
                                                                const std::vector<LineSet>& sets, const OwnLines& own,
                                                                const std::vector<std::vector<PlacedSet>>& placed,
                                                                const Cancel& cancel);

/// Calls visit(set's number, kind, rule) for all kinds whose rule is a Rule, but for those that an earlier set has
/// which is for all lines.
template <typename Rule, typename Visit>
void each_with_rule(const std::vector<LineSet>& sets, const Visit& visit) {
    Kinds done = 0;
    for (Index s = 0; s < sets.size(); ++s)
        for (const LineKind& kind : sets[s].kinds) {
            const auto* rule = std::get_if<Rule>(&line_definitions()[kind.definition]->rule);
            if (!rule || (done >> kind.definition & 1)) continue;
            if (sets[s].is_for_all()) done |= Kinds(1) << kind.definition;
            visit(s, kind, *rule);
        }
}

/// Of the frame, in view space. They belong to no placement: line sets filtered by collection, object or material have
/// none of them.
std::vector<FoundCurves> find_curves_in_image(const std::vector<LineSet>& sets, const Tracer& tracer,
                                              const Cancel& cancel);

}  // namespace fovea::path
