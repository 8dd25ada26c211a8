// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/draw/pens.h>

#include <algorithm>
#include <map>

#include <fovea/base/check.h>
#include <fovea/stroke/ink.h>

namespace fovea::draw {
namespace {

constexpr Index uncounted = 255;  // upper end of open ranges: the greatest invisibility

std::vector<PenRange> ranges_of(const style::Style& style) {
    std::vector<PenRange> ranges;
    for (Index set = 0; set < style.line_sets.size(); ++set) ranges.push_back({set, 0, 0, set});
    for (Index set = 0; set < style.line_sets.size(); ++set)
        for (const style::Hidden& hidden : style.line_sets[set].hidden)
            ranges.push_back({set, Index(hidden.first), hidden.last ? Index(*hidden.last) : uncounted,
                              static_cast<Index>(ranges.size())});
    return ranges;
}

}  // namespace

std::vector<style::Pen> pens_in_order(const style::Style& style) {
    const std::vector<style::PenPair> pairs = style.pen_pairs();
    std::vector<style::Pen> all;
    for (const auto& pair : pairs) all.push_back(*pair.pen);
    for (const auto& pair : pairs)
        if (pair.away) all.push_back(*pair.away);
    return all;
}

Pens pens_of(const style::Style& style, const Assets& assets, double scale) {
    const std::vector<style::PenPair> pairs = style.pen_pairs();
    const std::vector<style::Pen> all = pens_in_order(style);
    Pens found;
    found.ranges = ranges_of(style);
    std::map<std::string, Index> numbers;  // textures by name, in sorted order
    for (const style::Pen& pen : all)
        if (assets.texture(pen.texture)) numbers[pen.texture];
    for (auto& [name, number] : numbers) {
        number = static_cast<Index>(found.textures.size());
        found.textures.push_back(assets.texture(name)->ink);
    }
    for (const style::Pen& pen : all) {
        const double width = style.width_px(pen, scale);
        Pen made;
        made.look = style::in_pixels(pen, scale, style.paper.px_per_mm(scale));
        made.width_px = float(width);
        made.texture_length_px = float(pen.length_scale * assets.texture_length(pen.texture) * width);
        if (const auto texture = numbers.find(pen.texture); texture != numbers.end()) {
            made.texture = texture->second;
            if (style.animation.vanish == style::Vanish::break_up)
                made.ink_levels = stroke::ink_levels(
                    stroke::fit_texture(found.textures[made.texture], made.texture_length_px, made.width_px));
        }
        found.pens.push_back(made);
    }
    Index away = static_cast<Index>(pairs.size());
    for (std::size_t i = 0; i < pairs.size(); ++i)
        if (pairs[i].away) found.pens[i].away = away++;
    return found;
}

Array<Index> pens_of_runs(const ClippedPaths& clipped, const Runs& runs, In<std::uint8_t> line_set,
                          In<PenRange> ranges) {
    check_runs(clipped, runs);
    check(clipped.path.empty() || clipped.path.back() < line_set.size(), "line_set: one value per path expected");
    Array<Index> pens(runs.size(), none);
    parallel_for(runs.size(), [&](std::size_t r) {
        const Index set = line_set[clipped.path[runs.piece[r]]], hidden_by = runs.invisibility[r];
        const auto holds = [&](const PenRange& range) {
            return range.line_set == set && range.from <= hidden_by && hidden_by <= range.to;
        };
        const auto found = std::ranges::find_if(ranges, holds);
        if (found != ranges.end()) pens[r] = found->pen;
    });
    return pens;
}

}  // namespace fovea::draw
