// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/line/dark_parts.h>

namespace fovea::line {
namespace {

/// Points that may be nearer to what hides them than rays tell apart (LightEye::pass) are left to rays.
constexpr double certain = 3.0 * scene::ray_margin;

}  // namespace

void DarkParts::next_segment(const dvec3& from, const dvec3& to, const Ignore& ignore) {
    from_ = from;
    to_ = to;
    ignore_ = ignore;
    hiding_.next_segment();
}

Interval DarkParts::known(double t) {
    const Interval* part = hiding_.around(t, [&](const Occluding& by) { return of(by); });
    return part ? *part : Interval{};
}

Interval DarkParts::hidden_by(const Hit& hit, double t) {
    const Occluding by(eye_.tracer, hit, certain);
    const Interval part = of(by);
    if (!part.holds(t)) return {t, t};
    hiding_.remember({by, part});
    return part;
}

}  // namespace fovea::line
