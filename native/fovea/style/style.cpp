// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/style/style.h>

#include <algorithm>

namespace fovea::style {
namespace {

const Pen* given(const std::optional<Pen>& pen) { return pen ? &*pen : nullptr; }

}  // namespace

std::vector<PenPair> Style::pen_pairs() const {
    std::vector<PenPair> pairs;
    for (const LineSet& set : line_sets) pairs.push_back({&set.pen, given(set.pen_away)});
    for (const LineSet& set : line_sets)
        for (const Hidden& hidden : set.hidden) pairs.push_back({&hidden.pen, given(hidden.pen_away)});
    return pairs;
}

bool Style::has_away() const {
    return std::ranges::any_of(pen_pairs(), [](const PenPair& pair) { return pair.away != nullptr; }) ||
           std::ranges::any_of(line_sets, [](const LineSet& set) { return set.overshoot_away.has_value(); });
}

bool Style::fixes_marks() const {
    return std::ranges::any_of(pen_pairs(), [](const PenPair& pair) {
        return pair.pen->texture_anchor == Anchor::path || (pair.away && pair.away->texture_anchor == Anchor::path);
    });
}

Index Style::counted() const {
    int most = 0;
    for (const LineSet& set : line_sets)
        for (const Hidden& hidden : set.hidden) most = std::max(most, hidden.last ? *hidden.last + 1 : hidden.first);
    return static_cast<Index>(most);
}

double Style::width_px(const Pen& pen, double reference_scale) const {
    switch (pen.width_unit) {
        case WidthUnit::pixels:
            return pen.width;
        case WidthUnit::millimetres:
            return pen.width * paper.px_per_mm(reference_scale);
        default:
            return pen.width * reference_scale;
    }
}

}  // namespace fovea::style
