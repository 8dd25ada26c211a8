// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/focus/transfer.h>

#include <cmath>

#include <fovea/base/check.h>
#include <fovea/focus/monotone_cubic.h>

namespace fovea::focus {
namespace {

void check_curve(In<vec2> curve) {
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const vec2 p = curve[i];
        check(p.x >= 0.0f && p.x <= 1.0f && p.y >= 0.0f && p.y <= 1.0f,
              "transfer: points of the curve must lie between 0 and 1");
        check(i == 0 || curve[i - 1].x < p.x, "transfer: points of the curve must ascend in x");
    }
}

}  // namespace

Transfer::Transfer(float start, float end, float strength, In<vec2> curve, float factor)
    : start_(start), end_(end), strength_(strength * factor) {
    check(std::isfinite(start) && std::isfinite(end), "transfer: start and end must be finite");
    check(strength >= 0.0f && strength <= 1.0f, "transfer: the strength must lie between 0 and 1");
    check_curve(curve);
    for (int k = 0; k <= steps; ++k) response_[k] = float(k) / steps;
    if (curve.empty()) return;
    const MonotoneCubic response(curve);
    for (float& y : response_) y = response(y);
}

Transfer transfer_of(const style::Transfer& transfer, double emphasis) {
    const double factor = transfer.start > transfer.end ? 1.0 / emphasis : emphasis;
    const std::vector<vec2> curve(transfer.curve.begin(), transfer.curve.end());
    return Transfer(float(transfer.start), float(transfer.end), float(transfer.strength), curve, float(factor));
}

}  // namespace fovea::focus
