// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/path/find_curves.h>

#include <algorithm>

#include <fovea/base/parallel.h>
#include <fovea/field/fields.h>
#include <fovea/path/doubles.h>
#include <fovea/path/hysteresis.h>
#include <fovea/path/smooth.h>

namespace fovea::path {
namespace {

void to_object(const dmat3& stretch, Array<vec3>& points) {
    const dmat3 inverse = glm::inverse(stretch);
    parallel_for(points.size(), [&](std::size_t i) { points[i] = vec3(inverse * dvec3(points[i])); });
}

/// A definition with its parameter values: traced once, even if several line sets request it.
struct Job {
    const CurveRule* rule;
    Values values;
};

/// The part of a job's lines that a line set gets; in the order of the sets. Of smooth contours, a set that requests
/// the mesh-edge silhouette owns those that the silhouette's smooth twin would find; they are not drawn then.
struct Share {
    std::size_t job;
    Index line_set, number;  // of the definition; none: claimed, but not drawn
    bool everywhere;         // on all materials
};

struct Plan {
    std::vector<Job> jobs;
    std::vector<Share> shares;

    std::size_t job(const CurveRule* rule, const Values& values) {
        const auto same = [&](const Job& job) { return job.rule == rule && job.values == values; };
        const auto found = std::find_if(jobs.begin(), jobs.end(), same);
        const auto place = static_cast<std::size_t>(found - jobs.begin());
        if (found == jobs.end()) jobs.push_back({rule, values});
        return place;
    }
    /// Whether the rest of the curves that a rule finds a part of is requested: it goes on where that part ends.
    bool has_rest_of(const CurveRule& rule) const {
        return rule.part_of && std::ranges::any_of(shares, [&](const Share& share) {
                   return share.number != none && line_definitions()[share.number] == rule.part_of;
               });
    }
};

/// Whether a set before set `s` requests the definition and satisfies has(set).
template <typename Has>
bool is_taken(const std::vector<PlacedSet>& sets, std::size_t s, Index definition, const Has& has) {
    return std::any_of(sets.begin(), sets.begin() + static_cast<std::ptrdiff_t>(s),
                       [&](const PlacedSet& set) { return set.has(definition) && has(set); });
}

/// The rule of a definition's smooth twin if that finds part of the curves of another definition; else null.
const CurveRule* smooth_part(const LineDefinition& definition) {
    if (!definition.smooth_twin) return nullptr;
    const auto* rule = std::get_if<CurveRule>(&definition.smooth_twin->rule);
    return rule && rule->part_of ? rule : nullptr;
}

Plan plan_of(const std::vector<PlacedSet>& sets, bool of_surface) {
    Plan plan;
    const Kinds asked = asked_of(sets);
    for (Index s = 0; s < sets.size(); ++s)
        for (const LineKind& kind : sets[s].kinds) {
            const LineDefinition& definition = *line_definitions()[kind.definition];
            const bool all = sets[s].materials.empty();
            const CurveRule* twin = smooth_part(definition);
            // If the twin itself is requested, edges are replaced by it instead.
            if (!of_surface && twin && (asked & smooth_contours()) && !(asked & kind_of(*definition.smooth_twin)))
                plan.shares.push_back({plan.job(twin, default_values(*definition.smooth_twin)), s, none, all});
            const auto* rule = std::get_if<CurveRule>(&definition.rule);
            if (!rule || (definition.scope == Scope::surface) != of_surface) continue;
            if (is_taken(sets, s, kind.definition, [](const PlacedSet& set) { return set.materials.empty(); }))
                continue;
            const bool some = is_taken(sets, s, kind.definition, [](const PlacedSet&) { return true; });
            plan.shares.push_back({plan.job(rule, kind.values), s, kind.definition, all && !some});
        }
    return plan;
}

/// The part of a job's chains that a share gets.
CurveChains part_of(const CurveChains& chains, const Share& share, const std::vector<PlacedSet>& sets,
                    const Surface& surface) {
    if (share.everywhere) return chains;
    return without_triangles(chains, triangles_without(surface, [&](int material) {
                                 const auto has = [&](const PlacedSet& set) { return set.has_material(material); };
                                 return has(sets[share.line_set]) && !is_taken(sets, share.line_set, share.number, has);
                             }));
}

}  // namespace

CurveChains curves_of(const CurveRule& rule, const SurfaceView& seen, const Values& values, In<std::uint8_t> near) {
    CurveChains chains = chain_curves(rule.find(seen, values));
    if (rule.type != CurveType::tone) smooth(chains, seen.surface);
    switch (rule.type) {
        case CurveType::tone:
        case CurveType::level_set:
            return chains;
        case CurveType::contour:
            lift(chains, seen.surface, fields_of(seen.surface)->curvature);
            break;
        case CurveType::feature:
            if (!near.empty()) chains = without_doubles(chains, seen.surface, near);
            chains = without_spurs(chains, seen.surface);
            break;
    }
    return select_stretches(chains, rule.select(seen.surface, values));
}

std::vector<FoundCurves> find_curves(const SurfaceView& seen, const std::vector<PlacedSet>& sets, bool of_surface,
                                     In<std::uint8_t> near, In<std::uint8_t> hard) {
    const Plan plan = plan_of(sets, of_surface);
    std::vector<CurveChains> chains(plan.jobs.size());
    const auto find = [&](std::size_t i) {
        const CurveRule& rule = *plan.jobs[i].rule;
        chains[i] = curves_of(rule, seen, plan.jobs[i].values, near);
        if (rule.type == CurveType::contour && !hard.empty())
            chains[i] = without_doubles(chains[i], seen.surface, hard, 1);
    };
    // Tracing view-independent curves holds the lock of the surface's cache, which all definitions use: run serially.
    if (of_surface)
        for (std::size_t i = 0; i < chains.size(); ++i) find(i);
    else
        parallel_for(chains.size(), 1, find);
    std::vector<FoundCurves> found;
    Claims claims(seen.surface);
    for (const Share& share : plan.shares) {
        const CurveRule& rule = *plan.jobs[share.job].rule;
        CurveChains part = part_of(chains[share.job], share, sets, seen.surface);
        if (rule.type == CurveType::contour) part = claims.claim(rule, std::move(part));
        if (share.number == none) continue;
        if (plan.has_rest_of(rule)) std::ranges::fill(part.free, 0);
        if (seen.surface.source()) to_object(seen.surface.stretch(), part.point);
        found.push_back({share.line_set, share.number, std::make_shared<const CurveChains>(std::move(part))});
    }
    return found;
}

std::vector<FoundCurves> find_curves_in_image(const std::vector<LineSet>& sets, const Tracer& tracer,
                                              const Cancel& cancel) {
    std::vector<FoundCurves> found;
    Cache shared;
    each_with_rule<ImageRule>(sets, [&](Index s, const LineKind& kind, const ImageRule& rule) {
        if (!sets[s].is_for_all()) return;
        const Curves pieces = rule.find({tracer, cancel, shared}, kind.values);
        found.push_back({s, kind.definition, std::make_shared<const CurveChains>(chain_curves(pieces))});
    });
    return found;
}

}  // namespace fovea::path
