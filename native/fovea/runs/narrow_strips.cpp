// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/runs/narrow_strips.h>

#include <algorithm>
#include <cmath>

#include <fovea/base/check.h>
#include <fovea/field/strips.h>
#include <fovea/line/crease.h>

namespace fovea::runs {
namespace {

using Strips = std::shared_ptr<const Array<Index>>;

/// Lines along mesh edges of surfaces that have strips, by placement and edge.
class EdgeLines {
   public:
    struct Line {
        Index placement, edge, path;
        Kinds kinds;
        auto key() const { return std::pair(placement, edge); }
    };

    EdgeLines(const Paths& paths, const Scene& scene, Kinds creases) : strips_(scene.placements.size()) {
        for (Index p = 0; p < paths.count(); ++p) {
            const Index placement = paths.placement[p], first = paths.rows.begin(p);
            if (placement == none || strips_[placement] || paths.kinds[first] != creases) continue;
            strips_[placement] = field::strips_of(*scene.placements[placement].surface);
        }
        for (Index p = 0; p < paths.count(); ++p) {
            const Index placement = paths.placement[p];
            if (placement == none || !strips_[placement]) continue;
            const Array<Index>& strips = *strips_[placement];
            for (Index i = paths.rows.begin(p); i + 1 < paths.rows.end(p); ++i)
                if (const Index edge = paths.place[i]; edge < strips.size() && strips[edge] != none)
                    all_.push_back({placement, edge, p, paths.kinds[i]});
        }
        std::ranges::sort(all_, {}, &Line::key);
    }

    bool empty() const { return all_.empty(); }
    /// The line at the other edge of the strip beside an edge; null: there is no strip, or no line.
    const Line* beside(Index placement, Index edge) const {
        if (placement == none || !strips_[placement] || edge >= strips_[placement]->size()) return nullptr;
        const std::pair key(placement, (*strips_[placement])[edge]);
        const auto at = std::ranges::lower_bound(all_, key, {}, &Line::key);
        return at != all_.end() && at->key() == key ? &*at : nullptr;
    }

   private:
    std::vector<Strips> strips_;  // by placement; null: it has no creases
    std::vector<Line> all_;
};

class Narrow {
   public:
    Narrow(const ClippedPaths& clipped, const Paths& paths, const Scene& scene, const View& view, In<float> least_px)
        : clipped_(clipped), paths_(paths), scene_(scene), view_(view), least_px_(least_px) {}

    bool nothing() const { return lines_.empty(); }

    /// Interval of fractions of a clipped segment that goes; empty: none.
    dvec2 gone(Index path, Index segment) const {
        const Index source = clipped_.source[segment], placement = paths_.placement[path];
        if (paths_.kinds[source] != crease_) return dvec2(0.0);
        const EdgeLines::Line* line = lines_.beside(placement, paths_.place[source]);
        if (!line) return dvec2(0.0);
        const std::pair mine(path, paths_.place[source]), its(line->path, line->edge);
        if (line->kinds == crease_ && its > mine) return dvec2(0.0);
        const Surface& surface = *scene_.placements[placement].surface;
        const dmat4 to_view = view_.world_to_view * scene_.placements[placement].object_to_world;
        dvec2 ends[2];
        for (int k = 0; k < 2; ++k) {
            const dvec4 clip =
                view_.view_to_clip * to_view * dvec4(dvec3(surface.positions[surface.edges[line->edge][k]]), 1.0);
            if (!(clip.w > 0.0)) return dvec2(0.0);
            ends[k] = to_pixels(view_, clip);
        }
        return below(width(clipped_.px[segment], ends), width(clipped_.px[segment + 1], ends), least_px_[path]);
    }

   private:
    /// Distance of a pixel position from the line through two others.
    static double width(const vec2& at, const dvec2 (&ends)[2]) {
        const dvec2 way = ends[1] - ends[0], from = dvec2(at) - ends[0];
        const double length = glm::length(way);
        return length > 0.0 ? std::abs(way.x * from.y - way.y * from.x) / length : HUGE_VAL;
    }

    /// Where a width that changes evenly from a to b is below `least`.
    static dvec2 below(double a, double b, double least) {
        if (!(a < least) && !(b < least)) return dvec2(0.0);
        const double turn = (least - a) / (b - a);
        return {a < least ? 0.0 : turn, b < least ? 1.0 : turn};
    }

    const ClippedPaths& clipped_;
    const Paths& paths_;
    const Scene& scene_;
    const View& view_;
    In<float> least_px_;
    Kinds crease_ = line::creases();
    EdgeLines lines_{paths_, scene_, crease_};
};

}  // namespace

Runs without_narrow_strips(const ClippedPaths& clipped, const Runs& runs, const Paths& paths, const Scene& scene,
                           const View& view, In<float> least_px) {
    check_runs(clipped, runs);
    check(least_px.size() == paths.count(), "least_px: one value per path expected");
    const Narrow narrow(clipped, paths, scene, view, least_px);
    if (narrow.nothing()) return runs;
    return runs_by_blocks(runs.size(), runs_per_block, [&](Runs& out, std::size_t begin, std::size_t end) {
        for (std::size_t r = begin; r < end; ++r) {
            const Index piece = runs.piece[r];
            double from = runs.start_px[r];
            for (Index i = clipped.segment_at(piece, from); i + 1 < clipped.pieces.end(piece); ++i) {
                const double start = clipped.arc_px[i], length = clipped.arc_px[i + 1] - start;
                if (start >= runs.end_px[r]) break;
                const dvec2 gone = narrow.gone(clipped.path[piece], i);
                if (!(gone.x < gone.y)) continue;
                out.push(piece, from, std::min(start + gone.x * length, runs.end_px[r]), runs.invisibility[r]);
                from = std::max(from, start + gone.y * length);
            }
            out.push(piece, from, runs.end_px[r], runs.invisibility[r]);
        }
    });
}

}  // namespace fovea::runs
