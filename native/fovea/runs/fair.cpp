// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/runs/fair.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <fovea/base/parallel.h>
#include <fovea/base/polyline_fit.h>
#include <fovea/field/shape.h>
#include <fovea/line/crease.h>

namespace fovea::runs {
namespace {

constexpr std::size_t faired_per_block = 64;
constexpr double window = 3.0;    // edges to each side
constexpr double farthest = 0.4;  // of an edge
constexpr int rounds = 2;
constexpr int least_points = 5;  // that a parabola is fitted to

class Fairing {
   public:
    Fairing(ClippedPaths& clipped, const Paths& paths, const Scene& scene, double contour_px)
        : clipped_(clipped), paths_(paths), scene_(scene), contour_px_(contour_px), shape_(scene.placements.size()) {
        bool any = false;
        for (const Index p : clipped.path) {
            if (!is_of_edges(p)) continue;
            std::optional<Shape>& shape = shape_[paths.placement[p]];
            if (!shape) shape = field::shape_of(surface_of(p));
            any |= *shape != Shape::hard;
        }
        if (!any) return;
        for (Index p = 0; p < paths.count(); ++p) {
            if (!is_of_edges(p) || is_hard(p)) continue;
            for (const Index point : {paths.rows.begin(p), paths.rows.end(p) - 1})
                if (!paths.closed[p]) ends_.push_back(vertex_at(p, point));
        }
        std::ranges::sort(ends_);
    }

    void run(Index piece) const {
        const Index path = clipped_.path[piece], begin = clipped_.pieces.begin(piece);
        const bool closed = clipped_.closed[piece];
        const int count = int(clipped_.pieces.size(piece)) - closed;
        if (count < least_points || !is_of_edges(path) || is_hard(path)) return;
        const auto wrapped = [&](int i) { return begin + Index(i < 0 ? i + count : i); };
        std::vector<double> before(count), most(count, 0.0);
        bool any = false;
        for (int i = closed ? 0 : 1; i + (closed ? 0 : 1) < count; ++i) {
            most[i] = std::min(limit(path, wrapped(i - 1)), limit(path, wrapped(i)));
            if (most[i] > 0.0 && is_end(path, wrapped(i))) most[i] = 0.0;
            any |= most[i] > 0.0;
        }
        if (!any) return;
        std::vector<dvec3> start(count);
        for (int i = 0; i < count; ++i) start[i] = dvec3(clipped_.px[begin + i], 0.0);
        std::vector<dvec3> now = start, moved = start;
        const auto point = [&](int i) { return now[i]; };
        const auto length = [&](int i) {
            return closed || i + 1 < count ? glm::distance(now[i], now[i + 1 < count ? i + 1 : 0]) : 0.0;
        };
        PolylineFit fit(count, closed);
        for (int round = 0; round < rounds; ++round) {
            fit.measure(point, length);
            for (int i = 0; i < count; ++i) {
                dvec3 value, slope;
                if (!(most[i] > 0.0) || !fit.at(i, window, point, value, slope)) continue;
                const dvec3 way = value - start[i];
                const double far = glm::length(way), limit = std::min(most[i], farthest * fit.unit(i));
                moved[i] = far > limit ? start[i] + limit / far * way : value;
            }
            now = moved;
        }
        for (int i = 0; i < count; ++i) clipped_.px[begin + i] = vec2(now[i]);
        if (closed) clipped_.px[begin + count] = clipped_.px[begin];
    }

   private:
    using Vertex = std::pair<Index, Index>;  // placement, vertex

    const Surface& surface_of(Index path) const { return *scene_.placements[paths_.placement[path]].surface; }

    bool is_of_edges(Index path) const {
        return paths_.placement[path] != none && paths_.place[paths_.rows.begin(path)] < surface_of(path).mesh_edges;
    }

    /// Whether nothing of a path along edges moves: nothing of it is in the frame, or its surface is hard.
    bool is_hard(Index path) const { return shape_[paths_.placement[path]].value_or(Shape::hard) == Shape::hard; }

    /// The vertex at a point of a path along edges.
    Vertex vertex_at(Index path, Index point) const {
        const Edge& edge = surface_of(path).edges[paths_.place[point]];
        return {paths_.placement[path], paths_.edge_t[point] > 0.5f ? edge.y : edge.x};
    }

    /// How far ends of the segment from a clipped point may be moved [px].
    double limit(Index path, Index point) const {
        const Index source = clipped_.source[point];
        const Surface& surface = surface_of(path);
        const Index edge = paths_.place[source];
        if (edge >= surface.mesh_edges || (surface.edge_marks[edge] & mesh::mark_sharp)) return 0.0;
        if (paths_.of_view[path]) return shape_[paths_.placement[path]] == Shape::rounded ? contour_px_ : 0.0;
        return paths_.kinds[source] == crease_ ? HUGE_VAL : 0.0;
    }

    /// Whether a path ends at the vertex where a clipped point is.
    bool is_end(Index path, Index point) const {
        return !(clipped_.source_t[point] > 0.0f) &&
               std::ranges::binary_search(ends_, vertex_at(path, clipped_.source[point]));
    }

    ClippedPaths& clipped_;
    const Paths& paths_;
    const Scene& scene_;
    double contour_px_;
    Kinds crease_ = line::creases();
    std::vector<std::optional<Shape>> shape_;  // by placement; none: no line along its edges is in the frame
    std::vector<Vertex> ends_;                 // where paths end, ascending
};

}  // namespace

void fair(ClippedPaths& clipped, const Paths& paths, const Scene& scene, double contour_px) {
    const Fairing fairing(clipped, paths, scene, contour_px);
    parallel_for(clipped.path.size(), faired_per_block, [&](std::size_t q) { fairing.run(Index(q)); });
}

}  // namespace fovea::runs
