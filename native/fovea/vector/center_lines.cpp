// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/vector/center_lines.h>

#include <algorithm>

#include <fovea/base/check.h>
#include <fovea/stroke/drawn_line.h>
#include <fovea/vector/grain.h>

namespace fovea::vector {
namespace {

constexpr float unseen = 1.0f / 255.0f;  // opacity

/// Appends the lines of runs.
class LineWriter {
   public:
    LineWriter(const Frame& frame, const Inking& inking, In<Grain> grains, CenterLines& out)
        : frame_(frame), inking_(inking), grains_(grains), out_(out) {}

    /// The parts of a run's stroke that are seen.
    void write(Index run, const DrawnLine& line) {
        piece_ = inking_.runs.piece[run];
        const Index number = inking_.pen_of_run[run], path = frame_.clipped->path[piece_];
        near_ = &inking_.pens[number];
        away_ = near_->away == none ? near_ : &inking_.pens[near_->away];
        grain_ = &grains_[number];
        const std::size_t last = line.points.size() - 1;
        for (std::size_t from = 0, to = 0; from < last; from = std::max(to, from + 1)) {
            for (to = from; to < last && seen(line, to); ++to) write_point(line.points[to]);
            if (to == from) continue;
            write_point(line.points[to]);
            out_.rows.offsets.push_back(Index(to - from + 1));
            out_.path_id.push_back(frame_.paths->id[path]);
            out_.pen.push_back(number);
            out_.line_set.push_back(frame_.paths->line_set[path]);
            out_.invisibility.push_back(inking_.runs.invisibility[run]);
            out_.closed.push_back(line.closed && from == 0 && to == last);
        }
    }

   private:
    /// Whether the segment from a point is.
    bool seen(const DrawnLine& line, std::size_t i) const {
        return std::max(opacity_of(line.points[i]), opacity_of(line.points[i + 1])) > unseen;
    }
    float opacity_of(const CenterPoint& p) const {
        const double whole = grain_->opacity * p.mean_opacity();
        return float(std::clamp(whole, 0.0, 1.0));
    }

    void write_point(const CenterPoint& p) {
        const ClippedPaths& clipped = *frame_.clipped;
        const style::Pen &near = near_->look, &away = away_->look;
        const double mix = p.mix.x;
        const dvec3 second = glm::mix(near.second_color, away.second_color, mix);
        const double distance = stroke::distance_at(clipped, piece_, p.arc);
        out_.position_view.push_back(vec3(base::from_pixels(frame_.job.view, clip_to_view_, p.px, distance)));
        out_.color.push_back(vec3(glm::mix(p.color, second, double(p.tint))));
        out_.width_px.push_back(float(2.0 * p.half_width * p.thinness * grain_->width));
        out_.opacity.push_back(opacity_of(p));
        const Index segment = clipped.segment_at(piece_, p.arc);
        const float share = float(clipped.share_at(segment, p.arc));
        const auto strength = [&](Index point) { return clipped.at_point(frame_.paths->strength, point); };
        out_.strength.push_back(glm::mix(strength(segment), strength(segment + 1), share));
        out_.kinds.push_back(frame_.paths->kinds[clipped.source[segment]]);
    }

    const Frame& frame_;
    const Inking& inking_;
    In<Grain> grains_;
    CenterLines& out_;
    const dmat4 clip_to_view_ = glm::inverse(frame_.job.view.view_to_clip);
    Index piece_ = 0;
    const Pen *near_ = nullptr, *away_ = nullptr;
    const Grain* grain_ = nullptr;
};

/// The runs that have a pen, by the ids of their paths, then as they follow each other.
Array<Index> by_path_id(const Frame& frame, const Inking& inking) {
    Array<Index> runs;
    for (Index r = 0; r < inking.runs.size(); ++r)
        if (inking.pen_of_run[r] != none) runs.push_back(r);
    const auto id = [&](Index run) { return frame.paths->id[frame.clipped->path[inking.runs.piece[run]]]; };
    std::ranges::stable_sort(runs, {}, id);
    return runs;
}

template <typename Columns>
void append(const CenterLines& part, const Columns& columns, std::size_t count, CenterLines& all, std::size_t at) {
    resize_columns(all, columns, at + count);
    copy_columns(part, columns, all, at);
}

/// The parts one after the other. The offsets of each, after the first, are still counts.
CenterLines joined(const std::vector<CenterLines>& parts) {
    CenterLines all;
    auto& counts = all.rows.offsets;
    counts.clear();
    for (const CenterLines& part : parts) {
        append(part, CenterLines::line_columns, part.pen.size(), all, all.pen.size());
        append(part, CenterLines::point_columns, part.kinds.size(), all, all.kinds.size());
        counts.insert(counts.end(), part.rows.offsets.begin() + 1, part.rows.offsets.end());
    }
    check(all.kinds.size() < none, "center lines: more than four billion points");
    counts_to_offsets(counts);
    return all;
}

}  // namespace

CenterLines center_lines_of(Frame& frame) {
    frame.shape();
    const Inking inking = frame.inking(frame.shown);
    check_inking(inking);
    const LineShaper shaper(inking);
    std::vector<Grain> grains;
    for (const Pen& pen : inking.pens)
        grains.push_back(grain_of(pen.texture == none ? nullptr : &frame.pens.textures[pen.texture]));
    const Array<Index> order = by_path_id(frame, inking);
    const auto parts =
        parallel_parts<CenterLines>(order.size(), 128, [&](CenterLines& out, std::size_t i, std::size_t end) {
            LineWriter writer(frame, inking, grains, out);
            DrawnLine line;
            for (; i < end; ++i)
                if (shaper.shape(order[i], line)) writer.write(order[i], line);
        });
    return joined(parts);
}

}  // namespace fovea::vector
