#include "project/project.h"

#include <cmath>

#include "base/check.h"
#include "project/clip.h"

namespace fovea {
namespace {

constexpr std::size_t paths_per_block = 512;
constexpr const char* too_many_samples = "the drawing has more than four billion samples; raise the sample step";
/// Coordinates beyond it are nobody's scene, and Embree drops them.
constexpr double farthest = 1e18;
/// Finer steps would only fill memory.
constexpr double least_sample_step_px = 1e-3;

/// One path, projected, before clipping.
struct Projected {
    std::vector<dvec3> view;
    std::vector<dvec4> clip;
    std::vector<ClipRange> near_range;  // per segment: the part in front of the near plane
    std::vector<double> arc_px;         // per point: pixels of path in front of the near plane before it
    double middle_px = 0.0;
};

/// Projects paths one after the other into its own ClippedPaths.
class Projector {
   public:
    Projector(const Paths& paths, const Scene& scene, const View& view, const ProjectOptions& options)
        : paths_(paths), scene_(scene), view_(view), options_(options) {}

    /// Room for so many pieces and points, so that arrays do not grow step by step.
    void reserve(std::size_t pieces, std::size_t points) {
        const auto each = [](std::size_t count, auto&... arrays) { (arrays.reserve(count), ...); };
        each(pieces, out.path, out.closed, out.free_ends, out.pieces.offsets);
        each(points, out.px, out.depth, out.position_view, out.arc_px, out.source, out.source_t, out.facet0, out.facet1,
             out.sample_start, out.sample_count);
    }

    void add(Index path) {
        const Index begin = paths_.rows.begin(path), end = paths_.rows.end(path);
        if (end - begin < 2) return;
        transform(path, begin, end);
        if (!reachable() || outside()) return;
        measure();
        if (is_speck(path) || is_sliver(path)) return;
        clip(path, begin, end);
    }

    ClippedPaths out;

   private:
    void transform(Index path, Index begin, Index end) {
        const Index placement = paths_.placement[path];
        if (placement != placement_) {
            check(placement < scene_.placements.size(), "project: the paths are not of this scene");
            placement_ = placement;
            object_to_view_ = view_.world_to_view * scene_.placements[placement].object_to_world;
        }
        const std::size_t count = end - begin;
        p_.view.resize(count);
        p_.clip.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            p_.view[i] = dvec3(object_to_view_ * dvec4(dvec3(paths_.points_obj[begin + i]), 1.0));
            p_.clip[i] = view_.view_to_clip * dvec4(p_.view[i], 1.0);
        }
    }

    /// False where a placement puts the path nowhere, or farther than rays reach.
    bool reachable() const {
        return std::all_of(p_.view.begin(), p_.view.end(), [](const dvec3& p) {
            return std::abs(p.x) < farthest && std::abs(p.y) < farthest && std::abs(p.z) < farthest;
        });
    }

    /// All points beyond one side of the frame.
    bool outside() const {
        for (int plane = 0; plane < clip_planes; ++plane) {
            bool all = true;
            for (std::size_t i = 0; i < p_.clip.size() && all; ++i)
                all = plane_distance(plane, p_.view[i], p_.clip[i], view_, options_.margin) < 0.0;
            if (all) return true;
        }
        return false;
    }

    /// A short path that leads nowhere.
    bool is_speck(Index path) const {
        const std::size_t set = paths_.line_set[path];
        return set < options_.least_length_px.size() && paths_.free_ends[path] != 0 &&
               p_.arc_px.back() < options_.least_length_px[set];
    }

    /// A short contour around nothing: noise of the mesh where a smooth surface is seen at a grazing angle.
    bool is_sliver(Index path) const {
        constexpr double roundness = 0.02;  // area / perimeter^2; a circle has 0.08
        const std::size_t set = paths_.line_set[path];
        const double perimeter = p_.arc_px.back();
        if (set >= options_.least_length_px.size() || !paths_.of_view[path] || !paths_.closed[path] ||
            perimeter > 2.0 * options_.least_length_px[set])
            return false;
        double area = 0.0;
        for (std::size_t i = 0; i + 1 < p_.clip.size(); ++i) {
            const dvec2 a = pixels_at(i, 0.0), b = pixels_at(i, 1.0);
            area += 0.5 * (a.x * b.y - a.y * b.x);
        }
        return std::abs(area) < roundness * perimeter * perimeter;
    }

