// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/runs/outer_parts.h>

#include <algorithm>
#include <cmath>

#include <fovea/base/check.h>
#include <fovea/line/registry.h>
#include <fovea/visibility/segment.h>

namespace fovea::runs {
namespace {

constexpr std::size_t outlines_per_block = 64;

/// Splits a range of runs.
class Parting {
   public:
    Parting(const ClippedPaths& clipped, const Paths& paths, const Tracer& tracer, In<Kinds> sure, double step_px,
            Inner inner, OuterParts& out)
        : clipped_(clipped), paths_(paths), tracer_(tracer), sure_(sure), step_px_(step_px), inner_(inner), out_(out) {}

    void add(const Runs& runs, std::size_t r) {
        const double start = runs.start_px[r], length = runs.end_px[r] - start;
        const auto count = static_cast<std::size_t>(std::max(1.0, std::ceil(length / step_px_)));
        answers_.resize(count);
        for (std::size_t k = 0; k < count; ++k) answers_[k] = ask(runs.piece[r], start + (k + 0.5) * length / count, k);
        std::size_t first = 0;
        for (std::size_t k = 1; k <= count; ++k) {
            if (k < count && voted(k) == voted(first)) continue;
            const double from = start + first * length / count;
            const double to = k == count ? runs.end_px[r] : start + k * length / count;
            const std::size_t before = out_.runs.size();
            out_.runs.push(runs.piece[r], from, to, runs.invisibility[r]);
            if (out_.runs.size() > before) {
                out_.outer.push_back(voted(first));
                out_.source.push_back(answers_[first].source);
            }
            first = k;
        }
    }

   private:
    struct Answer {
        Index source;
        std::uint8_t outer;
    };

    Answer ask(Index piece, double arc, std::size_t k) {
        const Index i = clipped_.segment_at(piece, arc);
        const Index source = clipped_.source[i], path = clipped_.path[piece];
        if (paths_.kinds[source] & sure_[path]) return {source, 1};
        if (k == 0 || i != at_) {
            segment_ = segment_at(clipped_, paths_, tracer_, piece, i);
            at_ = i;
        }
        const double s = clipped_.share_at(i, arc, 0.5);
        return {source, !continues(vec3(segment_.at(s)), paths_.placement[path])};
    }

    bool continues(const vec3& point, Index own) const {
        if (inner_ == Inner::own) return tracer_.continues_behind(point, segment_.ignore, own);
        const auto behind = tracer_.behind(point, segment_.ignore);
        return behind && own != behind->placement && tracer_.scene().share_outline(own, behind->placement);
    }

    /// Result of test k, with isolated results replaced by those of their neighbors.
    std::uint8_t voted(std::size_t k) const {
        const std::uint8_t own = answers_[k].outer;
        if (k == 0 || k + 1 == answers_.size() || answers_[k - 1].outer != answers_[k + 1].outer) return own;
        return answers_[k - 1].outer;
    }

    const ClippedPaths& clipped_;
    const Paths& paths_;
    const Tracer& tracer_;
    const In<Kinds> sure_;
    const double step_px_;
    const Inner inner_;
    OuterParts& out_;
    std::vector<Answer> answers_;
    Segment segment_{};
    Index at_ = none;
};

}  // namespace

OuterParts outer_parts(const ClippedPaths& clipped, const Paths& paths, const Tracer& tracer, const Runs& runs,
                       In<Kinds> sure, double step_px, const Cancel& cancel, Inner inner) {
    check_same_paths(clipped, paths, "outer_parts");
    check_runs(clipped, runs);
    check(sure.size() == paths.count(), "sure: one value per path expected");
    check(step_px > 0.0, "step_px must be more than 0");
    tracer.check_current();
    const auto parts = parallel_parts<OuterParts>(
        runs.size(), outlines_per_block, [&](OuterParts& part, std::size_t r, std::size_t end) {
            cancel.poll();
            Parting parting(clipped, paths, tracer, sure, step_px, inner, part);
            for (; r < end; ++r) parting.add(runs, r);
        });
    OuterParts all;
    for (const OuterParts& part : parts) {
        all.runs.append(part.runs);
        all.outer.insert(all.outer.end(), part.outer.begin(), part.outer.end());
        all.source.insert(all.source.end(), part.source.begin(), part.source.end());
    }
    return all;
}

Runs without_inner_outlines(const ClippedPaths& clipped, const Paths& paths, const Tracer& tracer, Runs runs,
                            double step_px, const Cancel& cancel) {
    const auto& placements = tracer.scene().placements;
    if (std::ranges::none_of(placements, [](const Placement& placement) { return placement.group != 0; })) return runs;
    Kinds outlines = 0;
    for (Index i = 0; const LineDefinition* definition : line_definitions())
        outlines |= Kinds(definition->outlines) << i++;
    Array<Kinds> sure(paths.count(), ~Kinds(0));
    for (Index p = 0; p < paths.count(); ++p)
        if (paths.placement[p] != none && placements[paths.placement[p]].group != 0) sure[p] = ~outlines;
    const OuterParts parts = outer_parts(clipped, paths, tracer, runs, sure, step_px, cancel, Inner::others);
    Runs kept;
    for (std::size_t r = 0; r < parts.runs.size(); ++r)
        if (parts.outer[r])
            kept.push(parts.runs.piece[r], parts.runs.start_px[r], parts.runs.end_px[r], parts.runs.invisibility[r]);
    return kept;
}

}  // namespace fovea::runs
