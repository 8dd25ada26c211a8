// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/draw/by_light.h>

#include <algorithm>
#include <map>
#include <memory>

#include <fovea/base/check.h>
#include <fovea/base/hash.h>
#include <fovea/style/style.h>

namespace fovea::draw {
namespace {

constexpr Owners nobody{none, none, none};

bool has(style::LightFilter light, Shade shade) {
    switch (light) {
        case style::LightFilter::lit:
            return shade == Shade::lit;
        case style::LightFilter::shaded:
            return shade != Shade::lit;
        case style::LightFilter::attached:
            return shade == Shade::attached;
        case style::LightFilter::cast:
            return shade == Shade::cast;
        case style::LightFilter::any:
            break;
    }
    return true;
}

/// Adds a set where there is no owner yet. Whether it is one then.
bool add(Owners& owners, style::LightFilter light, Index set) {
    bool any = false;
    for (std::size_t shade = 0; shade < owners.size(); ++shade)
        if (owners[shade] == none && has(light, Shade(shade))) {
            owners[shade] = set;
            any = true;
        }
    return any;
}

bool same(const path::MaterialFilter& a, const path::MaterialFilter& b) { return a.row == b.row && a.masks == b.masks; }

/// Materials that pass both filters.
path::MaterialFilter both(const path::MaterialFilter& a, const path::MaterialFilter& b) {
    if (a.row.empty() || same(a, b)) return b;
    if (b.row.empty()) return a;
    path::MaterialFilter common;
    std::map<std::pair<Index, Index>, Index> number;
    for (std::size_t i = 0; i < a.row.size(); ++i) {
        const auto [at, is_new] = number.try_emplace({a.row[i], b.row[i]}, Index(common.masks.size()));
        common.row.push_back(at->second);
        if (!is_new) continue;
        const auto &first = a.masks[a.row[i]], &second = b.masks[b.row[i]];
        auto& mask = common.masks.emplace_back(std::max(first.size(), second.size()), std::uint8_t(1));
        for (const auto* of : {&first, &second})
            for (std::size_t m = 0; m < of->size(); ++m) mask[m] = mask[m] && (*of)[m];
    }
    return common;
}

/// Narrows the filters of `set` to what `other` has, too. False if nothing is left, or their surfaces differ.
bool narrow(LineSet& set, const LineSet& other) {
    if (set.surfaces != other.surfaces) {
        if (set.surfaces != Surfaces::all && other.surfaces != Surfaces::all) return false;
        set.surfaces = set.surfaces == Surfaces::all ? other.surfaces : set.surfaces;
    }
    if (set.placements.empty()) {
        set.placements = other.placements;
    } else if (!other.placements.empty()) {
        for (std::size_t i = 0; i < set.placements.size(); ++i) set.placements[i] &= other.placements[i];
        if (std::ranges::count(set.placements, 1) == 0) return false;
    }
    set.materials = both(set.materials, other.materials);
    return true;
}

bool same_filters(const LineSet& a, const LineSet& b) {
    return a.surfaces == b.surfaces && a.placements == b.placements && same(a.materials, b.materials);
}

/// Whether a set has lines wherever another has.
bool covers(const LineSet& set, const LineSet& other) {
    LineSet narrowed = other;
    return narrow(narrowed, set) && same_filters(narrowed, other);
}

bool asks(const LineSet& set, const path::LineKind& kind) {
    return std::ranges::any_of(set.kinds, [&](const path::LineKind& its) {
        return its.definition == kind.definition && its.values == kind.values;
    });
}

/// Finds what sets have in common.
class Sharing {
   public:
    Sharing(const std::vector<LineSet>& sets, const style::Style& style) : sets_(sets), style_(style) {}

    SharedSets shared() {
        for (Index s = 0; s < sets_.size(); ++s) {
            const std::size_t first = found_.sets.size();
            for (const path::LineKind& kind : sets_[s].kinds) {
                LineSet filters = sets_[s];
                filters.kinds.clear();
                Owners owners = nobody;
                add(owners, style_.line_sets[s].light, s);
                share(filters, owners, kind, s + 1, first);
            }
        }
        return std::move(found_);
    }

