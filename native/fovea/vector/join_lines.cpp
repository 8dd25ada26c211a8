// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/vector/join_lines.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include <fovea/base/cancel.h>
#include <fovea/base/point_grid.h>
#include <fovea/base/steps.h>
#include <fovea/vector/fit_cubic.h>

namespace fovea::vector {
namespace {

constexpr double parallel = 0.9986;    // cosine of 3 degrees
constexpr double side_length = 1.0;    // in cells of the grid: sides of kept lines are cut into such parts
constexpr int most_steps = 1'000'000;  // of a side
constexpr std::size_t most_partners = 8;

/// Parts of a length, at most that long.
int parts_of(double length, double step) { return base::steps_of(length / step, most_steps); }

/// Sides of lines that are kept, by place.
class Kept {
   public:
    explicit Kept(double near) : near_(near), grid_(std::max(5.0 * near, 1e-6)) {}

    void add(const Points& points) {
        for (std::size_t i = 1; i < points.size(); ++i) {
            const dvec2 a = points[i - 1], b = points[i];
            const int parts = parts_of(glm::distance(a, b), step());
            for (int k = 0; k < parts; ++k) {
                const dvec2 from = glm::mix(a, b, double(k) / parts), to = glm::mix(a, b, (k + 1.0) / parts);
                grid_.add(0.5 * (from + to), sides_.size());
                sides_.push_back({from, to});
            }
        }
    }

    /// Whether a short side runs along a kept one.
    bool has(const dvec2& a, const dvec2& b) const {
        const dvec2 middle = 0.5 * (a + b), way = b - a;
        bool found = false;
        grid_.near(middle, [&](std::size_t number) {
            const auto& [from, to] = sides_[number];
            const double along = std::abs(glm::dot(way, to - from));
            found = found || (distance_to_segment(middle, from, to) <= near_ &&
                              along >= parallel * glm::length(way) * glm::distance(from, to));
        });
        return found;
    }

    double step() const { return side_length * grid_.cell(); }

   private:
    double near_;
    PointGrid grid_;
    std::vector<std::pair<dvec2, dvec2>> sides_;
};

/// A line with points at most a step apart.
Points in_steps(const Points& points, double step) {
    Points fine{points.front()};
    for (std::size_t i = 1; i < points.size(); ++i) {
        const int parts = parts_of(glm::distance(points[i - 1], points[i]), step);
        for (int k = 1; k < parts; ++k) fine.push_back(glm::mix(points[i - 1], points[i], double(k) / parts));
        fine.push_back(points[i]);
    }
    return fine;
}

/// The parts of a line that are not there yet; the whole line where what is there is shorter than `least`.
std::vector<Line> left_of_line(const Line& line, const Kept& kept, double least) {
    const Points fine = in_steps(line.points, kept.step());
    std::vector<bool> there(fine.size() - 1);
    for (std::size_t i = 0; i < there.size(); ++i) there[i] = kept.has(fine[i], fine[i + 1]);
    std::vector<Line> parts;
    bool any = false;
    const auto stretch_end = [&](std::size_t i) {
        std::size_t end = i;
        while (end < there.size() && there[end] == there[i]) ++end;
        return end;
    };
    const auto length = [&](std::size_t from, std::size_t to) {
        return length_of(In<dvec2>(fine).subspan(from, to - from + 1));
    };
    for (std::size_t i = 0; i < there.size();) {
        const std::size_t end = stretch_end(i);
        if (there[i] && length(i, end) <= least) std::fill(there.begin() + i, there.begin() + end, false);
        any = any || there[i];
        i = end;
    }
    if (!any) return {line};
    for (std::size_t i = 0; i < there.size();) {
        const std::size_t end = stretch_end(i);
        if (!there[i] && length(i, end) > least)
            parts.push_back({Points(fine.begin() + i, fine.begin() + end + 1), false, line.origin, line.dash_of});
        i = end;
    }
    return parts;
}

/// An end of a line: number 2 l is the start of line l, 2 l + 1 its end.
dvec2 end_of(const std::vector<Line>& lines, std::size_t number) {
    const Points& points = lines[number / 2].points;
    return number % 2 ? points.back() : points.front();
}

/// Unit vector out of a line at one of its ends, over a length in which a bend counts.
dvec2 way_out(const std::vector<Line>& lines, std::size_t number, double over) {
    const Points& points = lines[number / 2].points;
    const dvec2 end = end_of(lines, number);
    dvec2 other = end;
    for (std::size_t k = 1; k < points.size() && glm::distance(other, end) < over; ++k)
        other = number % 2 ? points[points.size() - 1 - k] : points[k];
    return glm::length(end - other) > 0.0 ? glm::normalize(end - other) : dvec2(0.0);
}

/// Which end each end is joined to; `nobody`: to none.
constexpr std::size_t nobody = std::size_t(-1);

/// Ends of lines that may be joined to each other.
class Ends {
   public:
    Ends(const std::vector<Line>& lines, double near) : lines_(lines), near_(near), grid_(std::max(near, 1e-6)) {
        for (std::size_t e = 0; e < 2 * lines.size(); ++e) {
            ways_.push_back(way_out(lines, e, 5.0 * near));
            if (!lines[e / 2].closed) grid_.add(end_of(lines, e), e);
        }
    }

