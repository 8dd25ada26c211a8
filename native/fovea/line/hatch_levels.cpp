// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/line/hatch_levels.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace fovea::line {
namespace {

/// Of the spacing between lines where the surface faces the viewer, that where it is almost parallel to the planes is
/// not more than this many times as dense in space: there lines would turn with every ripple.
constexpr double most_turned = 8.0;

/// Lines of a family on one triangle, at most; more are left out in coarser powers of two.
constexpr double most_levels = 4096.0;

/// Slabs of a triangle, at most. What is so many times twice as far away as its nearest part has no size that numbers
/// could tell, in a placement by an enormous matrix.
constexpr int most_slabs = 48;

/// Margin of the frame beyond which there are no lines, as a share of its half size: that of project/clip.h and more.
constexpr double frame_margin = 0.15;

using Polygon = std::vector<HatchSpot>;

Polygon clipped(const Polygon& polygon, const auto& distance) {
    Polygon kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const HatchSpot &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double da = distance(a.at), db = distance(b.at);
        if (da >= 0.0) kept.push_back(a);
        if ((da >= 0.0) != (db >= 0.0)) kept.push_back(mix(a, b, da / (da - db)));
    }
    return kept;
}

}  // namespace

HatchSpot mix(const HatchSpot& a, const HatchSpot& b, double t) {
    const dvec3 normal = glm::mix(a.normal, b.normal, t);
    const double length = glm::length(normal);
    return {glm::mix(a.at, b.at, t), length > 0.0 ? normal / length : a.normal};
}

void ChordPart::clip(double at_0, double at_1) {
    if (at_0 >= 0.0 && at_1 >= 0.0) return;
    if (!(at_0 > 0.0) && !(at_1 > 0.0)) {
        to = -1.0;
        return;
    }
    const double zero = at_0 / (at_0 - at_1);
    if (at_0 < at_1)
        from = std::max(from, zero);
    else
        to = std::min(to, zero);
}

HatchLevels::HatchLevels(const View& view, double spacing)
    : view_(view),
      per_px_{2.0 / (std::abs(view.view_to_clip[0][0]) * view.width),
              2.0 / (std::abs(view.view_to_clip[1][1]) * view.height)},
      spacing_(spacing) {}

double HatchLevels::distance_to(int plane, const dvec3& p) const {
    if (plane == 0) return -p.z - view_.near_clip;
    const dvec4 clip = view_.view_to_clip * dvec4(p, 1.0);
    const double w = clip.w * (1.0 + frame_margin), along = plane < 3 ? clip.x : clip.y;
    return w + (plane & 1 ? along : -along);
}

int HatchLevels::outcode(const dvec3& p) const {
    int bits = 0;
    for (int plane = 0; plane < planes; ++plane) bits |= (distance_to(plane, p) < 0.0) << plane;
    return bits;
}

ChordPart HatchLevels::in_frame(const dvec3& from, const dvec3& to) const {
    ChordPart part;
    for (int plane = 0; plane < planes; ++plane) part.clip(distance_to(plane, from), distance_to(plane, to));
    return part;
}

double HatchLevels::px_at(const dvec3& p) const {
    const dvec2 sides = sides_of_px(p);
    return std::max(sides.x, sides.y);
}

double HatchLevels::apart_px(const HatchFamily& family, const HatchSpot& spot) const {
    const dvec3 way = view_.orthographic ? dvec3(0, 0, -1) : spot.at;
    const double facing = glm::dot(spot.normal, way);
    const dvec3 slope = family.along * facing - spot.normal * glm::dot(family.along, way);
    const dvec2 px = sides_of_px(spot.at);
    const double steep = glm::length(dvec2(slope) * px);
    const double most = most_turned / (glm::length(family.along) * std::max(px.x, px.y));
    return steep * most > -facing ? -facing / steep : most;
}

int HatchLevels::power_for(double apart) const {
    int power = 0;
    const double share = std::frexp(spacing_ * std::numbers::sqrt2 * 0.5 / apart, &power);
    return share == 0.5 ? power - 1 : power;
}

