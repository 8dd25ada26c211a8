// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/vector/plot.h>

#include <algorithm>

#include <fovea/vector/plot_order.h>

namespace fovea::vector {
namespace {

constexpr double same_mm = 0.05;   // between lines that are one
constexpr double double_mm = 0.2;  // along which they run together at least
constexpr double joint_mm = 0.1;   // between ends that are joined
constexpr double flat_mm = 0.01;   // between curves and the lines that their lengths are measured by

/// Number of the segment of a closed curve with which the way from a place over it to the next path, if any, is
/// shortest.
std::size_t best_start(const Curve& curve, const dvec2& from, const Path* next) {
    std::size_t best = 0, number = 0;
    double shortest = -1.0;
    for_each_segment(curve, [&](const dvec2* p, bool) {
        const double way = glm::distance(from, p[0]) + (next ? glm::distance(p[0], next->curves[0].start()) : 0.0);
        if (shortest < 0.0 || way < shortest - 1e-9) {
            shortest = way;
            best = number;
        }
        ++number;
    });
    return best;
}

std::vector<Stop> stops_of(const std::vector<Path>& paths) {
    std::vector<Stop> stops;
    for (const Path& path : paths) stops.push_back({path.curves[0].start(), path.curves[0].end()});
    return stops;
}

/// The paths in the order of a plan.
std::vector<Path> in_order(std::vector<Path> paths, const std::vector<Turn>& plan) {
    std::vector<Path> ordered;
    for (const Turn& turn : plan) {
        ordered.push_back(std::move(paths[turn.stroke]));
        if (turn.reversed) ordered.back().curves[0] = reversed(ordered.back().curves[0]);
    }
    return ordered;
}

void start_closed_ones_near(std::vector<Path>& paths, dvec2 at) {
    for (std::size_t i = 0; i < paths.size(); ++i) {
        Curve& curve = paths[i].curves[0];
        if (curve.closed) {
            curve = rotated(curve, best_start(curve, at, i + 1 < paths.size() ? &paths[i + 1] : nullptr));
        }
        at = curve.end();
    }
}

std::vector<Turn> as_they_are(std::size_t count) {
    std::vector<Turn> plan;
    for (std::size_t i = 0; i < count; ++i) plan.push_back({i, false});
    return plan;
}

}  // namespace

std::vector<Line> as_plotted(std::vector<Line> lines, double unit_mm) {
    lines = without_doubles(std::move(lines), same_mm / unit_mm, double_mm / unit_mm);
    return joined(std::move(lines), joint_mm / unit_mm);
}

Way put_in_order(Document& document, double unit_mm) {
    Way way;
    dvec2 at(0.0, document.size.y);
    for (Layer& layer : document.layers) {
        const dvec2 home = at;
        const std::vector<Stop> stops = stops_of(layer.paths);
        way.pen_up_unordered_mm += unit_mm * way_between(stops, as_they_are(stops.size()), home);
        way.pen_up_nearest_mm += unit_mm * way_between(stops, nearest_order(stops, home), home);
        layer.paths = in_order(std::move(layer.paths), plot_order(stops, home));
        start_closed_ones_near(layer.paths, home);
        for (const Path& path : layer.paths) {
            const Curve& curve = path.curves[0];
            way.pen_up_mm += unit_mm * glm::distance(at, curve.start());
            way.pen_down_mm += unit_mm * length_of(flattened(curve, flat_mm / unit_mm));
            ++way.lifts;
            at = curve.end();
        }
    }
    return way;
}

}  // namespace fovea::vector
