// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/runs/chain.h>

#include <algorithm>
#include <limits>

#include <fovea/visibility/piece_samples.h>

namespace fovea::runs {
namespace {

/// The piece on the other side of the seam, `none` if there is none. Pieces of a path are contiguous, so it is the last
/// or the first of them.
Index beyond_seam(const ClippedPaths& clipped, Index piece) {
    const Index path = clipped.path[piece], count = static_cast<Index>(clipped.path.size());
    Index other = piece;
    if (clipped.ends[piece] & seam_start) {
        while (other + 1 < count && clipped.path[other + 1] == path) ++other;
        return other != piece && (clipped.ends[other] & seam_end) ? other : none;
    }
    while (other > 0 && clipped.path[other - 1] == path) --other;
    return other != piece && (clipped.ends[other] & seam_start) ? other : none;
}

bool touch(const Span& before, const Span& span) { return span.begin <= before.end + same_place_px; }

}  // namespace

Chain::Chain(const ClippedPaths& clipped, Index piece) {
    const int ends = clipped.ends[piece];
    cyclic = clipped.closed[piece];
    const bool at_seam = !cyclic && (ends & (seam_start | seam_end));
    const Index other = at_seam ? beyond_seam(clipped, piece) : none;
    // The piece that ends at the seam comes first.
    Index first = piece, second = other;
    if (other != none && (ends & seam_start)) std::swap(first, second);
    begin = clipped.first_arc(first);
    end = clipped.last_arc(first);
    parts_[0] = {first, 0.0};
    if (second != none) {
        seam_ = end;
        const double shift = seam_ - clipped.first_arc(second);
        parts_[1] = {second, shift};
        count_ = 2;
        end = clipped.last_arc(second) + shift;
    }
    ends_at_begin = clipped.ends[parts_[0].piece] & path_start;
    ends_at_end = clipped.ends[parts_[count_ - 1].piece] & path_end;
}

float Chain::value(const ClippedPaths& clipped, In<float> values, double at, float otherwise) const {
    if (cyclic && at > end) at -= length();
    const Part& part = parts_[count_ > 1 && at > seam_ ? 1 : 0];
    return PieceSamples(clipped, part.piece).value(values, at - part.shift, otherwise);
}

void Chain::visible(const Runs& runs, const Rows& rows, std::vector<Span>& out) const {
    out.clear();
    for (const auto& [piece, shift] : parts())
        for (Index r = rows.begin(piece); r < rows.end(piece); ++r)
            if (runs.invisibility[r] == 0) out.push_back({runs.start_px[r] + shift, runs.end_px[r] + shift});
    join_spans(out, touch);
    const bool across =
        cyclic && out.size() > 1 && out.front().begin <= begin + same_place_px && out.back().end >= end - same_place_px;
    if (!across) return;
    out.back().end = end + (out.front().end - begin);
    out.erase(out.begin());
}

void Chain::on_piece(Index piece, In<Span> spans, std::vector<Span>& out) const {
    constexpr double endless = std::numeric_limits<double>::infinity();
    const bool first = piece == parts_[0].piece, last = piece == parts_[count_ - 1].piece;
    const double shift = first ? 0.0 : parts_[1].shift;
    const double low = !first ? seam_ : ends_at_begin ? -endless : begin;
    const double high = !last ? seam_ : ends_at_end ? endless : end;
    out.clear();
    const auto add = [&](const Span& span, double by) {
        const Span held{std::max(span.begin + by, low), std::min(span.end + by, high)};
        if (held.begin < held.end) out.push_back({held.begin - shift, held.end - shift});
    };
    for (const Span& span : spans) {
        if (is_whole(span)) {
            add({begin, end}, 0.0);
            continue;
        }
        add(span, 0.0);
        if (!cyclic) continue;
        add(span, -length());
        add(span, length());
    }
    std::ranges::sort(out, {}, [](const Span& s) { return std::pair(s.begin, s.end); });
    join_spans(out, touch);
}

void replace_visible(const Runs& runs, const Rows& rows, Index piece, In<Span> visible, Runs& out) {
    std::size_t next = 0;  // first visible span not written yet
    const auto write_before = [&](double arc) {
        for (; next < visible.size() && visible[next].begin < arc; ++next)
            out.push(piece, visible[next].begin, visible[next].end);
    };
    for (Index r = rows.begin(piece); r < rows.end(piece); ++r) {
        if (runs.invisibility[r] == 0) continue;
        double from = runs.start_px[r];
        const double to = runs.end_px[r];
        write_before(from);
        if (next > 0) from = std::max(from, visible[next - 1].end);
        while (next < visible.size() && visible[next].begin < to) {
            out.push(piece, from, visible[next].begin, runs.invisibility[r]);
            from = std::max(from, visible[next].end);
            out.push(piece, visible[next].begin, visible[next].end);
            ++next;
        }
        out.push(piece, from, to, runs.invisibility[r]);
    }
    write_before(std::numeric_limits<double>::infinity());
}

}  // namespace fovea::runs