    /// Arc length in pixels of what lies in front of the near plane, and where the path's middle (in space) falls.
    void measure() {
        const std::size_t segments = p_.clip.size() - 1;
        p_.near_range.resize(segments);
        p_.arc_px.resize(segments + 1);
        double total_space = 0.0;
        for (std::size_t i = 0; i < segments; ++i) total_space += glm::length(p_.view[i + 1] - p_.view[i]);
        double space = 0.0, px = 0.0;
        bool middle_found = false;
        for (std::size_t i = 0; i < segments; ++i) {
            p_.arc_px[i] = px;
            const ClipRange range = clip_near(p_.view[i], p_.view[i + 1], view_);
            p_.near_range[i] = range;
            const double length = glm::length(p_.view[i + 1] - p_.view[i]);
            const double to_middle = 0.5 * total_space - space;
            if (!middle_found && (to_middle <= length || i + 1 == segments)) {
                const double t = length > 0.0 ? std::min(1.0, to_middle / length) : 0.0;
                p_.middle_px = px + (range.begin < range.end && t > range.begin
                                         ? pixel_length(i, range.begin, std::min(t, range.end)) : 0.0);
                middle_found = true;
            }
            if (range.begin < range.end) px += pixel_length(i, range.begin, range.end);
            space += length;
        }
        p_.arc_px[segments] = px;
    }

    dvec2 pixels_at(std::size_t segment, double t) const {
        return to_pixels(view_, glm::mix(p_.clip[segment], p_.clip[segment + 1], t));
    }
    double pixel_length(std::size_t segment, double t0, double t1) const {
        return glm::length(pixels_at(segment, t1) - pixels_at(segment, t0));
    }

    /// Pixels of path before a place in front of the near plane.
    double arc_at(std::size_t segment, double t) const {
        const ClipRange& range = p_.near_range[segment];
        if (t <= range.begin) return p_.arc_px[segment];
        if (t >= range.end) return p_.arc_px[segment + 1];
        return p_.arc_px[segment] + pixel_length(segment, range.begin, t);
    }

    void clip(Index path, Index begin, Index end) {
        const Index segments = end - begin - 1;
        bool open = false;  // the last segment reached its end, so the piece goes on
        bool whole = true;
        const std::size_t first_piece = out.path.size();
        for (Index i = 0; i < segments; ++i) {
            const ClipRange range = clip_segment(p_.view[i], p_.view[i + 1], p_.clip[i], p_.clip[i + 1], view_, options_.margin);
            const bool visible = range.begin < range.end;
            whole = whole && range.begin == 0.0 && range.end == 1.0;
            if (open && (!visible || range.begin > 0.0)) finish_piece();
            if (!visible) {
                open = false;
                continue;
            }
            if (!open || range.begin > 0.0) start_piece(path, begin, i, range.begin);
            add_segment(path, begin, i, range);
            open = range.end == 1.0;
            if (!open) finish_piece();
        }
        if (open) finish_piece();
        if (whole && paths_.closed[path] && out.path.size() == first_piece + 1) close_piece();
        if (out.path.size() > first_piece) mark_free_ends(path, begin, end, first_piece);
    }

    void start_piece(Index path, Index begin, Index segment, double t) {
        piece_begin_ = static_cast<Index>(out.px.size());
        out.path.push_back(path);
        out.closed.push_back(0);
        out.free_ends.push_back(0);
        add_point(begin, segment, t);
    }

    void add_point(Index begin, Index segment, double t) {
        const dvec3 position = glm::mix(p_.view[segment], p_.view[segment + 1], t);
        out.px.push_back(vec2(pixels_at(segment, t)));
        out.depth.push_back(static_cast<float>(screen_depth(view_, position.z)));
        out.position_view.push_back(vec3(position));
        out.arc_px.push_back(arc_at(segment, t) - p_.middle_px);
        out.source.push_back(t < 1.0 ? begin + segment : begin + segment + 1);
        out.source_t.push_back(t < 1.0 ? static_cast<float>(t) : 0.0f);
        out.facet0.push_back(none);
        out.facet1.push_back(none);
        out.sample_start.push_back(0);
        out.sample_count.push_back(0);
    }

    /// The segment from the point added last, and its other end.
    void add_segment(Index path, Index begin, Index segment, const ClipRange& range) {
        const std::size_t here = out.px.size() - 1;
        const Index placement = paths_.placement[path];
        const Surface& surface = *scene_.placements[placement].surface;
        const Index edge = paths_.edge[begin + segment];
        check(edge < surface.edge_rows.count(), "project: the paths are not of this scene");
        const Index side = surface.edge_rows.begin(edge), sides = surface.edge_rows.size(edge);
        const Index base = scene_.facet_base[placement];
        out.facet0[here] = sides > 0 ? base + surface.edge_sides[side].facet() : none;
        out.facet1[here] = sides > 1 ? base + surface.edge_sides[side + 1].facet() : none;
        const double length = arc_at(segment, range.end) - arc_at(segment, range.begin);
        out.sample_count[here] = static_cast<Index>(std::ceil(length / options_.sample_step_px));
        add_point(begin, segment, range.end);
    }

