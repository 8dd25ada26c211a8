// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/base/check.h>
#include <fovea/runs/chain.h>
#include <fovea/runs/filters.h>

namespace fovea::runs {
namespace {

/// Joins spans whose gap is shorter than gap_px, across the seam of a closed line, too.
void join(const Chain& chain, double gap_px, std::vector<Span>& spans) {
    join_spans(spans, [&](const Span& before, const Span& span) { return span.begin - before.end < gap_px; });
    if (!chain.cyclic || spans.empty()) return;
    const double first = spans.front().begin + chain.length();
    if (chain.is_whole(spans.back()) || first - spans.back().end >= gap_px) return;
    if (spans.size() == 1) {
        spans.front() = {chain.begin, chain.end};
    } else {
        spans.back().end = spans.front().end + chain.length();
        spans.erase(spans.begin());
    }
}

}  // namespace

Runs close_gaps(const ClippedPaths& clipped, const Runs& runs, double gap_px, In<float> spur_px, double speck_px) {
    check(clipped.path.empty() || clipped.path.back() < spur_px.size(), "spur_px: one value per path expected");
    const auto changes = [&](Index path) { return gap_px > 0.0 || spur_px[path] > 0.0f || speck_px > 0.0; };
    return change_visible(clipped, runs, changes, [&](Index path, const Chain& chain, std::vector<Span>& spans) {
        join(chain, gap_px, spans);
        const double spur = spur_px[path];
        std::erase_if(spans, [&](const Span& span) {
            const bool from_begin = chain.reaches_begin(span), to_end = chain.reaches_end(span);
            if ((from_begin && to_end) || chain.is_whole(span)) return false;
            return span.length() < (from_begin || to_end ? speck_px : spur);
        });
    });
}

}  // namespace fovea::runs
