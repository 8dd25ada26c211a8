// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/stroke/vanish.h>

#include <algorithm>

#include <fovea/stroke/anchor.h>
#include <fovea/stroke/fragment.h>

namespace fovea::stroke {
namespace {

constexpr std::uint64_t of_blots = 0xb2;  // its noise is not that of the hand
constexpr double blot_widths = 4.0;       // length of a blot and a gap, in widths of the pen
constexpr double least_blot = 8.0;        // px
constexpr double steps_per_blot = 8.0;
constexpr float softness = 0.25f;  // range of shares over which a place comes or goes

/// Up to how much ink of a pen's texture nothing is left where a share of the time is seen: at 1 none of it goes, at 0
/// all, with the softness at its edge.
float faint_ink(const Pen& pen, float seen) {
    const float gone = 1.0f - std::clamp(seen, 0.0f, 1.0f), at = gone * float(pen.ink_levels.size() - 1);
    const std::size_t level = std::min(std::size_t(at), pen.ink_levels.size() - 2);
    const float ink = glm::mix(pen.ink_levels[level], pen.ink_levels[level + 1], at - float(level));
    return gone > 0.0f ? ink + gone * formulas::Stroke{}.ink_softness() : 0.0f;
}

void break_up(CenterLine& line, const Pen& pen, const Hand& hand) {
    if (std::ranges::all_of(line, [](const CenterPoint& p) { return p.seen == 1.0f; })) return;
    const double length = std::max(blot_widths * pen.width_px, least_blot);
    insert_points(line, multiples(line, length / steps_per_blot));
    if (pen.texture != none) {
        for (CenterPoint& p : line) p.faint = faint_ink(pen, p.seen);
        return;
    }
    const Hand own = hand.stream(of_blots);
    for (CenterPoint& p : line) {
        const float threshold = float(0.5 + 0.5 * noise_along(p, length, own));
        thin(p, std::clamp((p.seen - threshold * (1.0f - softness)) / softness, 0.0f, 1.0f));
    }
}

}  // namespace

void vanish(CenterLine& line, style::Vanish how, const Pen& pen, const Hand& hand) {
    if (how == style::Vanish::break_up) return break_up(line, pen, hand);
    for (CenterPoint& p : line) {
        if (how == style::Vanish::fade) p.opacity *= p.seen;
        if (how == style::Vanish::shrink) thin(p, p.seen);
    }
}

}  // namespace fovea::stroke
