// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/runs/join_folds.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <fovea/base/check.h>
#include <fovea/runs/chain.h>

namespace fovea::runs {
namespace {

constexpr double compared_px = 0.5;   // between places that are compared
constexpr double look_px = 3.0;       // length over which directions are measured: segments on dense meshes zigzag
constexpr double turn_back = -0.5;    // cosine of the sharpest turn at a joint, where more than that length is cut off
constexpr double cost_of_cut = 0.05;  // pixels of distance that a pixel of a run is worth

/// What is taken out between two runs.
struct Joint {
    double from, to;
    double apart;  // length of the straight line instead
};

/// A place of a run, in arc length, and how much of the run lies beyond it.
struct OnPiece {
    double arc, cut;
    dvec2 px;
};

/// Joins the runs of one piece.
class Joiner {
   public:
    Joiner(const ClippedPaths& clipped, Index piece, double fold_px, double near_px, double spur_px)
        : clipped_(clipped), piece_(piece), fold_(fold_px), near_(near_px), spur_(spur_px) {}

    void add(const Span& span) {
        if (!spans.empty() && !joins(span) && spans.size() > 1 && spans.back().length() < spur_) {
            const Span passed = spans.back();
            spans.pop_back();
            if (!joins(span)) spans.push_back(passed);
        }
        if (joined_)
            spans.back().end = span.end;
        else
            spans.push_back(span);
    }

    /// What an arc length becomes when the joints are taken out.
    double moved(double arc) const { return arc - taken_before(arc) + taken_before(middle()); }

    std::vector<Span> spans;
    Array<Joint> joints;

   private:
    double middle() const { return std::clamp(0.0, clipped_.first_arc(piece_), clipped_.last_arc(piece_)); }

    double taken_before(double arc) const {
        double taken = 0.0;
        for (const Joint& joint : joints) {
            if (joint.to > arc + same_place_px) break;
            taken += joint.to - joint.from - joint.apart;
        }
        return taken;
    }

    dvec2 px(double arc) const { return dvec2(clipped_.place_px(piece_, arc)); }

    /// Whether the last span goes on as this one; adds the joint.
    bool joins(const Span& span) {
        joined_ = false;
        if (span.begin - spans.back().end > fold_) return false;
        find_tail();
        find_head(span);
        double least = std::numeric_limits<double>::infinity();
        Joint found{};
        for (const OnPiece& a : tail_)
            for (const OnPiece& b : head_) {
                const double apart = glm::distance(a.px, b.px), cost = apart + cost_of_cut * (a.cut + b.cut);
                if (apart > near_ || cost >= least || !is_fold(a, b) || !goes_on(a, b, span)) continue;
                least = cost;
                found = {a.arc, b.arc, apart};
                joined_ = true;
            }
        if (!joined_) return false;
        while (!joints.empty() && joints.back().to > found.from) joints.pop_back();
        joints.push_back(found);
        return true;
    }

    /// Places from the end of the last span backwards, across its joints.
    void find_tail() {
        tail_.clear();
        double cut = 0.0, end = spans.back().end;
        for (std::size_t k = joints.size() + 1; k-- > 0 && cut <= fold_;) {
            const bool first = k == 0 || joints[k - 1].to <= spans.back().begin;
            const double begin = first ? spans.back().begin : joints[k - 1].to;
            double arc = end;
            for (; arc > begin && cut <= fold_; arc -= compared_px, cut += compared_px)
                tail_.push_back({arc, cut, px(arc)});
            if (first) break;
            cut -= begin - arc;
            end = joints[k - 1].from;
        }
    }

    void find_head(const Span& span) {
        head_.clear();
        for (double cut = 0.0; cut <= fold_ && cut < span.length(); cut += compared_px)
            head_.push_back({span.begin + cut, cut, px(span.begin + cut)});
    }

