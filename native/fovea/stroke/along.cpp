// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/stroke/along.h>

#include <algorithm>
#include <cmath>

#include <fovea/base/elementary.h>
#include <fovea/base/view.h>
#include <fovea/stroke/anchor.h>

namespace fovea::stroke {
namespace {

constexpr int curve_steps = 64;               // of a transfer function, which is linear between them
constexpr double step_px = 0.6;               // half the length over which a step of a transfer function is drawn
constexpr double depth_step_px = 16.0;        // px between knots of distance, which perspective bends
constexpr float paint_step = 1.0f / 64.0f;    // largest change of what is painted between two knots
constexpr double straight = 0.9995;           // cosine of the largest bend that does not change a nib: 2 degrees
constexpr std::uint64_t of_modifiers = 0xa1;  // noise of modifiers is not that of wobble

/// Position on a line at an arc length; beyond its ends that of the end, or around a closed line.
dvec2 place(const CenterLine& line, bool closed, double arc) {
    const double start = line.front().arc, length = line.back().arc - start;
    if (closed) arc -= length * std::floor((arc - start) / length);
    const auto above = std::upper_bound(line.begin() + 1, line.end() - 1, arc,
                                        [](double value, const CenterPoint& p) { return value < p.arc; });
    const CenterPoint &a = *(above - 1), &b = *above;
    const double t = b.arc > a.arc ? std::clamp((arc - a.arc) / (b.arc - a.arc), 0.0, 1.0) : 0.0;
    return glm::mix(a.px, b.px, t);
}

/// Knots of a transfer function, as fractions of a stroke; a step has one.
void add_places(const style::Transfer& transfer, std::vector<double>& places) {
    if (transfer.strength == 0.0) return;
    const int steps = transfer.curve.empty() ? 1 : curve_steps;
    for (int k = 0; k <= steps; ++k) places.push_back(glm::mix(transfer.start, transfer.end, double(k) / steps));
}

/// What is left of a mix of two pens' values after each loses its share.
float left(float near, float away, float mix, float near_share, float away_share) {
    const float whole = glm::mix(near, away, mix);
    return whole > 0.0f ? glm::mix(near * (1.0f - near_share), away * (1.0f - away_share), mix) / whole : 0.0f;
}

/// Per-point values of Paths at an arc length, clamped to the piece; `otherwise` without values.
template <typename T>
T value_at(const Course& course, In<T> values, double arc, const T& otherwise) {
    if (values.empty()) return otherwise;
    const ClippedPaths& clipped = course.clipped;
    const Index i = clipped.segment_at(course.piece, arc);
    const float t = float(clipped.in_space(i, clipped.share_at(i, arc)));
    return glm::mix(clipped.at_point(values, i), clipped.at_point(values, i + 1), t);
}

}  // namespace

double distance_at(const ClippedPaths& clipped, Index piece, double arc) {
    const Index i = clipped.segment_at(piece, arc);
    return -clipped.position_at(i, clipped.share_at(i, arc)).z;
}

Modifiers::Modifiers(const Pen& pen, const PenPaint& paint)
    : nib_{vec3(pen.look.nib_width, pen.look.nib_opacity, pen.look.nib_color)},
      distance_{vec3(pen.look.distance_width, pen.look.distance_opacity, pen.look.distance_color)},
      noise_{vec3(pen.look.noise_width, pen.look.noise_opacity, pen.look.noise_color)},
      nib_direction_(cosine(glm::radians(pen.look.nib_angle)), sine(glm::radians(pen.look.nib_angle))),
      reach_px_(std::max(0.5 * pen.width_px, 1.0)),
      near_(pen.look.distance_near),
      far_(pen.look.distance_far),
      wave_px_(pen.look.noise_length),
      paint_(paint),
      color_(pen.look.color) {
    const style::Transfer* const given[] = {&pen.look.along_width, &pen.look.along_opacity, &pen.look.along_color};
    for (int k = 0; k < 3; ++k) {
        transfers_[k] = transfer_of(*given[k]);
        add_places(*given[k], places_);
    }
    along_ = !places_.empty();
}

void Modifiers::add_knots(const CenterLine& line, const Course& course, std::vector<double>& arcs) const {
    const double start = line.front().arc, length = line.back().arc - start;
    for (const double share : places_)
        for (const double side : {-step_px, step_px}) arcs.push_back(start + length * share + side);
    if (nib_.any) {
        const std::size_t last = line.size() - 1;
        for (std::size_t i = course.closed ? 0 : 1; i < last; ++i) {
            const dvec2 before = glm::normalize(line[i].px - line[i > 0 ? i - 1 : last - 1].px);
            if (glm::dot(before, glm::normalize(line[i + 1].px - line[i].px)) > straight) continue;
            for (const double beside : {-1.0, -0.5, 0.5, 1.0}) {
                const double arc = line[i].arc + beside * reach_px_;
                arcs.push_back(arc < start ? arc + length : arc);
            }
        }
    }
    const auto add_multiples = [&](double step) {
        const std::vector<double> more = multiples(line, step);
        arcs.insert(arcs.end(), more.begin(), more.end());
    };
    if (distance_.any) add_multiples(depth_step_px);
    if (noise_.any) add_multiples(std::max(wave_px_ / steps_per_wave, 1.0));
    if (!paint_.any()) return;
    const std::size_t before = arcs.size();
    add_knots_of_paint(course, arcs);
    // In perspective what is linear in space is not so in the image.
    if (!course.clipped.orthographic && arcs.size() > before) add_multiples(depth_step_px);
}

/// The points of the piece at both sides of each change.
void Modifiers::add_knots_of_paint(const Course& course, std::vector<double>& arcs) const {
    const ClippedPaths& clipped = course.clipped;
    const auto differs = [&](Index a, Index b) {
        const auto far = [&](In<float> values) {
            return !values.empty() && std::abs(clipped.at_point(values, a) - clipped.at_point(values, b)) > paint_step;
        };
        if (far(paint_.width) || far(paint_.opacity)) return true;
        if (paint_.color.empty()) return false;
        const vec3 change = glm::abs(clipped.at_point(paint_.color, a) - clipped.at_point(paint_.color, b));
        return std::max({change.x, change.y, change.z}) > paint_step;
    };
    Index before = clipped.pieces.begin(course.piece);
    for (Index i = before + 1; i < clipped.pieces.end(course.piece); ++i) {
        if (!differs(before, i)) continue;
        arcs.push_back(clipped.arc_px[i - 1]);
        arcs.push_back(clipped.arc_px[i]);
        before = i;
    }
}

vec3 Modifiers::at(const CenterLine& line, const Course& course, const CenterPoint& point) const {
    const double arc = point.arc;
    vec3 taken(0.0f);
    if (along_) {
        const double start = line.front().arc;
        const float share = float((arc - start) / (line.back().arc - start));
        taken = vec3(transfers_[0](share), transfers_[1](share), transfers_[2](share));
    }
    if (nib_.any) {
        const dvec2 way = place(line, course.closed, arc + reach_px_) - place(line, course.closed, arc - reach_px_);
        const double length = glm::length(way);
        const double across = length > 0.0 ? std::abs(cross(way, nib_direction_)) / length : 1.0;
        taken = focus::both(taken, nib_.share * float(1.0 - across));
    }
    if (distance_.any) {
        const double away = distance_at(course.clipped, course.piece, arc);
        const double share = far_ != near_ ? (away - near_) / (far_ - near_) : double(away >= far_);
        taken = focus::both(taken, distance_.share * float(std::clamp(share, 0.0, 1.0)));
    }
    if (noise_.any) {
        const double noise = 0.5 + 0.5 * noise_along(point, wave_px_, course.hand.stream(of_modifiers));
        taken = focus::both(taken, noise_.share * float(noise));
    }
    if (paint_.any()) {
        const float width = value_at(course, paint_.width, arc, 1.0f);
        const float opacity = value_at(course, paint_.opacity, arc, 1.0f);
        taken = focus::both(taken, vec3(1.0f - width, 1.0f - opacity, 0.0f));
    }
    return taken;
}

dvec3 Modifiers::color_at(const Course& course, double arc) const {
    return paint_.color.empty() ? color_ : dvec3(value_at(course, paint_.color, arc, vec3(0.0f)));
}

void modify(CenterLine& line, const PenPair& pens, const Modifiers& in_focus, const Modifiers& out_of_focus,
            const Course& course) {
    if (line.size() < 2 || !(in_focus.any() || out_of_focus.any())) return;
    std::vector<double> arcs;
    in_focus.add_knots(line, course, arcs);
    if (&in_focus != &out_of_focus) out_of_focus.add_knots(line, course, arcs);
    std::ranges::sort(arcs);
    insert_points(line, arcs);
    const Pen &near_pen = pens.in_focus, &away_pen = pens.out_of_focus;
    const float near_opacity = float(near_pen.look.opacity), away_opacity = float(away_pen.look.opacity);
    for (CenterPoint& p : line) {
        const vec3 near = in_focus.at(line, course, p);
        const vec3 away = &in_focus == &out_of_focus ? near : out_of_focus.at(line, course, p);
        thin(p, left(near_pen.width_px, away_pen.width_px, p.mix.z, near.x, away.x));
        p.opacity *= left(near_opacity, away_opacity, p.mix.w, near.y, away.y);
        p.tint = glm::mix(near.z, away.z, p.mix.x);
    }
}

void color(CenterLine& line, const Modifiers& in_focus, const Modifiers& out_of_focus, const Course& course) {
    for (CenterPoint& p : line) {
        const dvec3 near = in_focus.color_at(course, p.arc);
        p.color =
            &in_focus == &out_of_focus ? near : glm::mix(near, out_of_focus.color_at(course, p.arc), double(p.mix.x));
    }
}

}  // namespace fovea::stroke