   private:
    /// Adds a definition to the sets of these filters and owners, and to those where later sets own parts of it, before
    /// them. `first`: sets from there on are of the same set of the style.
    void share(const LineSet& filters, const Owners& owners, const path::LineKind& kind, Index next,
               std::size_t first) {
        for (Index s = next; s < sets_.size(); ++s) {
            Owners with = owners;
            LineSet common = filters;
            if (!asks(sets_[s], kind) || !add(with, style_.line_sets[s].light, s) || !narrow(common, sets_[s]))
                continue;
            share(common, with, kind, s + 1, first);
            if (same_filters(common, filters)) return;
        }
        const auto takes = [&](const LineSet& set) { return asks(set, kind) && covers(set, filters); };
        if (std::ranges::any_of(found_.sets, takes)) return;
        for (std::size_t i = first; i < found_.sets.size(); ++i)
            if (found_.owners[i] == owners && same_filters(found_.sets[i], filters)) {
                found_.sets[i].kinds.push_back(kind);
                return;
            }
        found_.sets.push_back(filters);
        found_.sets.back().kinds = {kind};
        found_.owners.push_back(owners);
    }

    const std::vector<LineSet>& sets_;
    const style::Style& style_;
    SharedSets found_;
};

/// Appends copies of some rows to the columns of a structure.
template <typename Structure, typename Columns>
void copy_rows(Structure& of, const Columns& columns, In<Index> rows) {
    for_each_column(columns, [&](const auto& column) {
        auto& values = of.*column.array;
        values.reserve(values.size() + rows.size());
        for (const Index row : rows) values.push_back(values[row]);
    });
}

/// Appends copies of paths to a list of paths.
void append_copies(Paths& paths, In<Index> copied) {
    Array<Index> points;
    for (const Index p : copied) {
        for (Index i = paths.rows.begin(p); i < paths.rows.end(p); ++i) points.push_back(i);
        paths.rows.offsets.push_back(paths.rows.offsets.back() + paths.rows.size(p));
    }
    if (paths.other_facet.empty()) paths.other_facet.assign(paths.place.size(), none);
    copy_rows(paths, Paths::path_columns, copied);
    copy_rows(paths, Paths::point_columns, points);
}

/// Appends copies of pieces, and of their samples.
void append_copies(ClippedPaths& clipped, Array<float>& samples, In<Index> copied) {
    Array<Index> points;
    for (const Index q : copied) {
        for (Index i = clipped.pieces.begin(q); i < clipped.pieces.end(q); ++i) points.push_back(i);
        clipped.pieces.offsets.push_back(clipped.pieces.offsets.back() + clipped.pieces.size(q));
    }
    std::size_t to = clipped.px.size();
    copy_rows(clipped, ClippedPaths::piece_columns, copied);
    copy_rows(clipped, ClippedPaths::point_columns, points);
    const Index pieces = clipped.pieces.count() - Index(copied.size()), all = clipped.samples;
    for (const Index q : copied) {
        const Index begin = clipped.first_sample(q), end = q + 1 < pieces ? clipped.first_sample(q + 1) : all;
        for (Index i = 0; i < clipped.pieces.size(q); ++i, ++to)
            clipped.sample_start[to] = clipped.sample_start[to] - begin + clipped.samples;
        for (Index s = begin; s < end && !samples.empty(); ++s) samples.push_back(samples[s]);
        check(end - begin <= none - clipped.samples,
              "options.sample_step: the drawing has more than four billion samples");
        clipped.samples += end - begin;
    }
}

}  // namespace

SharedSets shared_by_light(const std::vector<LineSet>& sets, const style::Style& style) {
    const auto asks_light = [](const style::LineSet& set) { return set.light != style::LightFilter::any; };
    if (std::ranges::none_of(style.line_sets, asks_light)) return {sets, {}};
    return Sharing(sets, style).shared();
}

LitLines shared_out(LitLines lines, In<std::uint8_t> of_path, const std::vector<Owners>& owners, const Scene& scene,
                    const View& view, double gap_px, const Cancel& cancel) {
    const auto is_shared = [&](std::size_t p) {
        const Owners& o = owners[of_path[p]];
        return std::uint8_t(o[0] != o[1] || o[1] != o[2]);
    };
    const Array<std::uint8_t> shared = parallel_map<std::uint8_t>(of_path.size(), is_shared);
    const ShadedRuns parts = by_shade(*lines.clipped, *lines.paths, scene, view, lines.runs, shared, gap_px, cancel);
    const auto owner_of = [&](std::size_t part) {
        return owners[of_path[lines.clipped->path[parts.runs.piece[part]]]][std::size_t(parts.shade[part])];
    };

    std::map<std::pair<Index, Index>, Index> copy_of;  // (path, owner) -> path
    for (std::size_t i = 0; i < parts.runs.size(); ++i) {
        const Index path = lines.clipped->path[parts.runs.piece[i]], owner = owner_of(i);
        if (owner != none && owner != lines.paths->line_set[path]) copy_of[{path, owner}] = none;
    }
    Array<Index> copied, pieces, path_of_piece;
    Index count = lines.paths->count();
    for (auto& [of, copy] : copy_of) {
        copied.push_back(of.first);
        copy = count++;
        const auto its = std::ranges::equal_range(lines.clipped->path, of.first);
        for (auto q = its.begin(); q != its.end(); ++q) pieces.push_back(Index(q - lines.clipped->path.begin()));
        path_of_piece.resize(pieces.size(), copy);
    }
    const Rows rows = runs_of_pieces(*lines.clipped, lines.runs),
               part_rows = runs_of_pieces(*lines.clipped, parts.runs);
    LitLines out{.samples = std::move(lines.samples)};
    const auto take = [&](Index from, Index to, Index owner) {
        bool open = false;  // the run before is of the same owner
        for (Index i = part_rows.begin(from); i < part_rows.end(from); ++i) {
            const bool is_its = owner_of(i) == owner;
            const bool goes_on = is_its && open && out.runs.end_px.back() == parts.runs.start_px[i] &&
                                 out.runs.invisibility.back() == parts.runs.invisibility[i];
            if (goes_on)
                out.runs.end_px.back() = parts.runs.end_px[i];
            else if (is_its)
                out.runs.push(to, parts.runs.start_px[i], parts.runs.end_px[i], parts.runs.invisibility[i]);
            open = is_its;
        }
    };
    for (Index q = 0; q < lines.clipped->pieces.count(); ++q) {
        const Index path = lines.clipped->path[q];
        if (shared[path]) take(q, q, lines.paths->line_set[path]);
        for (Index r = rows.begin(q); r < rows.end(q) && !shared[path]; ++r) out.runs.push(lines.runs, r);
    }
    auto paths = std::make_shared<Paths>(*lines.paths);
    auto clipped = std::make_shared<ClippedPaths>(*lines.clipped);
    append_copies(*paths, copied);
    append_copies(*clipped, out.samples, pieces);
    for (const auto& [of, copy] : copy_of) {
        paths->line_set[copy] = std::uint8_t(of.second);
        paths->id[copy] = hash_numbers(paths->id[copy], of.second);
    }
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        const Index piece = lines.clipped->pieces.count() + Index(k);
        clipped->path[piece] = path_of_piece[k];
        const Index copy_begins = paths->rows.begin(path_of_piece[k]),
                    begins = paths->rows.begin(lines.clipped->path[pieces[k]]);
        for (Index i = clipped->pieces.begin(piece); i < clipped->pieces.end(piece); ++i)
            clipped->source[i] += copy_begins - begins;
        take(pieces[k], piece, paths->line_set[path_of_piece[k]]);
    }
    out.paths = std::move(paths);
    out.clipped = std::move(clipped);
    return out;
}

}  // namespace fovea::draw
