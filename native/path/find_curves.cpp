#include "path/find_curves.h"

#include <algorithm>
#include <string_view>

#include "base/parallel.h"
#include "path/curves_of.h"
#include "path/doubles.h"

namespace fovea {
namespace {

void to_object(const dmat3& stretch, Array<vec3>& points) {
    const dmat3 inverse = glm::inverse(stretch);
    parallel_for(points.size(), [&](std::size_t i) { points[i] = vec3(inverse * dvec3(points[i])); });
}

/// Definitions across triangles that the line sets ask for, in their order; each goes to the first set that has it. A
/// silhouette of mesh edges stands for the smooth one, which is found for nobody then.
struct Job {
    const LineDefinition* definition;
    Values values;
    Index line_set, number;  // none, none: for nobody
};

/// Whether a set before number `s` has the lines of a definition on a placement.
bool is_taken(const std::vector<LineSet>& sets, std::size_t s, Index definition, Index placement) {
    return std::any_of(sets.begin(), sets.begin() + static_cast<std::ptrdiff_t>(s),
                       [&](const LineSet& set) { return set.is_for(placement) && set.has(definition); });
}

std::vector<Job> jobs_of(const std::vector<LineSet>& sets, bool of_surface) {
    std::vector<Job> jobs;
    const Kinds asked = asked_of(sets);
    Kinds done = 0;
    for (Index s = 0; s < sets.size(); ++s)
        for (const LineSet::Kind& kind : sets[s].kinds) {
            const LineDefinition& definition = *line_definitions()[kind.definition];
            const Kinds bit = Kinds(1) << kind.definition;
            if (!of_surface && definition.name == std::string_view("silhouette") && (asked & smooth_contours()))
                jobs.push_back({line_definitions()[definition_index("smooth_silhouette")], {}, none, none});
            if (!definition.find || (definition.scope == Scope::surface) != of_surface || (done & bit)) continue;
            done |= bit;
            jobs.push_back({&definition, kind.values, s, kind.definition});
        }
    return jobs;
}

}  // namespace

std::vector<FoundCurves> find_curves(const SurfaceView& seen, const std::vector<LineSet>& sets, bool of_surface,
                                     In<std::uint8_t> near, In<std::uint8_t> hard) {
    const std::vector<Job> jobs = jobs_of(sets, of_surface);
    std::vector<CurveChains> chains(jobs.size());
    const auto find = [&](std::size_t i) {
        const LineDefinition& definition = *jobs[i].definition;
        chains[i] = curves_of(definition, seen, jobs[i].values, near);
        if (definition.on_smooth_surface && !hard.empty()) chains[i] = without_doubles(chains[i], seen.surface, hard, 1);
    };
    // What is kept with the surface is found under the lock of its cache, which all definitions ask: one by one then.
    if (of_surface)
        for (std::size_t i = 0; i < jobs.size(); ++i) find(i);
    else
        parallel_for(jobs.size(), find, 1);
    std::vector<FoundCurves> found;
    Claims claims(seen.surface);
    for (std::size_t i = 0; i < jobs.size(); ++i) {
        if (jobs[i].definition->on_smooth_surface) chains[i] = claims.claim(*jobs[i].definition, std::move(chains[i]));
        if (jobs[i].line_set == none) continue;
        if (seen.surface.source()) to_object(seen.surface.stretch(), chains[i].point);
        found.push_back({static_cast<std::uint8_t>(jobs[i].line_set), jobs[i].number,
                         std::make_shared<const CurveChains>(std::move(chains[i]))});
    }
    return found;
}

std::vector<std::pair<Index, FoundCurves>> find_curves_in_scene(const Scene& scene, In<Index> drawn,
                                                                const std::vector<LineSet>& sets,
                                                                const Cancel& cancel) {
    std::vector<std::pair<Index, FoundCurves>> found;
    Kinds done = 0;
    for (std::size_t s = 0; s < sets.size(); ++s)
        for (const LineSet::Kind& kind : sets[s].kinds) {
            const LineDefinition& definition = *line_definitions()[kind.definition];
            const Kinds bit = Kinds(1) << kind.definition;
            if (!definition.find_in_scene || (done & bit)) continue;
            if (sets[s].placements.empty()) done |= bit;
            for (const SceneCurves& part : definition.find_in_scene(scene, drawn, kind.values, cancel)) {
                if (part.curves->pieces.empty() || !sets[s].is_for(part.placement)) continue;
                if (is_taken(sets, s, kind.definition, part.placement)) continue;
                const auto chains =
                    part.curves->derived.get<CurveChains>(0, [&] { return chain_curves(part.curves->pieces); });
                found.push_back({part.placement, {static_cast<std::uint8_t>(s), kind.definition, chains, part.other}});
            }
        }
    return found;
}

std::vector<FoundCurves> find_curves_in_image(const std::vector<LineSet>& sets, const Tracer& tracer,
                                              const Cancel& cancel) {
    std::vector<FoundCurves> found;
    Cache shared;
    Kinds done = 0;
    for (std::size_t s = 0; s < sets.size(); ++s)
        for (const LineSet::Kind& kind : sets[s].kinds) {
            const LineDefinition& definition = *line_definitions()[kind.definition];
            const Kinds bit = Kinds(1) << kind.definition;
            if (!definition.find_in_image || !sets[s].placements.empty() || (done & bit)) continue;
            done |= bit;
            const FrameView frame{tracer, cancel, shared};
            CurveChains chains = chain_curves(definition.find_in_image(frame, kind.values));
            found.push_back({static_cast<std::uint8_t>(s), kind.definition,
                             std::make_shared<const CurveChains>(std::move(chains))});
        }
    return found;
}

}  // namespace fovea
