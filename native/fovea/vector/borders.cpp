// SPDX-License-Identifier: GPL-3.0-or-later
// Marching squares (Lorensen & Cline, "Marching Cubes", 1987, in the plane) of more than two labels: a border crosses
// sides of a cell, and where it crosses more than two, their lines meet in the middle.
#include <fovea/vector/borders.h>

#include <algorithm>
#include <tuple>

#include <fovea/base/disjoint_sets.h>
#include <fovea/base/parallel.h>

namespace fovea::vector {
namespace {

constexpr int halvings = 10;  // of a side of the lattice
constexpr std::size_t rows_at_once = 8;

/// Numbers of the nodes of cell (x, y), whose lower left corner is that point of the lattice: three of each cell.
enum Node : std::uint64_t { across, up, middle };  // on its lower side, on its left one, and inside

/// A part of a border within a cell.
struct Segment {
    std::uint64_t from, to;
    Label left, right;
};

/// An end of a segment.
struct End {
    std::uint64_t node;
    Index segment;
    bool is_start;
    bool operator<(const End& o) const {
        return std::tie(node, segment, is_start) < std::tie(o.node, o.segment, o.is_start);
    }
};

/// Cells from (-1, -1) on: those around the frame, too.
class Cells {
   public:
    Cells(const Labels& labels, const LabelAt& label_at) : labels_(labels), label_at_(label_at) {}

    int rows() const { return labels_.rows + 1; }

    void append(int row, Array<Segment>& out) const {
        const int y = row - 1;
        for (int x = -1; x < labels_.columns; ++x) {
            const Label corner[] = {labels_.at(x, y), labels_.at(x + 1, y), labels_.at(x + 1, y + 1),
                                    labels_.at(x, y + 1)};
            const std::uint64_t side[] = {node(x, y, across), node(x + 1, y, up), node(x, y + 1, across),
                                          node(x, y, up)};
            int crossed[4], count = 0;
            for (int k = 0; k < 4; ++k)
                if (corner[k] != corner[(k + 1) % 4]) crossed[count++] = k;
            if (count == 2) {
                const int first = crossed[0], second = crossed[1];
                out.push_back({side[first], side[second], corner[first], corner[first + 1]});
            }
            for (int i = 0; count > 2 && i < count; ++i) {
                const int k = crossed[i];
                out.push_back({node(x, y, middle), side[k], corner[(k + 1) % 4], corner[k]});
            }
        }
    }

    dvec2 place(std::uint64_t number) const {
        const auto [x, y, kind] = where(number);
        if (kind == across) return crossing(x, y, x + 1, y);
        if (kind == up) return crossing(x, y, x, y + 1);
        dvec2 sum(0.0);
        int count = 0;
        const auto add = [&](int x0, int y0, int x1, int y1) {
            if (labels_.at(x0, y0) == labels_.at(x1, y1)) return;
            sum += crossing(x0, y0, x1, y1);
            ++count;
        };
        add(x, y, x + 1, y);
        add(x + 1, y, x + 1, y + 1);
        add(x, y + 1, x + 1, y + 1);
        add(x, y, x, y + 1);
        return sum / double(count);
    }

    static bool is_junction(std::uint64_t number) { return number % 3 == middle; }

   private:
    struct Where {
        int x, y;
        Node kind;
    };
    std::uint64_t node(int x, int y, Node kind) const {
        return 3 * (std::uint64_t(y + 1) * std::uint64_t(labels_.columns + 2) + std::uint64_t(x + 1)) + kind;
    }
    Where where(std::uint64_t number) const {
        const std::uint64_t cell = number / 3, width = std::uint64_t(labels_.columns + 2);
        return {int(cell % width) - 1, int(cell / width) - 1, Node(number % 3)};
    }

    /// Where the label of a point of the lattice ends on the way to another.
    dvec2 crossing(int x0, int y0, int x1, int y1) const {
        const Label label = labels_.at(x0, y0);
        dvec2 here = labels_.place(x0, y0), there = labels_.place(x1, y1);
        if (here == there) return here;  // at the frame
        for (int i = 0; i < halvings; ++i) {
            const dvec2 between = 0.5 * (here + there);
            (label_at_(between) == label ? here : there) = between;
        }
        return 0.5 * (here + there);
    }

