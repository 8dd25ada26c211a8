// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/project/project.h>

#include <algorithm>
#include <cmath>

#include <fovea/base/check.h>
#include <fovea/project/backs.h>
#include <fovea/project/clip.h>
#include <fovea/project/slivers.h>
#include <fovea/scene/section.h>

namespace fovea::project {
namespace {

constexpr const char* too_many_samples =
    "options.sample_step: the drawing has more than four billion samples; draw fewer lines or a smaller picture";
/// Coordinates beyond this overflow in Embree; such paths are dropped.
constexpr double farthest = 1e18;
/// Beyond so many half sizes of the frame, a path has no pixels: lines that pass close by the eye would have more than
/// numbers can count.
constexpr double most_frames = 1e6;

/// One path, projected, before clipping.
struct Projected {
    std::vector<dvec3> view;
    std::vector<dvec4> clip;
    std::vector<dvec2> px;              // of points in front of the near plane
    std::vector<double> before;         // per point: distance before the section plane; empty: it cuts nothing
    std::vector<std::uint8_t> outside;  // per point: a bit per clip plane that it is outside of; the last: the section
    std::uint8_t outside_all = 0, outside_any = 0;
    std::vector<Interval> has_pixels;  // per segment: the part in front of the near plane, and not beyond most_frames
    std::vector<double> length;        // per segment, in space
    std::vector<double> arc_px;        // per point: pixels of path before it
    double middle_px = 0.0;
};

/// A point of a piece: position on a segment of its path, and arc length of the path up to it [px].
struct Stop {
    Index segment;
    double t;
    double arc;
};

/// Projects paths sequentially into its own ClippedPaths.
class Projector {
   public:
    Projector(const Paths& paths, const Scene& scene, const View& view, const Backs& backs,
              const ProjectOptions& options)
        : paths_(paths), scene_(scene), view_(view), backs_(backs), options_(options) {}

    /// Reserves memory for pieces and points.
    void reserve(std::size_t pieces, std::size_t points) {
        reserve_columns(out, ClippedPaths::piece_columns, pieces);
        reserve_columns(out, ClippedPaths::point_columns, points);
        out.pieces.offsets.reserve(pieces);
    }

    void add(Index path) {
        if (measures(path) && !is_speck(path)) clip(path, paths_.rows.begin(path), paths_.rows.end(path));
    }

    /// Whether a path is a short closed contour that encloses almost no area: mesh noise where a smooth surface is seen
    /// at a grazing angle.
    bool is_sliver(Index path) {
        constexpr double roundness = 0.02;  // area / perimeter^2; a circle has 0.08
        const std::size_t set = paths_.line_set[path];
        if (!paths_.of_view[path] || !paths_.closed[path] || set >= options_.least_length_px.size() || !measures(path))
            return false;
        const double perimeter = p_.arc_px.back();
        if (perimeter > 2.0 * options_.least_length_px[set]) return false;
        double area = 0.0;
        for (std::size_t i = 0; i + 1 < p_.clip.size(); ++i) area += 0.5 * cross(pixels_at(i, 0.0), pixels_at(i, 1.0));
        return std::abs(area) < roundness * perimeter * perimeter;
    }

    ClippedPaths out;

   private:
    /// Projects and measures a path; false if nothing of it can be drawn.
    bool measures(Index path) {
        const Index begin = paths_.rows.begin(path), end = paths_.rows.end(path);
        if (end - begin < 2) return false;
        transform(path, begin, end);
        if (!reachable() || p_.outside_all) return false;
        measure();
        return std::isfinite(p_.arc_px.back() - p_.middle_px);
    }

    void transform(Index path, Index begin, Index end) {
        const Index placement = paths_.placement[path];
        if (placement != placement_) {
            const bool in_image = placement == none;
            check(in_image || placement < scene_.placements.size(), "project: the paths are not of this scene");
            placement_ = placement;
            object_to_view_ =
                in_image ? dmat4(1.0) : view_.world_to_view * scene_.placements[placement].object_to_world;
            object_to_clip_ = view_.view_to_clip * object_to_view_;
            cut_ = in_image ? Cut() : cut_of(scene_, scene_.placements[placement]);
        }
        const std::size_t count = end - begin;
        p_.view.resize(count);
        p_.clip.resize(count);
        p_.px.resize(count);
        p_.outside.resize(count);
        p_.before.resize(cut_.kept == Cut::all ? 0 : count);
        p_.outside_all = 0xff;
        p_.outside_any = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const dvec4 point(dvec3(paths_.points_obj[begin + i]), 1.0);
            p_.view[i] = dvec3(object_to_view_ * point);
            p_.clip[i] = object_to_clip_ * point;
            p_.outside[i] = beyond(p_.view[i], p_.clip[i]);
            if (!p_.before.empty()) {
                // Lines in the plane, such as its own, stay.
                p_.before[i] = cut_.before(paths_.points_obj[begin + i]) - cut_.slack;
                p_.outside[i] |= (p_.before[i] > 0.0) << clip_planes;
            }
            p_.outside_all &= p_.outside[i];
            p_.outside_any |= p_.outside[i];
            if (!(p_.outside[i] & 1)) p_.px[i] = to_pixels(view_, p_.clip[i]);
        }
    }

