// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/draw/along_lines.h>

#include <cmath>

#include <fovea/base/check.h>
#include <fovea/base/elementary.h>
#include <fovea/focus/transfer.h>

namespace fovea::draw {
namespace {

/// Values of a definition's parameters, those in millimeters of paper in reference pixels.
Values on_page(const LineDefinition& definition, Values values, const style::Paper& paper) {
    for (std::size_t i = 0; i < values.size(); ++i)
        if (definition.parameters[i].unit == line::Unit::millimeters) values[i] *= paper.px_per_mm(1.0);
    return values;
}

constexpr float most_density = 4.0f;  // factor on the pens' density where a map is white

/// Calls visit(sample, path) for the samples of pieces that have runs.
template <typename Visit>
void each_sample_with_runs(const ClippedPaths& clipped, const Runs& runs, const Visit& visit) {
    for (std::size_t r = 0; r < runs.size(); ++r) {
        const Index piece = runs.piece[r];
        if (r > 0 && runs.piece[r - 1] == piece) continue;
        for (Index s = clipped.first_sample(piece); s < clipped.first_sample(piece + 1); ++s)
            visit(s, clipped.path[piece]);
    }
}

float answer(const std::optional<Transfer>& transfer, In<float> values, Index sample) {
    return transfer && !values.empty() ? (*transfer)(values[sample]) : 0.0f;
}

std::optional<Transfer> if_any(const style::Transfer& transfer, double emphasis = 1.0) {
    return transfer.strength == 0.0 ? std::nullopt : std::optional(transfer_of(transfer, emphasis));
}

}  // namespace

std::vector<LineSet> line_sets_of(const style::Style& style, const Overrides& overrides, const Files& files) {
    check(overrides.line_sets.empty() || overrides.line_sets.size() == style.line_sets.size(),
          "overrides: expected filters for each line set");
    std::vector<LineSet> sets;
    for (const style::LineSet& given : style.line_sets) {
        LineSet set;
        set.corner_angle_rad = glm::radians(given.corner_angle);
        set.surfaces = given.surfaces;
        if (style.effects.lines != style::Mode::none)
            for (const auto& [name, parameters] : given.kinds) {
                const Index definition = definition_index(name);
                const LineDefinition& known = *line_definitions()[definition];
                set.kinds.push_back({definition, on_page(known, values_of(known, parameters, files), style.paper)});
            }
        if (!overrides.line_sets.empty()) {
            set.placements = overrides.line_sets[sets.size()].placements;
            set.materials = overrides.line_sets[sets.size()].materials;
        }
        sets.push_back(std::move(set));
    }
    return sets;
}

Array<float> by_path(const Paths& paths, double scale, const std::vector<double>& of_set) {
    Array<float> amounts(paths.count());
    for (Index p = 0; p < paths.count(); ++p) amounts[p] = float(of_set[paths.line_set[p]] * scale);
    return amounts;
}

Array<float> spacing_by_path(const Paths& paths, double scale, const style::Style& style) {
    std::vector<double> of_set;
    for (const style::LineSet& set : style.line_sets) of_set.push_back(set.pen.spacing);
    return by_path(paths, scale, of_set);
}

Array<float> pen_width_of_runs(const style::Style& style, const Paths& paths, const ClippedPaths& clipped,
                               const Runs& runs, double scale) {
    std::vector<float> of_set;
    for (const style::LineSet& set : style.line_sets) of_set.push_back(float(style.width_px(set.pen, scale)));
    return parallel_map<float>(runs.size(),
                               [&](std::size_t r) { return of_set[paths.line_set[clipped.path[runs.piece[r]]]]; });
}

Array<std::uint8_t> folding(const Paths& paths) {
    Array<std::uint8_t> found = paths.of_view;
    std::ranges::replace(found, path::makes_tone, std::uint8_t(0));
    return found;
}

Array<Index> meeting(const Paths& paths) {
    return parallel_map<Index>(
        paths.count(), [&](std::size_t p) { return paths.of_view[p] == path::makes_tone ? none : paths.placement[p]; });
}

Array<float> by_view(const Paths& paths, double of_view, double other) {
    Array<float> amounts(paths.count());
    for (Index p = 0; p < paths.count(); ++p)
        amounts[p] = float(paths.of_view[p] && paths.of_view[p] != path::makes_tone ? of_view : other);
    return amounts;
}

Array<double> lengths_in_frame(const Paths& paths, const ClippedPaths& clipped) {
    Array<double> lengths(paths.count(), 0.0);
    for (Index q = 0; q < clipped.pieces.count(); ++q)
        lengths[clipped.path[q]] += clipped.last_arc(q) - clipped.first_arc(q);
    return lengths;
}

Array<float> inverted(Array<float> values) {
    parallel_for(values.size(), [&](std::size_t i) { values[i] = 1.0f - values[i]; });
    return values;
}

Array<float> half_width_px(const style::Style& style, const Paths& paths, const ClippedPaths& clipped, const Runs& runs,
                           const Density& density, double scale) {
    std::vector<float> near, away;
    for (const style::LineSet& set : style.line_sets) {
        near.push_back(float(set.pen.spacing));
        away.push_back(float((set.pen_away ? *set.pen_away : set.pen).spacing));
    }
    const auto by_focus = if_any(style.effects.density, style.effects.emphasis),
               by_distance = if_any(style.distance.density);
    const auto wanted = [](In<float> map, Index sample) {
        return map.empty() ? 1.0f : float(power(most_density, 2.0 * map[sample] - 1.0));
    };
    Array<float> half_width(clipped.samples, 0.0f);
    each_sample_with_runs(clipped, runs, [&](Index s, Index path) {
        const Index set = paths.line_set[path];
        const float mix = both(answer(by_focus, density.focus, s), answer(by_distance, density.distance, s));
        const float spacing = near[set] + (away[set] - near[set]) * mix;
        half_width[s] = float(0.5 * scale) * spacing / (wanted(density.painted, s) * wanted(density.mapped, s));
    });
    return half_width;
}

}  // namespace fovea::draw