    const Labels& labels_;
    const LabelAt& label_at_;
};

/// Follows segments from node to node.
class Chains {
   public:
    Chains(const Cells& cells, const Array<Segment>& segments)
        : segments_(segments), used_(segments.size()), ends_(2 * segments.size()) {
        for (Index s = 0; s < segments.size(); ++s) {
            ends_[2 * s] = {segments[s].from, s, true};
            ends_[2 * s + 1] = {segments[s].to, s, false};
        }
        parallel_sort(ends_.begin(), ends_.end());
        for (const End& end : ends_)
            if (nodes_.empty() || nodes_.back() != end.node) nodes_.push_back(end.node);
        places_ = parallel_map<dvec2>(nodes_.size(), [&](std::size_t i) { return cells.place(nodes_[i]); });
    }

    std::vector<Border> follow() {
        for (const End& end : ends_)
            if (Cells::is_junction(end.node) && !used_[end.segment]) add(end);
        for (const End& end : ends_)
            if (!used_[end.segment]) add(end);
        return std::move(borders_);
    }

   private:
    /// The border that begins at an end of a segment.
    void add(End end) {
        const Segment& first = segments_[end.segment];
        Border border{{}, first.left, first.right, number_of(end.node), none};
        if (!end.is_start) std::swap(border.left, border.right);
        border.points.push_back(places_[border.from]);
        for (std::uint64_t at = end.node;;) {
            used_[end.segment] = true;
            const Segment& segment = segments_[end.segment];
            at = end.is_start ? segment.to : segment.from;
            border.to = number_of(at);
            // Where the frame's corner is, two are at one place.
            if (places_[border.to] != border.points.back()) border.points.push_back(places_[border.to]);
            if (Cells::is_junction(at) || border.to == border.from) break;
            const auto next = std::ranges::lower_bound(ends_, at, {}, &End::node);
            end = next->segment == end.segment ? *(next + 1) : *next;
        }
        if (!Cells::is_junction(nodes_[border.from])) border.from = border.to = none;
        borders_.push_back(std::move(border));
    }

    Index number_of(std::uint64_t node) const { return Index(std::ranges::lower_bound(nodes_, node) - nodes_.begin()); }

    const Array<Segment>& segments_;
    std::vector<bool> used_;
    std::vector<End> ends_;
    std::vector<std::uint64_t> nodes_;
    Array<dvec2> places_;
    std::vector<Border> borders_;
};

}  // namespace

Labels labels_of(int width, int height, int per_px, const LabelAt& label_at) {
    Labels labels{per_px * width + 1, per_px * height + 1, per_px, {}};
    labels.values.resize(std::size_t(labels.columns) * labels.rows);
    parallel_for(labels.rows, 1, [&](std::size_t y) {
        for (int x = 0; x < labels.columns; ++x)
            labels.values[y * labels.columns + x] = label_at(labels.place(x, int(y)));
    });
    return labels;
}

Labels without_specks(Labels labels, Index least) {
    Array<Label>& values = labels.values;
    const auto columns = Index(labels.columns), count = Index(values.size());
    DisjointSets areas(count);
    for (Index i = 0; i < count; ++i) {
        if (i % columns > 0 && values[i - 1] == values[i]) areas.join(i - 1, i);
        if (i >= columns && values[i - columns] == values[i]) areas.join(i - columns, i);
    }
    Array<Index> points(count, 0);
    for (Index i = 0; i < count; ++i) ++points[areas.name(i)];
    // The first area has nothing to its left or below it, and another to its right.
    if (points[0] < least && points[0] < count)
        values[0] = *std::ranges::find_if(values, [&](Label label) { return label != values[0]; });
    // The first point of any other comes after those to its left and below, which have their labels by then.
    for (Index i = 0; i < count; ++i) {
        const Index first = areas.name(i);
        if (first != i)
            values[i] = values[first];
        else if (points[i] < least && i % columns > 0)
            values[i] = values[i - 1];
        else if (points[i] < least && i >= columns)
            values[i] = values[i - columns];
    }
    return labels;
}

std::vector<Border> borders_of(const Labels& labels, const LabelAt& label_at) {
    const Cells cells(labels, label_at);
    const auto segments = parallel_collect<Segment>(std::size_t(cells.rows()), rows_at_once,
                                                    [&](std::size_t begin, std::size_t end, Array<Segment>& out) {
                                                        for (std::size_t row = begin; row < end; ++row)
                                                            cells.append(int(row), out);
                                                    });
    return Chains(cells, segments).follow();
}

}  // namespace fovea::vector
