// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/elision/outer_shares.h>

#include <algorithm>
#include <cmath>

#include <fovea/base/check.h>
#include <fovea/line/look_at.h>
#include <fovea/line/outer_edges.h>
#include <fovea/line/registry.h>
#include <fovea/mesh/stretch.h>

namespace fovea::elision {
namespace {

constexpr double strip_px = 12.0;  // reference pixels outside of an edge in which its object may go on

class Shares {
   public:
    Shares(const Paths& paths, const Tracer& tracer, int places, Array<OuterShare>& out)
        : paths_(paths), tracer_(tracer), places_(places), out_(out) {}

    void add(Index p) {
        const Index begin = paths_.rows.begin(p), last = paths_.rows.end(p) - 1;
        if (paths_.placement[p] == none || !(paths_.arc_obj[last] > paths_.arc_obj[begin])) return;
        const Placement& placed = tracer_.scene().placements[paths_.placement[p]];
        if (!placed.surface) return;
        const double by_length = places_ / (paths_.arc_obj[last] - paths_.arc_obj[begin]);
        std::shared_ptr<const Surface> surface;
        for (Index i = begin; i < last; ++i) {
            const double count = std::round((paths_.arc_obj[i + 1] - paths_.arc_obj[i]) * by_length);
            if (!(paths_.kinds[i] & (outer_ | whole_)) || count < 2.0) continue;
            if (!surface) surface = as_placed(placed.surface, placed.object_to_world);
            if (paths_.place[i] >= surface->edges.size() || surface->sides(paths_.place[i]).size() < 2) continue;
            const SurfaceView seen = line::look_at(*surface, paths_.placement[p], tracer_);
            out_[i] = of_edge(line::OuterEdges(seen), i, int(count));
        }
    }

   private:
    OuterShare of_edge(const line::OuterEdges& edges, Index i, int count) const {
        return {float(edges.share_outside(paths_.place[i], strip_px, count)),
                float(line::importance_of((paths_.kinds[i] & ~outer_) | whole_))};
    }

    const Paths& paths_;
    const Tracer& tracer_;
    const int places_;
    Array<OuterShare>& out_;
    const Kinds outer_ = line::edge_parts(), whole_ = line::edge_wholes();
};

}  // namespace

Array<OuterShare> outer_shares(const Paths& paths, const Tracer& tracer, In<std::uint8_t> asked, const Cancel& cancel,
                               int places) {
    check(asked.size() == paths.count(), "outer shares: one value per path expected");
    check(places > 0, "outer shares: at least one place of each path expected");
    tracer.check_current();
    Array<OuterShare> shares(paths.points_obj.size(), OuterShare());
    parallel_blocks(paths.count(), 64, [&](auto, std::size_t begin, std::size_t end) {
        cancel.poll();
        Shares of(paths, tracer, places, shares);
        for (Index p = Index(begin); p < end; ++p)
            if (asked[p]) of.add(p);
    });
    return shares;
}

}  // namespace fovea::elision
