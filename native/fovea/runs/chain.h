// SPDX-License-Identifier: GPL-3.0-or-later
// Chains: connected pieces of a line, which filters process as one.
#pragma once

#include <fovea/visibility/runs.h>

namespace fovea::runs {

/// Part of a chain, in pixels of the chain's arc length.
struct Span {
    double begin, end;
    double length() const { return end - begin; }
};

/// Joins each span with the one before it where touch(before, span).
template <typename Touch>
void join_spans(std::vector<Span>& spans, const Touch& touch) {
    std::size_t kept = 0;
    for (const Span& span : spans)
        if (kept > 0 && touch(spans[kept - 1], span))
            spans[kept - 1].end = std::max(spans[kept - 1].end, span.end);
        else
            spans[kept++] = span;
    spans.resize(kept);
}

/// One piece; or, where the frame cuts a closed path, the two pieces that meet at its seam. A closed piece is cyclic.
/// Arc length is that of the first piece, continued along the second.
class Chain {
   public:
    Chain(const ClippedPaths& clipped, Index piece);

    double begin = 0.0, end = 0.0;
    /// Whether the end connects to the begin.
    bool cyclic = false;
    /// Whether the line itself ends there, rather than being cut by the frame.
    bool ends_at_begin = false, ends_at_end = false;

    double length() const { return end - begin; }
    bool reaches_begin(const Span& span) const { return !cyclic && span.begin <= begin + same_place_px; }
    bool reaches_end(const Span& span) const { return !cyclic && span.end >= end - same_place_px; }
    bool is_whole(const Span& span) const { return cyclic && span.length() >= length() - same_place_px; }

    struct Part {
        Index piece;
        double shift;  ///< arc length of the chain minus that of the piece
    };
    In<Part> parts() const { return {parts_, std::size_t(count_)}; }

    /// Interpolates per-atlas-sample `values` at an arc length of the chain (PieceSamples::value).
    float value(const ClippedPaths& clipped, In<float> values, double at, float otherwise) const;

    /// Visible spans of the chain, ascending and disjoint. In a cyclic chain, a span across the seam ends beyond `end`.
    void visible(const Runs& runs, const Rows& rows, std::vector<Span>& out) const;

    /// The spans restricted to one piece, in its own arc length, ascending and disjoint. Input spans may overlap, and
    /// may extend beyond a cyclic chain and beyond ends of the line; where the frame cuts the line they are clipped.
    void on_piece(Index piece, In<Span> spans, std::vector<Span>& out) const;

   private:
    Part parts_[2];
    int count_ = 1;
    double seam_ = 0.0;  // where two parts meet
};

/// Appends the runs of a piece whose visible spans are now `visible` (ascending, disjoint); its hidden runs stay except
/// where they are now visible.
void replace_visible(const Runs& runs, const Rows& rows, Index piece, In<Span> visible, Runs& out);

/// Applies change(path, chain, spans) to the visible spans of each chain whose path satisfies `wanted`; runs of other
/// paths are copied. Visible runs replace hidden ones, which stay otherwise. A chain of two pieces is changed once for
/// each. Parallel; the result does not depend on the number of threads.
template <typename Wanted, typename Change>
Runs change_visible(const ClippedPaths& clipped, const Runs& runs, const Wanted& wanted, const Change& change) {
    const Rows rows = runs_of_pieces(clipped, runs);
    return runs_by_blocks(clipped.path.size(), 256, [&](Runs& out, std::size_t first, std::size_t last) {
        std::vector<Span> spans, kept;
        for (Index q = Index(first); q < last; ++q) {
            if (!wanted(clipped.path[q])) {
                for (Index r = rows.begin(q); r < rows.end(q); ++r) out.push(runs, r);
                continue;
            }
            const Chain chain(clipped, q);
            chain.visible(runs, rows, spans);
            change(clipped.path[q], chain, spans);
            chain.on_piece(q, spans, kept);
            replace_visible(runs, rows, q, kept, out);
        }
    });
}

}  // namespace fovea::runs
