// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <tuple>

#include <fovea/base/check.h>
#include <fovea/runs/chain.h>
#include <fovea/runs/forks.h>
#include <fovea/runs/touches.h>

namespace fovea::runs {
namespace {

constexpr double edges_long = 2.0;     // the longest arm, in lengths of its longest edge in the image
constexpr double edges_apart = 4.0;    // the greatest distance of branches along the view, in the same in space
constexpr double least_cosine = 0.64;  // between the normals beside edges of a rounded surface
constexpr double look_ahead = 4.0;     // the length over which a branch's direction is measured, in touches
constexpr double same_way = 0.94;      // cosine above which two lines that go on are one, drawn twice
constexpr std::size_t branches_kept = 2;

/// The part of a run from an arc length to its start or end.
struct Branch {
    Index run;
    bool to_end;
    double arc, length;
    bool is_arm = false;  // may be removed
};

/// Mesh edges of a part of a piece.
struct Edges {
    double longest_px = 0.0, longest = 0.0;  // in the image and in space
    bool rounded = true;
};

/// The branches that meet at a place.
using Junction = std::vector<Branch>;

class Forks {
   public:
    Forks(const ClippedPaths& clipped, const Runs& runs, const Paths& paths, const Scene& scene,
          const ForkOptions& options)
        : clipped_(clipped), runs_(runs), paths_(paths), scene_(scene), options_(options) {}

    Runs cut() {
        std::vector<Junction> junctions = find_junctions();
        if (junctions.empty()) return runs_;
        keep_held(junctions);
        cut_ = runs_;
        for (Junction& junction : junctions) remove_arms(junction);
        Runs left;
        for (std::size_t r = 0; r < cut_.size(); ++r) left.push(cut_, r);
        return left;
    }

   private:
    struct End {
        Index run;
        bool at_end;
    };

    bool is_contour(Index run) const {
        const Index piece = runs_.piece[run], path = clipped_.path[piece], placement = paths_.placement[path];
        return placement != none && paths_.of_view[path] != 0 && paths_.of_view[path] != ends_at_cusps &&
               scene_.placements[placement].surface->is_edge(
                   paths_.place[clipped_.source[clipped_.pieces.begin(piece)]]);
    }

    /// Where ends of short contours of rounded surfaces meet others of their placement, more than two branches.
    std::vector<Junction> find_junctions() const {
        Array<Index> placement(runs_.size(), none);
        Array<Place> places;
        Array<End> ends;
        for (Index r = 0; r < runs_.size(); ++r) {
            if (!is_contour(r)) continue;
            placement[r] = paths_.placement[clipped_.path[runs_.piece[r]]];
            const double length = runs_.end_px[r] - runs_.start_px[r];
            if (length <= least_branch() || length >= options_.most) continue;
            if (!edges_of(r, runs_.start_px[r], runs_.end_px[r]).rounded) continue;
            for (const bool at_end : {false, true}) {
                const dvec2 px(clipped_.place_px(runs_.piece[r], arc_of(r, at_end)));
                if (!std::isfinite(px.x + px.y)) continue;
                places.push_back({px, placement[r]});
                ends.push_back({r, at_end});
            }
        }
        std::vector<Junction> junctions;
        if (places.empty()) return junctions;
        const Array<Touch> touches = touches_of(clipped_, runs_, places, placement, options_.touch);
        for (auto first = touches.begin(); first != touches.end();) {
            const auto last = std::find_if(first, touches.end(), [&](auto& t) { return t.place != first->place; });
            Junction found = branches_at(ends[first->place], {&*first, std::size_t(last - first)});
            if (found.size() > branches_kept) junctions.push_back(std::move(found));
            first = last;
        }
        return junctions;
    }

    Junction branches_at(const End& end, In<Touch> touches) const {
        const double start = runs_.start_px[end.run], stop = runs_.end_px[end.run], arc = arc_of(end.run, end.at_end);
        const double apart = edges_apart * edges_of(end.run, start, stop).longest;
        Junction branches{{end.run, !end.at_end, arc, stop - start}};
        for (const Touch& touch : touches) {
            if (touch.run == end.run || std::abs(away(touch.run, touch.arc) - away(end.run, arc)) > apart) continue;
            for (const bool to_end : {false, true}) {
                const double rest = std::abs(arc_of(touch.run, to_end) - touch.arc);
                if (rest > least_branch()) branches.push_back({touch.run, to_end, touch.arc, rest});
            }
        }
        for (Branch& branch : branches) branch.is_arm = is_short(branch);
        return branches;
    }

    bool is_short(const Branch& branch) const {
        const double other = arc_of(branch.run, branch.to_end);
        if (branch.length >= options_.most || is_cut_by_frame(branch.run, branch.to_end)) return false;
        const Edges edges = edges_of(branch.run, std::min(branch.arc, other), std::max(branch.arc, other));
        return edges.rounded && branch.length <= std::max(options_.least, edges_long * edges.longest_px);
    }