/// Upper bound of apart_px over a polygon in a plane with a normal. The gradient of a family in the image is, at
/// any distance, the distance times what depends on the value of the family alone.
double HatchLevels::most_apart(const HatchFamily& family, const Polygon& polygon, const dvec3& normal, double low,
                               double high) const {
    double apart = 0.0, near = HUGE_VAL;
    for (const HatchSpot& corner : polygon) {
        apart = std::max(apart, apart_px(family, corner));
        near = std::min(near, -corner.at.z);
    }
    if (view_.orthographic) return apart;
    const double offset = glm::dot(normal, polygon[0].at);
    const dvec2 along = dvec2(family.along) * per_px_, turned = dvec2(normal) * per_px_;
    const double first = (low - family.offset) / offset, last = (high - family.offset) / offset,
                 flat = glm::dot(turned, turned), least = flat > 0.0 ? glm::dot(along, turned) / flat : 0.0;
    if (!std::isfinite(first + last)) return apart;
    const double at = std::clamp(least, std::min(first, last), std::max(first, last));
    const double most = most_turned / (glm::length(family.along) * std::max(per_px_.x, per_px_.y) * near);
    return std::max(apart, std::min(most, 1.0 / (near * glm::length(along - at * turned))));
}

/// Appends the multiples of a power of two between the values at a polygon's corners that may have a line there.
void HatchLevels::append(const HatchFamily& family, const Polygon& polygon, const dvec3& normal,
                         std::vector<HatchLevel>& found) const {
    constexpr double slack = 1.25;  // where normals are interpolated
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const HatchSpot& corner : polygon) {
        low = std::min(low, family.at(corner.at));
        high = std::max(high, family.at(corner.at));
    }
    if (!(low < high)) return;
    const double apart = most_apart(family, polygon, normal, low, high);
    if (!(apart > 0.0)) return;
    int power = power_for(apart * slack);
    if (power < -900 || power > 900) return;
    while ((high - low) > std::ldexp(most_levels, power)) ++power;
    const double step = std::ldexp(1.0, power), first = std::ceil(low / step), last = std::floor(high / step);
    if (!(std::abs(first) < 0x1p52 && std::abs(last) < 0x1p52)) return;
    for (double m = first; m <= last; ++m) {
        const auto number = static_cast<std::uint64_t>(std::abs(m));
        found.push_back({m * step, number == 0 ? 1000 : power + std::countr_zero(number)});
    }
}

std::vector<HatchLevel> HatchLevels::on(const HatchFamily& family, const Corners& corners, bool whole) const {
    std::vector<HatchLevel> found;
    const dvec3 normal = glm::cross(corners[1].at - corners[0].at, corners[2].at - corners[0].at);
    Polygon polygon(corners.begin(), corners.end());
    double near = HUGE_VAL, far = 0.0;
    const auto measure = [&] {
        near = HUGE_VAL, far = 0.0;
        for (const HatchSpot& corner : polygon) near = std::min(near, -corner.at.z), far = std::max(far, -corner.at.z);
    };
    measure();
    if (whole && (view_.orthographic || far < 1.5 * near)) {
        append(family, polygon, normal, found);
        return found;
    }
    for (int plane = 0; plane < planes && !polygon.empty(); ++plane)
        polygon = clipped(polygon, [&](const dvec3& p) { return distance_to(plane, p); });
    measure();
    // Slabs of twice the distance each, in which spacing differs little. Of huge triangles clipping is not exact.
    double split = view_.orthographic ? HUGE_VAL : 2.0 * std::max(near, view_.near_clip);
    for (int slab = 0; slab < most_slabs && polygon.size() >= 3; ++slab, split *= 2.0) {
        append(family, clipped(polygon, [&](const dvec3& p) { return p.z + split; }), normal, found);
        if (!(split < far)) break;
        polygon = clipped(polygon, [&](const dvec3& p) { return -split - p.z; });
    }
    std::ranges::sort(found, {}, &HatchLevel::value);
    const auto rest = std::ranges::unique(found, {}, &HatchLevel::value);
    found.erase(rest.begin(), rest.end());
    return found;
}

double HatchLevels::least_apart(const HatchLevel& level) const {
    return level.power > 900 ? 0.0 : spacing_ / (std::ldexp(1.0, level.power) * std::numbers::sqrt2);
}

ChordPart HatchLevels::where_apart(const HatchFamily& family, const HatchSpot& from, const HatchSpot& to, double least,
                                   const ChordPart& part) const {
    if (least == 0.0) return part;
    const HatchSpot a = mix(from, to, part.from), b = mix(from, to, part.to);
    const double first = apart_px(family, a), last = apart_px(family, b);
    const bool is_flat = glm::distance(a.normal, b.normal) < 1e-6 && first > 0.0 && last > 0.0;
    ChordPart inside;
    if (is_flat)
        inside.clip(1.0 / least - 1.0 / first, 1.0 / least - 1.0 / last);
    else
        inside.clip(first - least, last - least);
    ChordPart found = part;
    const double way = part.to - part.from;
    if (inside.from > 0.0) found.from = part.from + inside.from * way;
    if (inside.to < 1.0) found.to = part.from + inside.to * way;
    return found;
}

}  // namespace fovea::line
