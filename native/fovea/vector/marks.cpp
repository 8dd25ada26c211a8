// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/vector/marks.h>

#include <algorithm>

#include <fovea/base/check.h>
#include <fovea/color/displayed.h>
#include <fovea/color/srgb.h>

namespace fovea::vector {
namespace {

constexpr double least_opacity = 1.0 / 255.0;  // that is seen
constexpr float half_shown = 0.5f;             // by elision
constexpr double most_change = 0.125;          // of opacity and color, each in [0,1], along a mark

/// A point of a stroke on the page.
struct Inked {
    dvec2 at;
    double arc, width;
    dvec4 ink;     // color as displayed, and opacity
    dvec2 anchor;  // CenterPoint's along, whole_px
};

Inked between(const Inked& a, const Inked& b, double t) {
    return {glm::mix(a.at, b.at, t), glm::mix(a.arc, b.arc, t), glm::mix(a.width, b.width, t),
            glm::mix(a.ink, b.ink, t), glm::mix(a.anchor, b.anchor, t)};
}

dvec4 ink_of(const CenterPoint& p, const Pen& pen, const Pen& away, double density, const dvec3& paper) {
    const style::Pen &near = pen.look, &far = away.look;
    const double mix = p.mix.x;
    const dvec3 second = glm::mix(near.second_color, far.second_color, mix);
    const dvec3 color = glm::mix(p.color, second, double(p.tint));
    const double opacity = density * p.mean_opacity();
    return {color::displayed(color), color::displayed_opacity(opacity, color, paper)};
}

double range(const dvec4& low, const dvec4& high) {
    const dvec4 d = high - low;
    return std::max({d.x, d.y, d.z, d.w});
}

/// The sides of the picture on a page. Strokes go on beyond them, as far as their ends need it.
struct Sides {
    dvec2 lower, upper;
    double reach;  ///< of strokes beyond them, in widths: half of it leaves no ink of the picture out

    /// How far a point is inside each of them; negative: strokes end before it.
    dvec4 room(const Inked& p) const { return dvec4(p.at - lower, upper - p.at) + reach * p.width; }
    /// Whether the segment is in the picture that no side cuts in between.
    bool hold(const Inked& a, const Inked& b) const {
        const dvec4 left = room(between(a, b, 0.5));
        return std::min({left.x, left.y, left.z, left.w}) >= 0.0;
    }
};

/// The points of a stroke, with more where its ink changes much from one to the next or begins to be seen, and where it
/// leaves the picture.
std::vector<Inked> stepped(const std::vector<Inked>& points, const Sides& sides) {
    std::vector<Inked> all{points.front()};
    std::vector<double> places;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const Inked &a = points[i - 1], &b = points[i];
        const double change = range(glm::min(a.ink, b.ink), glm::max(a.ink, b.ink));
        const int steps = std::max(1, int(std::ceil(2.0 * change / most_change)));
        places.clear();
        for (int k = 1; k < steps; ++k) places.push_back(double(k) / steps);
        const dvec4 from = sides.room(a), to = sides.room(b);
        for (int side = 0; side < 4; ++side)
            if (from[side] * to[side] < 0.0) places.push_back(from[side] / (from[side] - to[side]));
        std::ranges::sort(places);
        for (const double t : places) all.push_back(between(a, b, t));
        all.push_back(b);
    }
    return all;
}

class Splitter {
   public:
    Splitter(const std::vector<Inked>& points, const Sides& sides, Index run, bool closed, Cutting cutting,
             bool anchored, std::vector<Mark>& out)
        : points_(points),
          sides_(sides),
          run_(run),
          closed_(closed),
          whole_(cutting != Cutting::by_ink),
          anchored_(anchored),
          out_(out) {}

    void split() {
        const std::size_t last = points_.size() - 1;
        for (std::size_t from = 0; from < last;) {
            const bool drawn = seen(from);
            dvec4 low = points_[from].ink, high = low;
            std::size_t to = from;
            while (to < last && seen(to) == drawn) {
                const dvec4 next = points_[to + 1].ink;
                low = glm::min(low, next);
                high = glm::max(high, next);
                if (drawn && !whole_ && to > from && range(low, high) > most_change) break;
                ++to;
            }
            if (drawn) add(from, to);
            from = to;
        }
    }

   private:
    /// Whether the segment from a point is.
    bool seen(std::size_t i) const {
        return std::max(points_[i].ink.w, points_[i + 1].ink.w) > least_opacity && is_inside(i);
    }
    bool is_inside(std::size_t i) const { return sides_.hold(points_[i], points_[i + 1]); }