    /// Outcode: a bit per clip plane that the point is outside of.
    std::uint8_t beyond(const dvec3& position, const dvec4& clip) const {
        int bits = 0;
        for (int plane = 0; plane < clip_planes; ++plane)
            bits |= (plane_distance(plane, position, clip, view_, options_.margin) < 0.0) << plane;
        return static_cast<std::uint8_t>(bits);
    }

    /// False if a view-space coordinate is NaN, infinite, or too large for rays.
    bool reachable() const {
        return std::all_of(p_.view.begin(), p_.view.end(), [](const dvec3& p) {
            return std::abs(p.x) < farthest && std::abs(p.y) < farthest && std::abs(p.z) < farthest;
        });
    }

    /// Whether a path with a free end is shorter than the minimum, or what goes around a tip of one surface that pokes
    /// through another is than a third of it; faint parts do not count.
    bool is_speck(Index path) const {
        const std::size_t set = paths_.line_set[path];
        if (set >= options_.least_length_px.size()) return false;
        const double least = options_.least_length_px[set];
        const bool around_tip = paths_.closed[path] && paths_.other_facet_at(paths_.rows.begin(path)) != none;
        return (paths_.free_ends[path] || around_tip) &&
               drawn_px(path) < (paths_.free_ends[path] ? least : least / 3.0);
    }

    /// Length in pixels of the segments of a path whose strength is visible.
    double drawn_px(Index path) const {
        constexpr float faint = 0.1f;
        double length = 0.0;
        for (Index i = paths_.rows.begin(path), k = 0; i + 1 < paths_.rows.end(path); ++i, ++k)
            if (paths_.strength[i] + paths_.strength[i + 1] >= 2.0f * faint) length += p_.arc_px[k + 1] - p_.arc_px[k];
        return length;
    }

    /// Measures arc length in pixels, and its value at the path's middle (in space).
    void measure() {
        const std::size_t segments = p_.clip.size() - 1;
        p_.has_pixels.resize(segments);
        p_.arc_px.resize(segments + 1);
        p_.length.resize(segments);
        double total_space = 0.0;
        for (std::size_t i = 0; i < segments; ++i)
            total_space += p_.length[i] = glm::length(p_.view[i + 1] - p_.view[i]);
        double space = 0.0, px = 0.0;
        bool middle_found = false;
        for (std::size_t i = 0; i < segments; ++i) {
            p_.arc_px[i] = px;
            Interval range = whole_segment;
            if (p_.outside_any)
                range = clip_segment(p_.view[i], p_.view[i + 1], p_.clip[i], p_.clip[i + 1], view_, most_frames);
            p_.has_pixels[i] = range;
            const double length = p_.length[i];
            const double to_middle = 0.5 * total_space - space;
            if (!middle_found && (to_middle <= length || i + 1 == segments)) {
                const double t = length > 0.0 ? std::min(1.0, to_middle / length) : 0.0;
                p_.middle_px = px + (range.begin < range.end && t > range.begin
                                         ? pixel_length(i, range.begin, std::min(t, range.end))
                                         : 0.0);
                middle_found = true;
            }
            if (range.begin < range.end) px += pixel_length(i, range.begin, range.end);
            space += length;
        }
        p_.arc_px[segments] = px;
    }

    dvec3 position_at(std::size_t segment, double t) const {
        if (t == 0.0) return p_.view[segment];
        if (t == 1.0) return p_.view[segment + 1];
        return glm::mix(p_.view[segment], p_.view[segment + 1], t);
    }
    dvec2 pixels_at(std::size_t segment, double t) const {
        if (t == 0.0 && !(p_.outside[segment] & 1)) return p_.px[segment];
        if (t == 1.0 && !(p_.outside[segment + 1] & 1)) return p_.px[segment + 1];
        // Of a segment that ends endlessly far away, a position has no digits that tell it from the eye.
        const dvec2 px = to_pixels(view_, glm::mix(p_.clip[segment], p_.clip[segment + 1], t));
        const dvec2 most = most_frames * dvec2(view_.width, view_.height);
        return {std::fmin(std::fmax(px.x, -most.x), most.x), std::fmin(std::fmax(px.y, -most.y), most.y)};
    }
    double pixel_length(std::size_t segment, double t0, double t1) const {
        return glm::length(pixels_at(segment, t1) - pixels_at(segment, t0));
    }

