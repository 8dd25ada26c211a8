// SPDX-License-Identifier: GPL-3.0-or-later
// Scene-wide lines, each of which lies on faces of two placements.
#include <algorithm>

#include <fovea/base/hash.h>
#include <fovea/path/find_curves.h>

namespace fovea::path {
namespace {

/// A set of curves on two placements, and the line sets of both.
struct Shared {
    const SceneCurves& part;
    const Surface &first, &second;
    const std::vector<PlacedSet> first_sets, second_sets;

    /// Whether set `s` has the definition's lines on all materials.
    bool all(std::size_t s, Index definition) const {
        const PlacedSet &a = first_sets[s], &b = second_sets[s];
        return (a.has(definition) && a.materials.empty()) || (b.has(definition) && b.materials.empty());
    }
    bool any(std::size_t s, Index definition) const {
        return first_sets[s].has(definition) || second_sets[s].has(definition);
    }
    bool has(std::size_t s, Index definition, const CurvePiece& piece) const {
        const PlacedSet &a = first_sets[s], &b = second_sets[s];
        return (a.has(definition) && a.has_material(material_of_triangle(first, piece.triangle))) ||
               (b.has(definition) && b.has_material(material_of_triangle(second, piece.other)));
    }
};

std::shared_ptr<const CurveChains> chain_kept(const KeptCurves& curves, In<std::uint8_t> kept) {
    return curves.derived.get<CurveChains>(kept.empty() ? 0 : hash_of(kept), [&] {
        if (kept.empty()) return chain_curves(curves.pieces);
        return chain_curves(values_where(curves.pieces, [&](std::size_t i) { return kept[i]; }));
    });
}

/// The curves that set `s` has and no earlier set does; null if there are none.
std::shared_ptr<const CurveChains> of_set(const Shared& shared, std::size_t s, Index definition) {
    const Curves& pieces = shared.part.curves->pieces;
    bool shares = !shared.all(s, definition);
    for (std::size_t before = 0; before < s; ++before) {
        if (shared.all(before, definition)) return nullptr;
        shares = shares || shared.any(before, definition);
    }
    if (!shares) return chain_kept(*shared.part.curves, {});
    const auto kept = parallel_map<std::uint8_t>(pieces.size(), [&](std::size_t i) {
        bool has = shared.has(s, definition, pieces[i]);
        for (std::size_t before = 0; before < s && has; ++before) has = !shared.has(before, definition, pieces[i]);
        return has;
    });
    const bool none_kept = std::all_of(kept.begin(), kept.end(), [](std::uint8_t k) { return !k; });
    return none_kept ? nullptr : chain_kept(*shared.part.curves, kept);
}

}  // namespace

std::vector<std::pair<Index, FoundCurves>> find_curves_in_scene(const Scene& scene, In<Index> drawn,
                                                                const std::vector<LineSet>& sets, const OwnLines& own,
                                                                const Cancel& cancel) {
    std::vector<std::pair<Index, FoundCurves>> found;
    each_with_rule<SceneRule>(sets, [&](Index s, const LineKind& kind, const SceneRule& rule) {
        Array<Index> showing;
        for (const Index placement : drawn)
            if (own.shows(placement, kind.definition)) showing.push_back(placement);
        for (const SceneCurves& part : rule.find(scene, showing, kind.values, cancel)) {
            if (part.curves->pieces.empty()) continue;
            const Surface& first = *scene.placements[part.placement].surface;
            const Surface& second = *scene.placements[part.other].surface;
            const Shared shared{part, first, second, sets_of(part.placement, first, sets, own),
                                sets_of(part.other, second, sets, own)};
            if (const auto chains = of_set(shared, s, kind.definition))
                found.push_back({part.placement, {s, kind.definition, chains, part.other}});
        }
    });
    return found;
}

}  // namespace fovea::path
