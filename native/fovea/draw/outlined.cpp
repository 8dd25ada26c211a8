// SPDX-License-Identifier: GPL-3.0-or-later
// Drafts: silhouettes are distinguished from other contours by rays behind them.

#include <algorithm>

#include <fovea/draw/frame.h>
#include <fovea/runs/outer_parts.h>

namespace fovea::draw {
namespace {

constexpr double outline_step = 10.0;  // reference pixels between rays behind an outline

const std::vector<std::string>* stand_ins_of(const Outlines& outlines, Index set) {
    const auto found = std::ranges::find(outlines, int(set), [](const auto& entry) { return entry.first; });
    return found == outlines.end() ? nullptr : &found->second;
}

/// Per line set: bits of the definitions that it draws unconditionally, outer boundary or not.
std::vector<Kinds> wanted_by(const style::Style& style, const Outlines& outlines) {
    std::vector<Kinds> wanted;
    for (Index i = 0; i < style.line_sets.size(); ++i) {
        const auto* stand_ins = stand_ins_of(outlines, i);
        Kinds bits = 0;
        for (const auto& [name, parameters] : style.line_sets[i].kinds)
            if (!stand_ins || std::ranges::find(*stand_ins, name) == stand_ins->end())
                bits |= Kinds(1) << definition_index(name);
        wanted.push_back(bits);
    }
    return wanted;
}

}  // namespace

/// Visible runs, split where they change between outer boundary of their object and interior (Options::outlines), and
/// the pen of each; `none`: not drawn. The first pens are those of the line sets.
std::pair<Runs, Array<Index>> Frame::outlined(const Runs& drawn_runs) const {
    const std::vector<Kinds> wanted = wanted_by(job.style, job.options.outlines);
    Array<Kinds> sure(paths->count(), ~Kinds(0));
    for (Index p = 0; p < paths->count(); ++p)
        if (stand_ins_of(job.options.outlines, paths->line_set[p]) && paths->placement[p] != none)
            sure[p] = wanted[paths->line_set[p]];
    OuterParts parts = outer_parts(*clipped, *paths, *tracer, drawn_runs, sure, outline_step * scale(), cancel());
    const auto& filters = job.overrides.line_sets;
    Array<Index> pen(parts.runs.size());
    for (std::size_t r = 0; r < pen.size(); ++r) {
        const Index path = clipped->path[parts.runs.piece[r]];
        pen[r] = paths->line_set[path];
        if (parts.outer[r]) continue;
        const auto has = [&](Index set) {
            const bool shows = filters.empty() || filters[set].placements.empty() ||
                               filters[set].placements[paths->placement[path]] != 0;
            return (paths->kinds[parts.source[r]] & wanted[set]) != 0 && shows;
        };
        pen[r] = none;
        for (Index set = 0; set < wanted.size() && pen[r] == none; ++set)
            if (has(set)) pen[r] = set;
    }
    return {std::move(parts.runs), std::move(pen)};
}

}  // namespace fovea::draw
