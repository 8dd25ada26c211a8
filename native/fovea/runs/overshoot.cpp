// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fovea/base/check.h>
#include <fovea/runs/chain.h>
#include <fovea/runs/filters.h>

namespace fovea::runs {
namespace {

void check_amounts(const ClippedPaths& clipped, In<float> amounts, const char* name) {
    check(clipped.path.empty() || clipped.path.back() < amounts.size(),
          std::string(name) + ": one value per path expected");
    for (float amount : amounts) check(std::isfinite(amount), std::string(name) + ": not a finite number");
}

/// Length of a line that may be hidden at its end, where a corner touches a surface.
constexpr double hidden_rest_px = 1.0;

/// Extension of a span whose line ends `rest` pixels after the span. A line that a surface hides stops at the edge of
/// that surface; negative amounts apply there, too.
double beyond(double amount, bool line_ends, double rest) {
    if (amount <= 0.0) return amount;
    return line_ends ? amount * std::clamp(2.0 - rest / hidden_rest_px, 0.0, 1.0) : 0.0;
}

}  // namespace

Runs overshoot(const ClippedPaths& clipped, const Runs& runs, In<float> amount_px, In<float> other_px, In<float> mix) {
    const bool mixed = !other_px.empty();
    check_amounts(clipped, amount_px, "amount_px");
    if (mixed) check_amounts(clipped, other_px, "other_px");
    check(!mixed || mix.size() == clipped.samples, "mix: one value per atlas sample expected");
    const auto changes = [&](Index path) { return amount_px[path] != 0.0f || (mixed && other_px[path] != 0.0f); };
    return change_visible(clipped, runs, changes, [&](Index path, const Chain& chain, std::vector<Span>& spans) {
        const auto amount = [&](double at) -> double {
            if (!mixed) return amount_px[path];
            return glm::mix(amount_px[path], other_px[path], chain.value(clipped, mix, at, 0.0f));
        };
        for (Span& span : spans) {
            if (chain.is_whole(span)) continue;
            const double before = amount(span.begin), after = amount(span.end);
            const double rest_before = span.begin - chain.begin, rest_after = chain.end - span.end;
            // No extension at the frame, where the line continues.
            if (chain.ends_at_begin || !chain.reaches_begin(span))
                span.begin -= beyond(before, chain.ends_at_begin, rest_before);
            if (chain.ends_at_end || !chain.reaches_end(span)) span.end += beyond(after, chain.ends_at_end, rest_after);
        }
        std::erase_if(spans, [](const Span& span) { return span.begin >= span.end; });
    });
}

}  // namespace fovea::runs