    /// Branches whose other end meets a line are no arms.
    void keep_held(std::vector<Junction>& junctions) const {
        Array<Place> places;
        Array<Index> own;
        const auto each_arm = [&](const auto& body) {
            for (Junction& junction : junctions)
                for (Branch& branch : junction)
                    if (branch.is_arm) body(branch);
        };
        each_arm([&](Branch& arm) {
            places.push_back({dvec2(clipped_.place_px(runs_.piece[arm.run], arc_of(arm.run, arm.to_end))), 0});
            own.push_back(arm.run);
        });
        const Array<std::uint8_t> held = touched_by_others(clipped_, runs_, places, own, options_.touch);
        std::size_t next = 0;
        each_arm([&](Branch& arm) { arm.is_arm = !held[next++]; });
    }

    void remove_arms(Junction& branches) {
        std::ranges::sort(branches, {},
                          [](const Branch& b) { return std::tuple(b.is_arm, -b.length, b.run, b.to_end); });
        std::vector<dvec2> kept;
        for (const Branch& branch : branches) {
            const dvec2 way = way_of(branch);
            const bool again = std::ranges::any_of(kept, [&](const dvec2& k) { return glm::dot(k, way) > same_way; });
            if (branch.is_arm && kept.size() >= branches_kept)
                remove(branch);
            else if (branch.is_arm || !again)
                kept.push_back(way);
        }
    }

    /// The direction in which a branch leaves.
    dvec2 way_of(const Branch& branch) const {
        const double ahead = std::min(branch.length, look_ahead * options_.touch);
        const Index piece = runs_.piece[branch.run];
        const dvec2 way = dvec2(clipped_.place_px(piece, branch.arc + (branch.to_end ? ahead : -ahead))) -
                          dvec2(clipped_.place_px(piece, branch.arc));
        const double length = glm::length(way);
        return length > 0.0 ? way / length : dvec2(0.0);
    }

    void remove(const Branch& branch) {
        double& start = cut_.start_px[branch.run];
        double& end = cut_.end_px[branch.run];
        if (branch.to_end)
            end = std::max(start, std::min(end, branch.arc));
        else
            start = std::min(end, std::max(start, branch.arc));
    }

    Edges edges_of(Index run, double from, double to) const {
        const Index piece = runs_.piece[run], placement = paths_.placement[clipped_.path[piece]],
                    base = scene_.facet_base[placement];
        const Array<vec4>& planes = scene_.placements[placement].surface->facet_plane;
        Edges edges;
        for (Index i = clipped_.segment_at(piece, from); i + 1 < clipped_.pieces.end(piece) && clipped_.arc_px[i] < to;
             ++i) {
            edges.longest_px = std::max(edges.longest_px, clipped_.arc_px[i + 1] - clipped_.arc_px[i]);
            edges.longest = std::max(edges.longest,
                                     double(glm::distance(clipped_.position_view[i], clipped_.position_view[i + 1])));
            const Index a = clipped_.facet0[i], b = clipped_.facet1[i];
            edges.rounded = edges.rounded && a != none && b != none &&
                            glm::dot(vec3(planes[a - base]), vec3(planes[b - base])) > least_cosine;
        }
        return edges;
    }

    /// Both ends of what is shorter may be at one junction.
    double least_branch() const { return 2.0 * options_.touch; }

    double arc_of(Index run, bool at_end) const { return at_end ? runs_.end_px[run] : runs_.start_px[run]; }

    double away(Index run, double arc) const {
        const Index i = clipped_.segment_at(runs_.piece[run], arc);
        return -glm::mix(double(clipped_.position_view[i].z), double(clipped_.position_view[i + 1].z),
                         clipped_.share_at(i, arc));
    }

    bool is_cut_by_frame(Index run, bool at_end) const {
        const Index piece = runs_.piece[run];
        const double arc = arc_of(run, at_end);
        return at_end
                   ? arc >= clipped_.last_arc(piece) - same_place_px && !(clipped_.ends[piece] & (path_end | seam_end))
                   : arc <= clipped_.first_arc(piece) + same_place_px &&
                         !(clipped_.ends[piece] & (path_start | seam_start));
    }

    const ClippedPaths& clipped_;
    const Runs& runs_;
    const Paths& paths_;
    const Scene& scene_;
    const ForkOptions options_;
    Runs cut_;
};

}  // namespace

Runs without_forks(const ClippedPaths& clipped, const Runs& visible, const Paths& paths, const Scene& scene,
                   const ForkOptions& options) {
    check_runs(clipped, visible);
    check(options.touch > 0.0, "without_forks: touch must be above 0");
    return Forks(clipped, visible, paths, scene, options).cut();
}

}  // namespace fovea::runs
