// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <tuple>

#include <fovea/base/check.h>
#include <fovea/runs/chain.h>
#include <fovea/runs/ends_by_cell.h>
#include <fovea/runs/filters.h>

namespace fovea::runs {
namespace {

constexpr double step_px = 0.5;
constexpr double facing = -0.5;        // maximum cosine between the outward directions of two facing ends
constexpr double near_px = 3.5;        // distance at which a hidden continuation meets another end
constexpr double in_line_px = 1.5;     // the same for a straight extension; ends this close already meet
constexpr double straight_on = 0.375;  // maximum straight extension, as a fraction of the reach
constexpr double gain_px = 0.5;        // minimum extension

class MeetingEnds {
   public:
    MeetingEnds(const ClippedPaths& clipped, const Runs& runs, In<Index> placement, double reach_px)
        : clipped_(clipped),
          runs_(runs),
          placement_(placement),
          reach_(reach_px),
          ends_(ends_by_cell(clipped, runs, placement, reach_px)) {}

    /// New arc length of an end of a run, at most at `limit` [px of the piece].
    double met(Index run, bool at_end, double limit) const {
        const End own = end_of(clipped_, runs_, placement_, reach_, run, at_end);
        const double start = at_end ? runs_.end_px[run] : runs_.start_px[run], sign = at_end ? 1.0 : -1.0;
        double least = std::min(reach_, (limit - start) * sign), found = 0.0;
        if (!(least > gain_px) || !std::isfinite(own.way.x + own.way.y)) return start;
        for (std::int64_t row = own.row - 1; row <= own.row + 1; ++row) {
            const std::tuple first(row, own.placement, own.column - 1), last(row, own.placement, own.column + 1);
            const auto cell = [](const End& e) { return e.cell(); };
            for (auto e = std::ranges::lower_bound(ends_, first, {}, cell); e != ends_.end() && cell(*e) <= last; ++e) {
                const double way = way_to(run, own, *e, start, sign, least);
                if (way > gain_px && (found == 0.0 || way < found)) found = way;
            }
        }
        return start + sign * found;
    }

   private:
    /// Extension of an end along its own line to the point nearest to a facing end; 0 if they do not meet.
    double way_to(Index run, const End& own, const End& other, double start, double sign, double most) const {
        if (other.path == own.path) return 0.0;
        const Index piece = runs_.piece[run];
        const dvec2 between = other.px - own.px;
        const double apart = glm::length(between);
        const bool ahead = glm::dot(between, own.way) > 0.0 && glm::dot(own.way, other.way) <= facing;
        if (!ahead || !(apart > in_line_px && apart < reach_)) return 0.0;
        const double rest = ((sign > 0.0 ? clipped_.last_arc(piece) : clipped_.first_arc(piece)) - start) * sign;
        double nearest = apart, found = 0.0;
        for (double way = step_px; way <= most; way += step_px) {
            const double arc = start + sign * way, beyond = std::max(0.0, way - rest);
            const dvec2 at = dvec2(clipped_.place_px(piece, arc)) + beyond * own.way;
            const double distance = glm::distance(at, other.px);
            if (distance >= nearest) continue;
            nearest = distance;
            found = way;
        }
        return nearest < (found > rest ? in_line_px : near_px) ? found : 0.0;
    }

    const ClippedPaths& clipped_;
    const Runs& runs_;
    In<Index> placement_;
    double reach_;
    Array<End> ends_;
};

}  // namespace

Runs meet_ends(const ClippedPaths& clipped, const Runs& runs, In<std::uint8_t> of_view, In<Index> placement,
               double reach_px) {
    check_runs(clipped, runs);
    const std::size_t paths = clipped.path.empty() ? 0 : clipped.path.back() + 1;
    check(of_view.size() >= paths, "of_view: one value per path expected");
    check(placement.size() >= paths, "placement: one value per path expected");
    check(std::isfinite(reach_px) && reach_px > 0.0, "reach_px: not a number above 0");
    const MeetingEnds ends(clipped, runs, placement, reach_px);
    const Rows rows = runs_of_pieces(clipped, runs);
    const double beyond = straight_on * reach_px;
    return runs_by_blocks(clipped.path.size(), 256, [&](Runs& out, std::size_t begin, std::size_t end) {
        std::vector<Span> visible;
        for (Index q = Index(begin); q < end; ++q) {
            visible.clear();
            const bool contour = of_view[clipped.path[q]];
            double before = clipped.first_arc(q) - (clipped.ends[q] & path_start ? beyond : 0.0);
            const double farthest = clipped.last_arc(q) + (clipped.ends[q] & path_end ? beyond : 0.0);
            for (Index r = rows.begin(q); r < rows.end(q); ++r) {
                if (runs.invisibility[r] != 0) continue;
                Index next = r + 1;
                while (next < rows.end(q) && runs.invisibility[next] != 0) ++next;
                const double after = next < rows.end(q) ? runs.start_px[next] : farthest;
                visible.push_back({contour ? ends.met(r, false, before) : runs.start_px[r],
                                   contour ? ends.met(r, true, after) : runs.end_px[r]});
                before = visible.back().end;
            }
            replace_visible(runs, rows, q, visible, out);
        }
    });
}

}  // namespace fovea::runs
