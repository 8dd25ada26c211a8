// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/runs/own_roughness.h>

#include <cmath>

#include <fovea/base/steps.h>
#include <fovea/runs/chain.h>
#include <fovea/visibility/segment.h>

namespace fovea::runs {
namespace {

constexpr double asked_px = 2.0;
constexpr int most_asked = 100'000;
constexpr double most_depth = 4.0;  // of what hides it before the line, in lengths of the gap

/// Whether only the roughness of a line's own surface hides it between two arc lengths.
bool is_rough(const ClippedPaths& clipped, const Paths& paths, const Tracer& tracer, Index piece, double from,
              double to) {
    const auto place = [&](double arc) {
        const Index i = clipped.segment_at(piece, arc);
        const Segment segment = segment_at(clipped, paths, tracer, piece, i);
        return std::pair(segment.at(clipped.share_at(i, arc, 0.5)), segment.ignore);
    };
    const double length = glm::distance(place(from).first, place(to).first);
    const int steps = steps_of((to - from) / asked_px, most_asked);
    for (int k = 0; k < steps; ++k) {
        const auto [point, ignore] = place(glm::mix(from, to, (k + 0.5) / steps));
        const auto hit = tracer.occluder(vec3(point), ignore);
        if (!hit) continue;
        const double way = tracer.view().orthographic ? -point.z : glm::length(point);
        if (hit->placement != ignore.placement || (1.0 - hit->t) * way > most_depth * length) return false;
        const Surface& own = *tracer.scene().placements[hit->placement].surface;
        if (!ignore.is_own(own.triangle_facet[hit->triangle])) return false;
    }
    return true;
}

}  // namespace

Runs without_own_roughness(const ClippedPaths& clipped, const Paths& paths, const Tracer& tracer, const Runs& visible,
                           double gap_px) {
    check_same_paths(clipped, paths, "without_own_roughness");
    const auto wanted = [&](Index path) {
        const Index placement = paths.placement[path];
        return paths.of_view[path] != 0 && placement != none &&
               !tracer.scene().placements[placement].surface->is_edge(paths.place[paths.rows.begin(path)]);
    };
    const Rows rows = runs_of_pieces(clipped, visible);
    return runs_by_blocks(clipped.path.size(), 64, [&](Runs& out, std::size_t first, std::size_t last) {
        std::vector<Span> spans;
        for (Index q = Index(first); q < last; ++q) {
            spans.clear();
            for (Index r = rows.begin(q); r < rows.end(q); ++r)
                spans.push_back({visible.start_px[r], visible.end_px[r]});
            if (wanted(clipped.path[q]))
                join_spans(spans, [&](const Span& before, const Span& span) {
                    return span.begin - before.end <= gap_px &&
                           is_rough(clipped, paths, tracer, q, before.end, span.begin);
                });
            for (const Span& span : spans) out.push(q, span.begin, span.end);
        }
    });
}

}  // namespace fovea::runs