    /// Whether no more is cut off than what is hidden, which is the way back, and nothing that leads away from what is
    /// left, except spurs.
    bool is_fold(const OnPiece& a, const OnPiece& b) const {
        const double cut = a.cut + b.cut, hidden = b.arc - a.arc - cut;
        return cut <= hidden + 2.0 * near_ && (a.cut < spur_ || beside(tail_.front(), head_, b.cut)) &&
               (b.cut < spur_ || beside(head_.front(), tail_, a.cut));
    }

    /// Whether a place lies beside a line, beyond what is cut off that.
    bool beside(const OnPiece& place, const std::vector<OnPiece>& line, double cut) const {
        return std::ranges::any_of(line, [&](const OnPiece& other) {
            return other.cut >= cut && glm::distance(other.px, place.px) <= 2.0 * near_;
        });
    }

    /// Whether something is left of both, and the line does not turn back where it goes from one to the other.
    bool goes_on(const OnPiece& a, const OnPiece& b, const Span& span) const {
        if (a.cut + b.cut <= look_px) return true;
        if (a.arc - spans.back().begin < look_px || span.end - b.arc < look_px) return false;
        const dvec2 into = a.px - px(a.arc - look_px);
        const dvec2 out = px(b.arc + look_px) - b.px;
        return glm::dot(into, out) >= turn_back * glm::length(into) * glm::length(out);
    }

    const ClippedPaths& clipped_;
    Index piece_;
    double fold_, near_, spur_;
    bool joined_ = false;
    std::vector<OnPiece> tail_, head_;
};

/// A point of the new pieces: at a screen fraction of a segment of the given ones, with the samples that its own
/// segment keeps.
struct NewPoint {
    Index segment;
    double share, arc;
    Index first_sample, samples;
};

/// Pieces as they are to be: their points, their runs.
struct Block {
    Array<NewPoint> points;
    Array<Index> sizes;  // points of each piece
    Runs runs;
};

/// Writes the points of one piece without what its joints take out.
class PieceWriter {
   public:
    PieceWriter(const ClippedPaths& clipped, Index piece, const Joiner& joiner, Array<NewPoint>& out)
        : clipped_(clipped), piece_(piece), segment_(clipped.pieces.begin(piece)), joiner_(joiner), out_(out) {}

    void write() {
        for (const Joint& joint : joiner_.joints) take_out(joint);
        while (segment_ + 1 < clipped_.pieces.end(piece_)) finish_segment();
        out_.push_back({segment_, 0.0, joiner_.moved(clipped_.arc_px[segment_]), 0, 0});
    }

   private:
    void take_out(const Joint& joint) {
        const Index until = clipped_.segment_at(piece_, joint.from);
        const double share = clipped_.share_at(until, joint.from);
        while (segment_ < until) finish_segment();
        add(share);
        share_ = share;
        add(share);  // the joint: a segment without samples
        segment_ = clipped_.segment_at(piece_, joint.to);
        share_ = clipped_.share_at(segment_, joint.to);
    }

    void finish_segment() {
        add(1.0);
        ++segment_;
        share_ = 0.0;
    }

    /// Adds the part of the current segment up to a fraction of it, with the samples whose places lie there.
    void add(double until) {
        const Index count = clipped_.sample_count[segment_];
        const auto before = [&](double share) { return Index(std::ceil(std::max(0.0, share * count - 0.5))); };
        const Index first = before(share_), last = std::min(count, before(until));
        const double arc = glm::mix(clipped_.arc_px[segment_], clipped_.arc_px[segment_ + 1], share_);
        out_.push_back({segment_, share_, joiner_.moved(arc), clipped_.sample_start[segment_] + first,
                        last - std::min(first, last)});
    }