    /// Arc length [px] at a position.
    double arc_at(std::size_t segment, double t) const {
        const Interval& range = p_.has_pixels[segment];
        if (t <= range.begin) return p_.arc_px[segment];
        if (t >= range.end) return p_.arc_px[segment + 1];
        return std::min(p_.arc_px[segment] + pixel_length(segment, range.begin, t), p_.arc_px[segment + 1]);
    }

    /// Half the size of what is surely around the widened frame [px].
    dvec2 around_frame() const { return (1.0 + options_.margin) * dvec2(view_.width, view_.height); }

    /// False where numbers have too few digits to clip a segment at the frame: it ends endlessly far away.
    bool is_near_frame(std::size_t segment, double t) const {
        const dvec2 most = around_frame();
        const dvec2 off = glm::abs(pixels_at(segment, t) - 0.5 * dvec2(view_.width, view_.height));
        const bool in_front = view_.orthographic || -position_at(segment, t).z > 0.5 * view_.near_clip;
        return in_front && off.x <= most.x && off.y <= most.y;
    }

    void clip(Index path, Index begin, Index end) {
        const Index segments = end - begin - 1;
        bool whole = true;
        const std::size_t first_piece = out.path.size();
        const double longest = 2.0 * glm::length(around_frame());
        stops_.clear();
        for (Index i = 0; i < segments; ++i) {
            Interval range = whole_segment;
            if (p_.outside[i] | p_.outside[i + 1])
                range = clip_segment(p_.view[i], p_.view[i + 1], p_.clip[i], p_.clip[i + 1], view_, options_.margin);
            if (!p_.before.empty()) clip_plane(-p_.before[i], -p_.before[i + 1], range);
            const bool visible = range.begin < range.end && is_near_frame(i, range.begin) &&
                                 is_near_frame(i, range.end) && !(backs_.any() && backs_.hold(paths_, path, begin + i));
            whole = whole && range.begin == 0.0 && range.end == 1.0;
            if (!visible || range.begin > 0.0) finish_piece(path, begin);
            if (!visible) continue;
            if (stops_.empty()) stops_.push_back({i, range.begin, arc_at(i, range.begin)});
            // Arc lengths far outside of the frame may lack the digits to tell how long the part inside is.
            const double arc = stops_.back().arc;
            stops_.push_back({i, range.end, std::clamp(arc_at(i, range.end), arc, arc + longest)});
            if (range.end < 1.0) finish_piece(path, begin);
        }
        finish_piece(path, begin);
        if (out.path.size() == first_piece) return;
        if (whole && paths_.closed[path] && out.path.size() == first_piece + 1) out.closed.back() = 1;
        mark_ends(path, begin, end, first_piece);
    }

    /// Writes the piece through the stops, if there are any.
    void finish_piece(Index path, Index begin) {
        if (stops_.empty()) return;
        const std::size_t count = stops_.size(), first = out.px.size();
        resize_columns(out, ClippedPaths::point_columns, first + count);
        std::uint64_t total = 0;
        for (std::size_t k = 0; k < count; ++k) {
            write_point(first + k, begin, stops_[k]);
            if (k + 1 < count)
                write_segment(first + k, path, begin + stops_[k + 1].segment, stops_[k + 1].arc - stops_[k].arc);
            total += out.sample_count[first + k];
        }
        check(out.samples + total < none, too_many_samples);
        stops_.clear();
        if (total == 0 || (count == 2 && total == 1)) {
            resize_columns(out, ClippedPaths::point_columns, first);
            return;
        }
        for (std::size_t i = first; i < first + count; ++i) {
            out.sample_start[i] = out.samples;
            out.samples += out.sample_count[i];
        }
        append_zeros(out, ClippedPaths::piece_columns);
        out.path.back() = path;
        out.path_length_px.back() = p_.arc_px.back();
        out.pieces.offsets.push_back(static_cast<Index>(first + count));
    }

    void write_point(std::size_t at, Index begin, const Stop& stop) {
        const auto [segment, t, arc] = stop;
        const dvec3 position = position_at(segment, t);
        out.px[at] = vec2(pixels_at(segment, t));
        out.depth[at] = placement_ == none ? before_all : static_cast<float>(screen_depth(view_, position.z));
        out.position_view[at] = vec3(position);
        out.arc_px[at] = arc - p_.middle_px;
        out.source[at] = t < 1.0 ? begin + segment : begin + segment + 1;
        out.source_t[at] = t < 1.0 ? static_cast<float>(t) : 0.0f;
        out.facet0[at] = out.facet1[at] = none;
        out.sample_count[at] = 0;
    }

