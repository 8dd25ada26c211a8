// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/stroke/center_line.h>

#include <algorithm>
#include <cmath>
#include <ranges>

namespace fovea::stroke {

namespace {

constexpr double small_step = 1.5;      // px; longer steps are shape, not noise of a dense mesh
constexpr double largest_shift = 0.15;  // px by which smoothing may move a point
constexpr double shortest = 0.05;       // px between neighbors; shorter segments have no reliable direction
constexpr float strength_step = 0.05f;  // change of strength at which a point is kept
constexpr int taper_steps = 4;
constexpr double most_overshoot = 1000.0;  // px
/// Of a tapered end, in pen widths; above 0, so that corners of the drawing stay closed.
constexpr double tip_width = 0.2;

CenterPoint mix(const CenterPoint& a, const CenterPoint& b, double t) {
    const float s = float(t);
    return {glm::mix(a.px, b.px, t),
            glm::mix(a.arc, b.arc, t),
            glm::mix(a.half_width, b.half_width, s),
            glm::mix(a.opacity, b.opacity, s),
            glm::mix(a.mix, b.mix, s),
            glm::mix(a.shown, b.shown, s),
            glm::mix(a.seen, b.seen, s),
            glm::mix(a.faint, b.faint, s),
            glm::mix(a.tint, b.tint, s),
            glm::mix(a.thinness, b.thinness, s),
            glm::mix(a.color, b.color, t),
            glm::mix(a.along, b.along, t),
            glm::mix(a.whole_px, b.whole_px, t),
            a.way,
            glm::mix(a.noise_along, b.noise_along, t),
            glm::mix(a.next_along, b.next_along, t),
            a.next};
}

CenterPoint point_of(const ClippedPaths& clipped, In<float> strength, Index i) {
    float s = strength.empty() ? 1.0f : clipped.at_point(strength, i);
    s = s > 0.0f ? std::min(s, 1.0f) : 0.0f;  // NaN: 0
    return {dvec2(clipped.px[i]), clipped.arc_px[i], 0.0f, s};
}

/// The cone of directions from `origin` that pass all points seen so far within the tolerance.
class Cone {
   public:
    Cone(const CenterPoint& origin, double tolerance) : origin_(origin), tolerance_(tolerance) {}

    bool admits(const CenterPoint& p) const {
        if (std::abs(p.opacity - origin_.opacity) > strength_step) return false;
        const dvec2 d = p.px - origin_.px;
        if (glm::length(d) < far_ - tolerance_) return false;  // turns back
        return far_ <= tolerance_ || (cross(right_, d) >= 0.0 && cross(d, left_) >= 0.0);
    }

    void narrow(const CenterPoint& p) {
        const dvec2 d = p.px - origin_.px;
        const double distance = glm::length(d);
        if (distance > tolerance_) {
            const double s = tolerance_ / distance, c = std::sqrt(1.0 - s * s);
            const dvec2 right(d.x * c + d.y * s, d.y * c - d.x * s), left(d.x * c - d.y * s, d.y * c + d.x * s);
            if (far_ <= tolerance_ || cross(right_, right) > 0.0) right_ = right;
            if (far_ <= tolerance_ || cross(left, left_) > 0.0) left_ = left;
        }
        far_ = std::max(far_, distance);
    }

