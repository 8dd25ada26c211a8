// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/study/register.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fovea/base/parallel.h>
#include <fovea/study/line_direction.h>
#include <fovea/study/nearest_pixel.h>

namespace fovea::study {
namespace {

constexpr int coarse_side = 128;  // pixels along the longer side of what is searched in
constexpr double farthest = 8.0;  // distance there beyond which nothing is worse
constexpr std::size_t coarse_points = 250, fine_points = 4000;
constexpr int turns = 8, sizes = 6, places = 5;                        // tried to each side of the middle
constexpr double turn_step = 2.0, size_step = 1.05, place_step = 3.0;  // degrees, factor, coarse pixels
constexpr std::size_t candidates = 4;
constexpr int normals_within = 3;                          // pixels around, of a line's direction
constexpr double first_reach = 0.03, last_reach = 0.0012;  // of the diagonal: distance at which pairs count half
constexpr int steps_per_reach = 4;

using Points = std::vector<dvec2>;

/// About `most` of a drawing's pixels, evenly taken.
Points some_points(const Bitmap& bitmap, std::size_t most) {
    Points all;
    for (std::size_t i = 0; i < bitmap.set.size(); ++i)
        if (bitmap.set[i]) all.push_back(center_of(i, bitmap.width));
    const std::size_t step = std::max<std::size_t>(1, all.size() / most);
    Points some;
    for (std::size_t i = 0; i < all.size(); i += step) some.push_back(all[i]);
    return some;
}

/// A drawing in the search: its points about their mean, and distances from them.
struct Coarse {
    double scale;  ///< pixels of the drawing per coarse pixel
    dvec2 mean{0.0};
    double radius = 0.0;  ///< root mean square distance from the mean, in pixels of the drawing
    Points points;        ///< in pixels of the drawing
    int width, height;
    Array<float> distance;

    explicit Coarse(const Bitmap& bitmap) : scale(double(std::max(bitmap.width, bitmap.height)) / coarse_side) {
        points = some_points(bitmap, coarse_points);
        for (const dvec2& p : points) mean += p / double(points.size());
        for (const dvec2& p : points) radius += glm::dot(p - mean, p - mean) / double(points.size());
        radius = std::max(std::sqrt(radius), 1.0);
        Bitmap small(int(std::ceil(bitmap.width / scale)), int(std::ceil(bitmap.height / scale)));
        for (std::size_t i = 0; i < bitmap.set.size(); ++i)
            if (bitmap.set[i]) {
                const dvec2 at = center_of(i, bitmap.width) / scale;
                small.set[std::size_t(at.y) * std::size_t(small.width) + std::size_t(at.x)] = 1;
            }
        width = small.width, height = small.height;
        distance = distances_to(small);
    }

    double distance_at(const dvec2& px) const {
        const dvec2 at = px / scale;
        if (!(at.x >= 0.0 && at.y >= 0.0 && at.x < width && at.y < height)) return farthest;
        return std::min(farthest, double(distance[std::size_t(at.y) * std::size_t(width) + std::size_t(at.x)]));
    }
};

/// Of points from another drawing, to which an affine map brings them.
double mean_distance(const Points& points, const Coarse& other, const Homography& map) {
    double sum = 0.0;
    for (const dvec2& p : points) sum += other.distance_at(dvec2(map * dvec3(p, 1.0)));
    return sum / double(points.size());
}

struct Candidate {
    Homography to_scan;
    double distance;
};

/// The best similarities, of those that map the middle of the reference near to the middle of the scan.
std::vector<Candidate> similarities(const Coarse& scan, const Coarse& reference) {
    const double fitting = scan.radius / reference.radius;
    const std::size_t turn_count = 2 * turns + 1, size_count = 2 * sizes + 1;
    std::vector<Candidate> best(turn_count * size_count);
    parallel_for(best.size(), 1, [&](std::size_t i) {
        const double turn = turn_step * (double(i % turn_count) - turns) * std::numbers::pi / 180.0;
        const double size = fitting * std::pow(size_step, double(i / turn_count) - sizes);
        const double c = size * std::cos(turn), s = size * std::sin(turn);
        best[i].distance = INFINITY;
        for (int y = -places; y <= places; ++y)
            for (int x = -places; x <= places; ++x) {
                const dvec2 to = scan.mean + place_step * scan.scale * dvec2(x, y);
                const dvec2 moved(to.x - c * reference.mean.x + s * reference.mean.y,
                                  to.y - s * reference.mean.x - c * reference.mean.y);
                const Homography map(c, s, 0.0, -s, c, 0.0, moved.x, moved.y, 1.0);
                const double there = mean_distance(reference.points, scan, map);
                if (there >= best[i].distance) continue;
                const double distance = there + mean_distance(scan.points, reference, glm::inverse(map));
                if (distance < best[i].distance) best[i] = {map, distance};
            }
    });
    std::ranges::sort(best, {}, &Candidate::distance);
    best.resize(std::min(best.size(), candidates));
    return best;
}

/// A scan in the refinement: for each pixel the nearest of its lines, and across which direction that runs.
struct Fine {
    int width, height;
    double diagonal;
    Array<Index> nearest;
    Array<vec2> normal;  ///< per pixel of the drawing; (0, 0): it has no direction