    /// Writes the segment that starts at a point.
    void write_segment(std::size_t at, Index path, Index source, double length) {
        out.sample_count[at] = static_cast<Index>(std::ceil(length / options_.sample_step_px));
        const Index placement = paths_.placement[path], place = paths_.place[source];
        if (placement == none) return;
        const Surface& surface = *scene_.placements[placement].surface;
        check(place < surface.place_count(), "project: the paths are not of this scene");
        const Index base = scene_.facet_base[placement];
        if (surface.is_edge(place)) {
            const Index side = surface.edge_rows.begin(place), sides = surface.edge_rows.size(place);
            if (sides > 0) out.facet0[at] = base + surface.edge_sides[side].facet();
            if (sides > 1) out.facet1[at] = base + surface.edge_sides[side + 1].facet();
        } else {
            out.facet0[at] = base + surface.triangle_facet[surface.triangle_at(place)];
            out.facet1[at] = paths_.other_facet_at(source);
        }
    }

    /// Marks ends of the path on its first and last piece.
    void mark_ends(Index path, Index begin, Index end, std::size_t first_piece) {
        const int free = path < paths_.free_ends.size() ? paths_.free_ends[path] : 0;
        const bool closed = paths_.closed[path];
        const Index first = out.pieces.begin(static_cast<Index>(first_piece)), last = out.pieces.offsets.back() - 1;
        if (out.source[first] == begin && out.source_t[first] == 0.0f) {
            out.free_ends[first_piece] |= free & free_start;
            out.ends[first_piece] |= closed ? seam_start : path_start;
        }
        if (out.source[last] == end - 1) {
            out.free_ends.back() |= free & free_end;
            out.ends.back() |= closed ? seam_end : path_end;
        }
    }

    const Paths& paths_;
    const Scene& scene_;
    const View& view_;
    const Backs& backs_;
    const ProjectOptions& options_;
    Projected p_;
    Index placement_ = none;  // whose transforms are set; none: view space
    dmat4 object_to_view_{1.0}, object_to_clip_{view_.view_to_clip};
    Cut cut_;
    std::vector<Stop> stops_;  // of the piece that is being clipped
};

/// Concatenates parts; each is freed once it is copied.
ClippedPaths join(std::vector<ClippedPaths>& parts) {
    std::vector<std::uint64_t> pieces, points, samples;
    for (const ClippedPaths& part : parts) {
        pieces.push_back(part.path.size());
        points.push_back(part.px.size());
        samples.push_back(part.samples);
    }
    for (auto* counts : {&pieces, &points, &samples}) counts_to_offsets(*counts);
    check(samples.back() < none && points.back() < none, too_many_samples);
    ClippedPaths all;
    all.samples = Index(samples.back());
    all.pieces.offsets.assign(pieces.back() + 1, Index(points.back()));
    resize_columns(all, ClippedPaths::piece_columns, pieces.back());
    resize_columns(all, ClippedPaths::point_columns, points.back());
    const auto copy = [&](std::size_t b) {
        const ClippedPaths part = std::move(parts[b]);
        const Index point = Index(points[b]);
        for (Index q = 0; q < part.path.size(); ++q) all.pieces.offsets[pieces[b] + q] = point + part.pieces.begin(q);
        copy_columns(part, ClippedPaths::piece_columns, all, pieces[b]);
        copy_columns(part, ClippedPaths::point_columns, all, point);
        for (std::size_t i = 0; i < part.px.size(); ++i) all.sample_start[point + i] += Index(samples[b]);
    };
    parallel_for(parts.size(), 1, copy);
    return all;
}

}  // namespace

ClippedPaths project(const Paths& paths, const Scene& scene, const View& view, const ProjectOptions& options,
                     const Cancel& cancel) {
    check(options.sample_step_px >= least_sample_step_px, "sample_step_px must be at least a thousandth");
    const Backs backs(scene, view);
    const auto slivers =
        parallel_collect<Index>(paths.count(), paths_per_block, [&](std::size_t p, std::size_t end, auto& found) {
            cancel.poll();
            Projector projector(paths, scene, view, backs, options);
            for (; p < end; ++p)
                if (projector.is_sliver(static_cast<Index>(p))) found.push_back(static_cast<Index>(p));
        });
    const Array<Index> dropped = slivers_apart(paths, slivers);
    auto parts = parallel_parts<ClippedPaths>(
        paths.count(), paths_per_block, [&](ClippedPaths& part, std::size_t begin, std::size_t end) {
            cancel.poll();
            Projector projector(paths, scene, view, backs, options);
            projector.reserve(end - begin, paths.rows.offsets[end] - paths.rows.offsets[begin]);
            for (std::size_t p = begin; p < end; ++p)
                if (!std::ranges::binary_search(dropped, Index(p))) projector.add(static_cast<Index>(p));
            part = std::move(projector.out);
        });
    ClippedPaths all = join(parts);
    all.orthographic = view.orthographic;
    return all;
}

}  // namespace fovea::project