    /// By how much the way turns back, and two ends: of each end those that go on most straight.
    std::vector<std::tuple<double, std::size_t, std::size_t>> pairs() const {
        std::vector<std::tuple<double, std::size_t, std::size_t>> all;
        for (std::size_t e = 0; e < ways_.size(); ++e) {
            Cancelling::poll();
            if (lines_[e / 2].closed) continue;
            for (const auto& [turn, beyond] : partners(e)) {
                const std::size_t other = (e + beyond) % ways_.size();
                all.emplace_back(turn, std::min(e, other), std::max(e, other));
            }
        }
        std::ranges::sort(all);
        const auto twice = std::ranges::unique(all);
        all.erase(twice.begin(), twice.end());
        return all;
    }

   private:
    /// The best partners of an end: the turn, and how many ends farther on they are. Equal turns have different best
    /// partners each.
    std::vector<std::pair<double, std::size_t>> partners(std::size_t e) const {
        std::vector<std::pair<double, std::size_t>> best;
        const dvec2 place = end_of(lines_, e);
        grid_.near(place, [&](std::size_t other) {
            if (!may_join(e, other) || glm::distance(end_of(lines_, other), place) > near_) return;
            const std::pair found(glm::dot(ways_[e], ways_[other]), (other + ways_.size() - e) % ways_.size());
            if (best.size() == most_partners && found >= best.back()) return;
            if (best.size() == most_partners) best.pop_back();
            best.insert(std::ranges::upper_bound(best, found), found);
        });
        return best;
    }

    bool may_join(std::size_t a, std::size_t b) const {
        const Line &one = lines_[a / 2], &other = lines_[b / 2];
        if (a == b) return false;
        // A line that is shorter than that is no loop.
        if (a / 2 == b / 2) return length_of(one.points) >= 4.0 * near_;
        return one.dash_of == none || one.dash_of != other.dash_of;
    }

    const std::vector<Line>& lines_;
    double near_;
    PointGrid grid_;
    std::vector<dvec2> ways_;
};

std::vector<std::size_t> pairs_of(const std::vector<Line>& lines, double near) {
    std::vector<std::size_t> partner(2 * lines.size(), nobody);
    for (const auto& [turn, a, b] : Ends(lines, near).pairs())
        if (partner[a] == nobody && partner[b] == nobody) {
            partner[a] = b;
            partner[b] = a;
        }
    return partner;
}

/// Appends a line to another, from one of its ends on.
void append(const std::vector<Line>& lines, std::size_t from, Points& out) {
    Points more = lines[from / 2].points;
    if (from % 2) std::ranges::reverse(more);
    // Ends that are next to each other are one point.
    out.insert(out.end(), more.begin() + (out.empty() ? 0 : 1), more.end());
}

}  // namespace

std::vector<Line> without_doubles(std::vector<Line> lines, double near, double least) {
    std::vector<std::size_t> order(lines.size());
    std::iota(order.begin(), order.end(), 0);
    std::vector<double> lengths;
    for (const Line& line : lines) lengths.push_back(length_of(line.points));
    std::ranges::stable_sort(order, std::ranges::greater(), [&](std::size_t i) { return lengths[i]; });
    Kept kept(near);
    std::vector<Line> left;
    for (const std::size_t i : order) {
        Cancelling::poll();
        for (Line& part : left_of_line(lines[i], kept, least)) {
            kept.add(part.points);
            left.push_back(std::move(part));
        }
    }
    std::ranges::stable_sort(left, {}, &Line::origin);
    return left;
}

std::vector<Line> joined(std::vector<Line> lines, double near) {
    const std::vector<std::size_t> partner = pairs_of(lines, near);
    std::vector<bool> done(lines.size());
    std::vector<Line> all;
    const auto follow = [&](std::size_t from) {
        Line line{{}, false, lines[from / 2].origin};
        std::size_t end = from;
        while (end != nobody && !done[end / 2]) {
            done[end / 2] = true;
            line.origin = std::min(line.origin, lines[end / 2].origin);
            append(lines, end, line.points);
            end = partner[end ^ 1];
        }
        line.closed = lines[from / 2].closed || end == from;
        if (line.closed) line.points.back() = line.points.front();
        all.push_back(std::move(line));
    };
    for (std::size_t e = 0; e < partner.size(); ++e)
        if (partner[e] == nobody && !done[e / 2]) follow(e);
    for (std::size_t e = 0; e < partner.size(); ++e)
        if (!done[e / 2]) follow(e);
    std::ranges::stable_sort(all, {}, &Line::origin);
    return all;
}

}  // namespace fovea::vector