    explicit Fine(const Bitmap& bitmap)
        : width(bitmap.width),
          height(bitmap.height),
          diagonal(bitmap.diagonal()),
          nearest(nearest_pixels(bitmap)),
          normal(bitmap.set.size(), vec2(0.0f)) {
        parallel_for(std::size_t(height), 8, [&](std::size_t y) {
            for (std::size_t x = 0; x < std::size_t(width); ++x)
                if (const std::size_t i = y * std::size_t(width) + x; bitmap.set[i])
                    normal[i] = normal_at(bitmap, int(x), int(y), normals_within);
        });
    }
};

/// One step of Gauss and Newton on the distances of the mapped points from the scan's lines; pairs as far apart as
/// `reach` count half (Geman & McClure).
std::optional<Homography> closer(const Homography& to_scan, const Points& points, const Fine& scan, double reach) {
    const double unit = 0.5 * scan.diagonal;
    const dvec2 middle(0.5 * scan.width, 0.5 * scan.height);
    NormalEquations equations;
    for (const dvec2& point : points) {
        const dvec2 at = mapped(to_scan, point);
        if (!(at.x >= 0.0 && at.y >= 0.0 && at.x < scan.width && at.y < scan.height)) continue;
        const Index nearest = scan.nearest[std::size_t(at.y) * std::size_t(scan.width) + std::size_t(at.x)];
        const dvec2 away = at - center_of(nearest, scan.width), normal(scan.normal[nearest]);
        const double share = reach * reach / (reach * reach + glm::dot(away, away));
        // The change of the map that follows it: (x, y) -> ((1 + v0) x + v1 y + v2, ...) / (1 + v6 x + v7 y).
        const dvec2 p = (at - middle) / unit;
        const auto add = [&](const dvec2& n, double weight) {
            const double along = glm::dot(n, p);
            equations.add({n.x * p.x, n.x * p.y, n.x, n.y * p.x, n.y * p.y, n.y, -along * p.x, -along * p.y},
                          -glm::dot(n, away) / unit, weight);
        };
        if (normal == dvec2(0.0)) {
            add({1.0, 0.0}, share * share);
            add({0.0, 1.0}, share * share);
        } else {
            add(normal, share * share);
        }
    }
    // Held back a little where the lines say nothing.
    for (std::size_t i = 0; i < 8; ++i) equations.matrix[i][i] += 1e-6 * double(points.size());
    const auto v = equations.solved();
    if (!v) return std::nullopt;
    const auto& h = *v;
    const Homography change(1.0 + h[0], h[3], h[6], h[1], 1.0 + h[4], h[7], h[2], h[5], 1.0);
    const Homography out(unit, 0.0, 0.0, 0.0, unit, 0.0, middle.x, middle.y, 1.0);
    return out * change * glm::inverse(out) * to_scan;
}

Homography refined(Homography map, const Points& points, const Fine& scan) {
    for (double reach = first_reach; reach >= last_reach; reach *= 0.5)
        for (int step = 0; step < steps_per_reach; ++step) {
            const auto next = closer(map, points, scan, reach * scan.diagonal);
            if (!next) return map;
            map = *next;
        }
    return map;
}

/// The share of points that the map brings within a distance [px of the scan] of its lines.
double share_near(const Points& points, const Homography& to_scan, const Fine& scan, double tolerance) {
    std::size_t near = 0;
    for (const dvec2& point : points) {
        const dvec2 at = mapped(to_scan, point);
        if (!(at.x >= 0.0 && at.y >= 0.0 && at.x < scan.width && at.y < scan.height)) continue;
        const Index nearest = scan.nearest[std::size_t(at.y) * std::size_t(scan.width) + std::size_t(at.x)];
        near += glm::distance(at, center_of(nearest, scan.width)) <= tolerance;
    }
    return points.empty() ? 1.0 : double(near) / double(points.size());
}

}  // namespace

std::optional<Registration> registered(const Bitmap& scan, const Bitmap& reference, double tolerance) {
    const Points points = some_points(reference, fine_points);
    if (points.empty() || !scan.count()) return std::nullopt;
    const Fine fine(scan);
    const std::vector<Candidate> started = similarities(Coarse(scan), Coarse(reference));
    std::vector<Homography> maps(started.size());
    parallel_for(maps.size(), 1, [&](std::size_t i) { maps[i] = refined(started[i].to_scan, points, fine); });
    const double close = 0.5 * tolerance * scan.diagonal() / reference.diagonal();
    const auto quality = [&](const Homography& map) { return share_near(points, map, fine, close); };
    Registration best{*std::ranges::max_element(maps, {}, quality)};
    const Points outer = some_points(outer_pixels(reference, tolerance), SIZE_MAX);
    best.outer_share = share_near(outer, best.to_scan, fine, 2.0 * close);
    return best;
}

Bitmap outer_pixels(const Bitmap& drawing, double gap) {
    const Array<float> distance = distances_to(drawing);
    Bitmap outside(drawing.width, drawing.height), outer(drawing.width, drawing.height);
    std::vector<std::size_t> reached;
    const auto width = std::size_t(drawing.width), height = std::size_t(drawing.height);
    const auto reach = [&](std::size_t x, std::size_t y) {
        if (x >= width || y >= height) return;
        const std::size_t i = y * width + x;
        if (outside.set[i] || distance[i] <= gap) return;
        outside.set[i] = 1;
        reached.push_back(i);
    };
    for (std::size_t x = 0; x < width; ++x) reach(x, 0), reach(x, height - 1);
    for (std::size_t y = 0; y < height; ++y) reach(0, y), reach(width - 1, y);
    while (!reached.empty()) {
        const std::size_t x = reached.back() % width, y = reached.back() / width;
        reached.pop_back();
        reach(x + 1, y), reach(x - 1, y), reach(x, y + 1), reach(x, y - 1);
    }
    const Array<float> from_outside = distances_to(outside);
    for (std::size_t i = 0; i < outer.set.size(); ++i)
        outer.set[i] = drawing.set[i] && from_outside[i] <= gap + std::numbers::sqrt2;
    return outer;
}

}  // namespace fovea::study
