// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fovea/base/check.h>
#include <fovea/runs/chain.h>
#include <fovea/runs/filters.h>
#include <fovea/runs/passes_behind.h>

namespace fovea::runs {
namespace {

constexpr double least_sine = 0.2588;  // sine of 15 degrees: bounds the length of gaps at grazing crossings

/// Subtracts the gaps from ascending, disjoint spans.
void cut_out(std::vector<Span>& gaps, std::vector<Span>& spans) {
    std::ranges::sort(gaps, {}, &Span::begin);
    join_spans(gaps, [](const Span& before, const Span& gap) { return gap.begin <= before.end; });
    std::vector<Span> left;
    auto first = gaps.begin();
    for (Span span : spans) {
        while (first != gaps.end() && first->end <= span.begin) ++first;
        for (auto gap = first; gap != gaps.end() && gap->begin < span.end; ++gap) {
            if (span.begin < gap->begin) left.push_back({span.begin, gap->begin});
            span.begin = gap->end;
        }
        if (span.begin < span.end) left.push_back(span);
    }
    spans = std::move(left);
}

}  // namespace

Runs halo(const ClippedPaths& clipped, const Runs& runs, In<float> gap_px, In<std::uint8_t> of_view) {
    check_runs(clipped, runs);
    check(clipped.path.empty() || clipped.path.back() < gap_px.size(), "gap_px: one value per path expected");
    check(of_view.empty() || of_view.size() == gap_px.size(), "of_view: one value per path expected");
    Array<std::uint8_t> wanted(gap_px.size());
    for (std::size_t p = 0; p < gap_px.size(); ++p) {
        check(std::isfinite(gap_px[p]) && gap_px[p] >= 0.0f, "gap_px: not a number of 0 or more");
        wanted[p] = gap_px[p] > 0.0f;
    }
    if (std::ranges::find(wanted, 1) == wanted.end()) return runs;
    const Array<PassBehind> passes = passes_behind(clipped, runs, wanted);
    const auto changes = [&](Index path) { return wanted[path] != 0; };
    return change_visible(clipped, runs, changes, [&](Index path, const Chain& chain, std::vector<Span>& spans) {
        const double gap = gap_px[path];
        const bool contour = !of_view.empty() && of_view[path];
        std::vector<Span> gaps;
        for (const auto& [piece, shift] : chain.parts()) {
            for (const PassBehind& pass : std::ranges::equal_range(passes, piece, {}, &PassBehind::piece)) {
                if (contour && pass.sine < least_sine) continue;
                const double at = pass.arc_px + shift, along = gap / std::max(pass.sine, least_sine);
                gaps.push_back({at - along, at + along});
                if (!chain.cyclic) continue;
                gaps.push_back({at - along - chain.length(), at + along - chain.length()});
                gaps.push_back({at - along + chain.length(), at + along + chain.length()});
            }
        }
        cut_out(gaps, spans);
    });
}

}  // namespace fovea::runs