    void finish_piece() {
        const Index end = static_cast<Index>(out.px.size());
        std::uint64_t total = 0;
        for (Index i = piece_begin_; i < end; ++i) total += out.sample_count[i];
        check(out.samples + total + 2 * most_padding < none, too_many_samples);
        const auto samples = static_cast<Index>(total);
        const bool single = end - piece_begin_ == 2 && samples <= 1;
        if (samples == 0 || single) {
            drop_piece();
            return;
        }
        const Index padding = padding_of(samples);
        out.samples += padding;
        for (Index i = piece_begin_; i < end; ++i) {
            out.sample_start[i] = out.samples;
            out.samples += out.sample_count[i];
        }
        out.samples += padding;
        out.pieces.offsets.push_back(end);
    }

    void drop_piece() {
        out.path.pop_back();
        out.closed.pop_back();
        out.free_ends.pop_back();
        truncate(out.px, out.depth, out.position_view, out.arc_px, out.source, out.source_t, out.facet0, out.facet1,
                 out.sample_start, out.sample_count);
    }
    template <typename... T>
    void truncate(Array<T>&... arrays) {
        (arrays.resize(piece_begin_), ...);
    }

    void close_piece() { out.closed.back() = 1; }

    /// A piece has a free end where it reaches one of its path.
    void mark_free_ends(Index path, Index begin, Index end, std::size_t first_piece) {
        const int free = path < paths_.free_ends.size() ? paths_.free_ends[path] : 0;
        const Index first = out.pieces.begin(static_cast<Index>(first_piece)), last = out.pieces.offsets.back() - 1;
        if ((free & free_start) && out.source[first] == begin && out.source_t[first] == 0.0f)
            out.free_ends[first_piece] |= free_start;
        if ((free & free_end) && out.source[last] == end - 1) out.free_ends.back() |= free_end;
    }

    const Paths& paths_;
    const Scene& scene_;
    const View& view_;
    const ProjectOptions& options_;
    Projected p_;
    Index placement_ = none;
    dmat4 object_to_view_{1.0};
    Index piece_begin_ = 0;
};

/// Where each block's pieces, points and samples start in the joined result.
struct Start {
    Index piece, point, sample;
};

void append(const ClippedPaths& part, Start at, ClippedPaths& all) {
    const auto copy = [](const auto& from, auto& to, std::size_t where) {
        std::copy(from.begin(), from.end(), to.begin() + where);
    };
    for (Index q = 0; q < part.path.size(); ++q) all.pieces.offsets[at.piece + q] = at.point + part.pieces.begin(q);
    copy(part.path, all.path, at.piece);
    copy(part.closed, all.closed, at.piece);
    copy(part.free_ends, all.free_ends, at.piece);
    copy(part.px, all.px, at.point);
    copy(part.depth, all.depth, at.point);
    copy(part.position_view, all.position_view, at.point);
    copy(part.arc_px, all.arc_px, at.point);
    copy(part.source, all.source, at.point);
    copy(part.source_t, all.source_t, at.point);
    copy(part.facet0, all.facet0, at.point);
    copy(part.facet1, all.facet1, at.point);
    copy(part.sample_count, all.sample_count, at.point);
    for (std::size_t i = 0; i < part.px.size(); ++i) all.sample_start[at.point + i] = at.sample + part.sample_start[i];
}

ClippedPaths join(const std::vector<ClippedPaths>& parts) {
    std::vector<Start> starts;
    std::uint64_t piece = 0, point = 0, sample = 0;
    for (const ClippedPaths& part : parts) {
        starts.push_back({Index(piece), Index(point), Index(sample)});
        piece += part.path.size();
        point += part.px.size();
        sample += part.samples;
    }
    check(sample < none && point < none, too_many_samples);
    ClippedPaths all;
    all.pieces.offsets.resize(piece + 1);
    all.pieces.offsets[piece] = Index(point);
    all.samples = Index(sample);
    const auto resize = [](std::size_t count, auto&... arrays) { (arrays.resize(count), ...); };
    resize(piece, all.path, all.closed, all.free_ends);
    resize(point, all.px, all.depth, all.position_view, all.arc_px, all.source, all.source_t, all.facet0, all.facet1,
           all.sample_start, all.sample_count);
    parallel_blocks(parts.size(), 1, [&](std::size_t b, std::size_t, std::size_t) { append(parts[b], starts[b], all); });
    return all;
}

}  // namespace

ClippedPaths project(const Paths& paths, const Scene& scene, const View& view, const ProjectOptions& options,
                     const Cancel& cancel) {
    check(options.sample_step_px >= least_sample_step_px, "sample_step_px must be at least a thousandth");
    std::vector<ClippedPaths> parts((paths.count() + paths_per_block - 1) / paths_per_block);
    parallel_blocks(paths.count(), paths_per_block, [&](std::size_t b, std::size_t begin, std::size_t end) {
        cancel.poll();
        Projector projector(paths, scene, view, options);
        projector.reserve(end - begin, paths.rows.offsets[end] - paths.rows.offsets[begin]);
        for (std::size_t p = begin; p < end; ++p) projector.add(static_cast<Index>(p));
        parts[b] = std::move(projector.out);
    });
    return join(parts);
}

}  // namespace fovea