    void add(std::size_t from, std::size_t to) {
        const bool starts = from == 0, ends = to + 1 == points_.size();
        Mark mark{.run = run_,
                  .arc = points_[from].arc,
                  .closed = closed_ && starts && ends,
                  .starts = starts ? !closed_ : !is_inside(from - 1),
                  .ends = ends ? !closed_ : !is_inside(to)};
        dvec4 sum(0.0);
        double length = 0.0;
        for (std::size_t i = from; i <= to; ++i) {
            mark.points.push_back(points_[i].at);
            mark.widths.push_back(points_[i].width);
            if (anchored_) mark.anchors.push_back(points_[i].anchor);
            if (i == to) break;
            const double step = glm::distance(points_[i].at, points_[i + 1].at);
            sum += 0.5 * step * (points_[i].ink + points_[i + 1].ink);
            length += step;
        }
        if (!(length > 0.0)) return;
        mark.color = dvec3(sum) / length;
        mark.opacity = std::min(sum.w / length, 1.0);
        out_.push_back(std::move(mark));
    }

    const std::vector<Inked>& points_;
    const Sides& sides_;
    Index run_;
    bool closed_, whole_, anchored_;
    std::vector<Mark>& out_;
};

/// Coordinates of a run's polyline.
std::size_t numbers_of(const ClippedPaths& clipped, const Runs& runs, std::size_t r) {
    const Index piece = runs.piece[r];
    const auto first = clipped.arc_px.begin() + clipped.pieces.begin(piece);
    const auto last = clipped.arc_px.begin() + clipped.pieces.end(piece);
    const auto inside = std::lower_bound(first, last, runs.end_px[r]) - std::upper_bound(first, last, runs.start_px[r]);
    return 2 * (std::size_t(std::max<std::ptrdiff_t>(inside, 0)) + 2);
}

}  // namespace

Marks marks_of(const Frame& frame, const Page& page, double tolerance, Cutting cutting) {
    Inking inking = frame.inking(frame.shown);
    // What is left out of lines is small beside what curves may be off.
    inking.tolerance_px = std::min(inking.tolerance_px, 0.1 * tolerance / page.scale);
    check_inking(inking);
    const LineShaper shaper(inking);
    const dvec3 paper = frame.job.style.paper.color;
    const View& view = frame.job.view;
    const Sides sides{page.place({0, 0}), page.place({view.width, view.height}),
                      cutting == Cutting::elision ? 0.0 : 0.5};
    const double of_mm = 1.0 / (frame.job.style.paper.px_per_mm(view.reference_scale) * page.unit_mm);
    Marks found;
    for (const Pen& pen : frame.pens.pens)
        found.grains.push_back(
            grain_of(pen.texture == none ? nullptr : &frame.pens.textures[pen.texture], is_anchored(pen)));
    const auto parts = parallel_parts<Marks>(inking.runs.size(), 128, [&](Marks& out, std::size_t r, std::size_t end) {
        DrawnLine line;
        for (; r < end; ++r) {
            const Index number = inking.pen_of_run[r];
            if (number == none || !shaper.shape(Index(r), line)) continue;
            const Pen& pen = inking.pens[number];
            const Grain& grain = found.grains[number];
            const bool in_mm = pen.look.width_unit == style::WidthUnit::millimetres;
            const double of_width = 2.0 * grain.width * (in_mm ? of_mm : page.scale);
            std::vector<Inked> points;
            for (const CenterPoint& p : line.points) {
                points.push_back({page.place(p.px),
                                  page.scale * p.arc,
                                  of_width * p.half_width * p.thinness,
                                  ink_of(p, pen, pen.away == none ? pen : inking.pens[pen.away], grain.opacity, paper),
                                  {p.along, p.whole_px}});
                double& opacity = points.back().ink.w;
                if (cutting == Cutting::elision) opacity = opacity > least_opacity && p.shown >= half_shown ? 1.0 : 0.0;
            }
            const std::size_t before = out.marks.size();
            const bool anchored = !grain.dividing.ink.empty();
            Splitter(stepped(points, sides), sides, Index(r), line.closed, cutting, anchored, out.marks).split();
            if (out.marks.size() > before) out.numbers += numbers_of(inking.clipped, inking.runs, r);
        }
    });
    for (const Marks& part : parts) {
        found.marks.insert(found.marks.end(), part.marks.begin(), part.marks.end());
        found.numbers += part.numbers;
    }
    return found;
}

double mean_width(const Mark& mark) {
    double sum = 0.0, length = 0.0;
    for (std::size_t i = 1; i < mark.points.size(); ++i) {
        const double step = glm::distance(mark.points[i - 1], mark.points[i]);
        sum += 0.5 * step * (mark.widths[i - 1] + mark.widths[i]);
        length += step;
    }
    return length > 0.0 ? sum / length : 0.0;
}

}  // namespace fovea::vector