    const ClippedPaths& clipped_;
    Index piece_, segment_;
    double share_ = 0.0;
    const Joiner& joiner_;
    Array<NewPoint>& out_;
};

void join_piece(const ClippedPaths& clipped, const Runs& visible, const Rows& rows, Index piece, Joiner& joiner,
                Block& block) {
    for (Index r = rows.begin(piece); r < rows.end(piece); ++r) joiner.add({visible.start_px[r], visible.end_px[r]});
    for (const Span& span : joiner.spans) block.runs.push(piece, joiner.moved(span.begin), joiner.moved(span.end));
    const std::size_t before = block.points.size();
    PieceWriter(clipped, piece, joiner, block.points).write();
    block.sizes.push_back(Index(block.points.size() - before));
}

/// Values of a new point, at a screen fraction of a segment of the given pieces.
void interpolate(const ClippedPaths& clipped, const NewPoint& at, ClippedPaths& out, std::size_t to) {
    const Index i = at.segment;
    out.px[to] = clipped.px[i];
    out.depth[to] = clipped.depth[i];
    out.position_view[to] = clipped.position_view[i];
    out.arc_px[to] = at.arc;
    out.source[to] = clipped.source[i];
    out.source_t[to] = clipped.source_t[i];
    out.facet0[to] = clipped.facet0[i];
    out.facet1[to] = clipped.facet1[i];
    if (!(at.share > 0.0)) return;
    const dvec3 a(clipped.position_view[i]), b(clipped.position_view[i + 1]);
    const double s = at.share, t = clipped.orthographic ? s : s * a.z / (b.z + s * (a.z - b.z));
    out.px[to] = vec2(glm::mix(dvec2(clipped.px[i]), dvec2(clipped.px[i + 1]), s));
    out.depth[to] = glm::mix(clipped.depth[i], clipped.depth[i + 1], float(s));
    out.position_view[to] = vec3(glm::mix(a, b, t));
    const float end_t = clipped.source[i + 1] == clipped.source[i] ? clipped.source_t[i + 1] : 1.0f;
    out.source_t[to] = glm::mix(clipped.source_t[i], end_t, float(t));
}

Unfolded assemble(const ClippedPaths& clipped, std::vector<Block>& blocks) {
    Unfolded all;
    ClippedPaths& out = all.clipped;
    out.path = clipped.path;
    out.closed = clipped.closed;
    out.free_ends = clipped.free_ends;
    out.ends = clipped.ends;
    out.path_length_px = clipped.path_length_px;
    out.orthographic = clipped.orthographic;
    Array<NewPoint> points;
    for (Block& block : blocks) {
        points.insert(points.end(), block.points.begin(), block.points.end());
        for (const Index size : block.sizes) out.pieces.offsets.push_back(out.pieces.offsets.back() + size);
        all.runs.append(block.runs);
    }
    resize_columns(out, ClippedPaths::point_columns, points.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
        out.sample_start[k] = out.samples;
        out.sample_count[k] = points[k].samples;
        out.samples += points[k].samples;
    }
    all.sample.resize(out.samples);
    parallel_for(points.size(), [&](std::size_t k) {
        interpolate(clipped, points[k], out, k);
        for (Index j = 0; j < points[k].samples; ++j) all.sample[out.sample_start[k] + j] = points[k].first_sample + j;
    });
    return all;
}

}  // namespace

Unfolded join_folds(const ClippedPaths& clipped, const Runs& visible, In<std::uint8_t> of_view, double fold_px,
                    double near_px, double spur_px) {
    check_runs(clipped, visible);
    check(clipped.path.empty() || clipped.path.back() < of_view.size(), "of_view: one value per path expected");
    const Rows rows = runs_of_pieces(clipped, visible);
    std::vector<Block> blocks = parallel_parts<Block>(
        clipped.path.size(), pieces_per_block, [&](Block& block, std::size_t begin, std::size_t end) {
            for (Index q = Index(begin); q < end; ++q) {
                Joiner joiner(clipped, q, of_view[clipped.path[q]] ? fold_px : -1.0, near_px, spur_px);
                join_piece(clipped, visible, rows, q, joiner, block);
            }
        });
    return assemble(clipped, blocks);
}

}  // namespace fovea::runs
