// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/path/placed_set.h>

#include <cmath>

#include <fovea/base/check.h>
#include <fovea/field/shape.h>

namespace fovea::path {
namespace {

void check_materials(const MaterialFilter& filter, std::size_t placements) {
    if (filter.row.empty()) return;
    check(filter.row.size() == placements, "materials: a mask for each placement expected");
    for (Index row : filter.row) check(row < filter.masks.size(), "materials: each row must be that of a mask");
}

/// Materials that pass both filters for a placement, as a mask; empty if all do.
std::vector<std::uint8_t> both(const MaterialFilter& a, const MaterialFilter& b, Index placement) {
    std::vector<std::uint8_t> mask;
    for (const MaterialFilter* filter : {&a, &b}) {
        if (filter->row.empty()) continue;
        const std::vector<std::uint8_t>& other = filter->masks[filter->row[placement]];
        mask.resize(std::max(mask.size(), other.size()), 1);
        for (std::size_t i = 0; i < other.size(); ++i) mask[i] = mask[i] && other[i];
    }
    const bool all = std::all_of(mask.begin(), mask.end(), [](std::uint8_t has) { return has; });
    return all ? std::vector<std::uint8_t>() : mask;
}

bool any_asks(const std::vector<LineSet>& sets, const LineDefinition& definition) {
    const auto is_it = [&](const LineKind& kind) { return line_definitions()[kind.definition] == &definition; };
    return std::ranges::any_of(sets, [&](const LineSet& set) { return std::ranges::any_of(set.kinds, is_it); });
}

}  // namespace

void check_filters(std::size_t placements, const std::vector<LineSet>& sets, const OwnLines& own) {
    for (const LineSet& set : sets) {
        check(set.placements.empty() || set.placements.size() == placements,
              "placements: whether a line set is for it expected of each placement");
        check_materials(set.materials, placements);
    }
    check(own.kinds.empty() || own.kinds.size() == placements, "shown: what each placement shows expected");
    for (const OwnLines::Parameter& parameter : own.parameters)
        check(parameter.values.size() == placements, "parameters: a value for each placement expected");
    check_materials(own.materials, placements);
}

bool varies_by_placement(const std::vector<LineSet>& sets, const OwnLines& own) {
    const auto varies = [](const LineSet& set) { return !set.placements.empty() || !set.materials.row.empty(); };
    return !own.kinds.empty() || !own.parameters.empty() || !own.materials.row.empty() ||
           std::ranges::any_of(sets, varies);
}

std::vector<PlacedSet> sets_of(Index placement, const Surface& surface, const std::vector<LineSet>& sets,
                               const OwnLines& own) {
    std::vector<PlacedSet> placed;
    for (const LineSet& set : sets) {
        PlacedSet& mine = placed.emplace_back(PlacedSet{{}, set.corner_angle_rad});
        if (!set.placements.empty() && !set.placements[placement]) continue;
        mine.materials = both(set.materials, own.materials, placement);
        const auto suits = [&](Index number) {
            const LineDefinition& definition = *line_definitions()[number];
            if (set.surfaces == Surfaces::all) return true;
            const Shape shape = shape_of(surface);
            const bool replaced = set.surfaces == Surfaces::suited && shape == Shape::smooth &&
                                  definition.smooth_twin && any_asks(sets, *definition.smooth_twin);
            return !replaced && is_drawn_on(set.surfaces, definition, shape);
        };
        for (const LineKind& kind : set.kinds)
            if (own.shows(placement, kind.definition) && suits(kind.definition)) mine.kinds.push_back(kind);
        for (const OwnLines::Parameter& parameter : own.parameters)
            for (LineKind& kind : mine.kinds)
                if (kind.definition == parameter.definition && !std::isnan(parameter.values[placement]))
                    kind.values[parameter.parameter] = parameter.values[placement];
    }
    return placed;
}

Kinds asked_of(const PlacedSet& set) {
    Kinds asked = 0;
    for (const LineKind& kind : set.kinds) asked |= Kinds(1) << kind.definition;
    return asked;
}

Kinds asked_of(const std::vector<PlacedSet>& sets) {
    Kinds asked = 0;
    for (const PlacedSet& set : sets) asked |= asked_of(set);
    return asked;
}

bool any_by_material(const std::vector<PlacedSet>& sets) {
    return std::any_of(sets.begin(), sets.end(), [](const PlacedSet& set) { return !set.materials.empty(); });
}

}  // namespace fovea::path