   private:
    CenterPoint origin_;
    double tolerance_;
    double far_ = 0.0;
    dvec2 right_{0.0}, left_{0.0};
};

/// Binomial filter where both steps are small: straightens zigzags of a dense mesh.
void even_out(CenterLine& line) {
    dvec2 before = line.front().px;
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
        const dvec2 here = line[i].px, after = line[i + 1].px;
        if (glm::distance(before, here) < small_step && glm::distance(here, after) < small_step) {
            const dvec2 shift = 0.25 * (before - 2.0 * here + after);
            line[i].px += shift * std::min(1.0, largest_shift / std::max(glm::length(shift), 1e-9));
        }
        before = here;
    }
}

/// Width of the pens at this strength and mix; `opacity` still holds the strength.
float width_of(const PenPair& pens, const CenterPoint& p) {
    const float width = glm::mix(pens.in_focus.width_px, pens.out_of_focus.width_px, p.mix.z);
    return width * glm::mix(1.0f, p.opacity, float(pens.in_focus.look.strength_width));
}

/// Inserts points where strength reduces the width to one pixel, below which opacity is reduced instead.
void insert_where_thin(CenterLine& line, const PenPair& pens) {
    std::vector<double> arcs;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const float a = width_of(pens, line[i - 1]) - 1.0f, b = width_of(pens, line[i]) - 1.0f;
        if (a * b < 0.0f) arcs.push_back(glm::mix(line[i - 1].arc, line[i].arc, double(a / (a - b))));
    }
    if (!arcs.empty()) insert_points(line, arcs);
}

}  // namespace

void cut(const ClippedPaths& clipped, In<float> strength, Index piece, double start_px, double end_px,
         CenterLine& out) {
    out.clear();
    const Index begin = clipped.pieces.begin(piece), end = clipped.pieces.end(piece);
    if (end - begin < 2 || !(start_px < end_px)) return;
    const auto arc = clipped.arc_px.begin();
    // First point beyond the start, and first point not before the end; both have a predecessor in the piece.
    const Index first = Index(std::upper_bound(arc + begin + 1, arc + end - 1, start_px) - arc);
    const Index last = Index(std::lower_bound(arc + first, arc + end - 1, end_px) - arc);
    const auto at = [&](Index i, double arc_px) {
        const CenterPoint a = point_of(clipped, strength, i - 1), b = point_of(clipped, strength, i);
        const double length = b.arc - a.arc;
        return mix(a, b, length > 0.0 ? std::clamp((arc_px - a.arc) / length, 0.0, 1.0) : 0.0);
    };
    out.push_back(at(first, start_px));
    for (Index i = first; i < last; ++i) out.push_back(point_of(clipped, strength, i));
    out.push_back(at(last, end_px));
    std::erase_if(out, [](const CenterPoint& p) { return !std::isfinite(p.px.x + p.px.y + p.arc); });
}

void lengthen(CenterLine& line, double before_px, double after_px) {
    if (line.size() < 2) return;
    // Direction is measured over this length: the last segments on a dense mesh have no reliable direction.
    constexpr double look_back = 3.0;
    const auto beyond = [](const auto& from_end, double length, double sign) {
        CenterPoint end = *from_end.begin();
        const auto inner = std::ranges::find_if(
            from_end, [&](const CenterPoint& p) { return glm::distance(p.px, end.px) > look_back; });
        const dvec2 other = inner != from_end.end() ? inner->px : std::ranges::prev(from_end.end())->px;
        if (other == end.px) return end;
        end.px += glm::normalize(end.px - other) * length;
        end.go(sign * length);
        return end;
    };
    before_px = std::min(before_px, most_overshoot);
    after_px = std::min(after_px, most_overshoot);
    const CenterPoint first = beyond(line, before_px, -1.0);
    const CenterPoint last = beyond(std::views::reverse(line), after_px, 1.0);
    if (after_px > 0.0) line.push_back(last);
    if (before_px > 0.0) line.insert(line.begin(), first);
}

void cut_off(CenterLine& line, double arc) {
    std::size_t kept = std::size_t(std::ranges::lower_bound(line, arc, {}, &CenterPoint::arc) - line.begin());
    if (kept == line.size()) return;
    if (kept > 0 && arc - line[kept - 1].arc > shortest) {
        const CenterPoint &a = line[kept - 1], &b = line[kept];
        line[kept] = mix(a, b, (arc - a.arc) / (b.arc - a.arc));
        ++kept;
    }
    line.resize(kept);
}

void insert_points(CenterLine& line, In<double> arcs, double near_px) {
    CenterLine out{line.front()};
    std::size_t next = 0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const CenterPoint &a = line[i - 1], &b = line[i];
        for (; next < arcs.size() && arcs[next] < b.arc; ++next)
            if (arcs[next] > out.back().arc + near_px && arcs[next] < b.arc - near_px)
                out.push_back(mix(a, b, (arcs[next] - a.arc) / (b.arc - a.arc)));
        out.push_back(b);
    }
    line = std::move(out);
}

std::vector<double> multiples(const CenterLine& line, double step) {
    std::vector<double> arcs;
    for (double k = std::ceil(line.front().arc / step); k * step < line.back().arc; ++k) arcs.push_back(k * step);
    return arcs;
}

void simplify(CenterLine& line, double tolerance_px) {
    if (line.size() < 2) return line.clear();
    even_out(line);
    std::size_t kept = 1;
    Cone cone(line[0], tolerance_px);
    for (std::size_t i = 1; i < line.size(); ++i) {
        if (!cone.admits(line[i])) {
            if (glm::distance(line[i - 1].px, line[kept - 1].px) > shortest) line[kept++] = line[i - 1];
            cone = Cone(line[i - 1], tolerance_px);
        }
        cone.narrow(line[i]);
    }
    const CenterPoint end = line.back();
    while (kept > 0 && glm::distance(line[kept - 1].px, end.px) <= shortest) --kept;
    // If no point is left the line has no direction. Else the last point is replaced by the true end.
    if (kept > 0) line[kept++] = end;
    line.resize(kept);
}

void shape(CenterLine& line, const PenPair& pens, TaperedEnds tapered) {
    if (line.size() < 2) return;
    const Pen& pen = pens.in_focus;
    const float opacity = float(pen.look.opacity), away = float(pens.out_of_focus.look.opacity);
    insert_where_thin(line, pens);
    const double start = line.front().arc, end = line.back().arc;
    const bool any = tapered.start || tapered.end;
    const double full_taper = float(pen.look.taper);
    const double taper = any ? std::min(full_taper, (end - start) / 2.0) : 0.0;
    if (taper > 0.0) {
        double arcs[2 * taper_steps];
        for (int k = 1; k <= taper_steps; ++k) {
            arcs[k - 1] = start + taper * k / taper_steps;
            arcs[2 * taper_steps - k] = end - taper * k / taper_steps;
        }
        insert_points(line, arcs);
    }
    // A line too short for a full taper thins less, so that a row of short ones does not look like beads.
    const double thinning = taper > 0.0 ? (1.0 - tip_width) * (taper / full_taper) : 0.0;
    const auto along = [&](bool tapers, double distance) {
        return tapers && taper > 0.0 ? std::clamp(distance / taper, 0.0, 1.0) : 1.0;
    };
    for (CenterPoint& p : line) {
        const double x = std::min(along(tapered.start, p.arc - start), along(tapered.end, end - p.arc));
        const float width = width_of(pens, p) * float(1.0 - thinning * (1.0 - x) * (1.0 - x));
        const float faded = glm::mix(p.opacity, 1.0f, float(pen.look.strength_width));
        p.half_width = std::max(width, 1.0f) / 2.0f;
        p.thinness = std::min(width, 1.0f);
        p.opacity = faded * p.thinness * glm::mix(opacity, away, p.mix.w) * p.shown;
    }
}

void thin(CenterPoint& point, float factor) {
    const float width = 2.0f * point.half_width * factor;
    point.half_width = std::max(width, 1.0f) / 2.0f;
    point.thinness *= std::min(width, 1.0f);
    point.opacity *= std::min(width, 1.0f);
}

void extend(CenterLine& line, Cap cap) {
    if (line.size() < 2) return;
    const auto beyond = [&](CenterPoint end, dvec2 inner, double sign) {
        const double reach = (cap == Cap::round ? end.half_width : 0.0) + 0.5;
        end.px += glm::normalize(end.px - inner) * reach;
        end.go(sign * reach);
        return end;
    };
    const CenterPoint first = beyond(line.front(), line[1].px, -1.0);
    line.push_back(beyond(line.back(), line[line.size() - 2].px, 1.0));
    line.insert(line.begin(), first);
}

}  // namespace fovea::stroke
