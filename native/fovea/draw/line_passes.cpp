// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/draw/line_passes.h>

#include <algorithm>
#include <bit>
#include <optional>

#include <fovea/draw/cryptomatte.h>
#include <fovea/draw/line_motion.h>
#include <fovea/draw/spine_tiles.h>
#include <fovea/stroke/along.h>
#include <fovea/stroke/fragments.h>
#include <fovea/stroke/noise.h>
#include <fovea/stroke/shares.h>
#include <fovea/visibility/depth_image.h>

namespace fovea::draw {
namespace {

template <typename T>
Array<T> filled(const View& view, T value) {
    Array<T> image(std::size_t(view.width) * view.height);
    parallel_for(image.size(), [&](std::size_t i) { image[i] = value; });
    return image;
}

class LinePainter {
   public:
    explicit LinePainter(const Frame& frame) : frame_(frame) {
        const Options& options = frame.job.options;
        const View& view = frame.job.view;
        if (options.with_hidden) passes_.hidden = filled(view, vec4(0.0f));
        if (options.with_line_sets) add_line_sets();
        if (options.with_line_depth || options.with_line_vector) passes_.depth = filled(view, background_depth);
        if (options.with_line_vector) {
            passes_.vector = filled(view, vec4(0.0f));
            motion_.emplace(frame);
        }
        if (options.with_line_id) passes_.id = filled(view, 0.0f);
        for (int rank = 0; rank < options.matte_ranks; rank += 2) passes_.mattes.push_back(filled(view, vec4(0.0f)));
        if (options.with_line_id)
            lines_ = parallel_map<std::uint32_t>(frame.paths->count(), [&](std::size_t p) {
                return std::max<std::uint32_t>(std::uint32_t(mixed(frame.paths->id[p]) >> 40), 1);
            });
        if (options.matte_ranks > 0) find_objects();
    }

    void draw(const SpineTest* spine) {
        const Fragments fragments(*frame_.strokes, frame_.pens.pens, frame_.pens.textures, spine);
        const View& view = frame_.job.view;
        for_each_tile(frame_.strokes->px, frame_.strokes->triangles, view.width, view.height,
                      [&](const PixelBox& box, In<Index> triangles) { tile(fragments, box, triangles); });
    }

    LinePasses take() {
        if (!frame_.job.options.with_line_depth) passes_.depth = {};
        return std::move(passes_);
    }

   private:
    std::size_t at(int x, int y) const { return std::size_t(y) * frame_.job.view.width + x; }

    /// An image per name, and the image of each line set's pen.
    void add_line_sets() {
        for (const style::LineSet& set : frame_.job.style.line_sets) {
            auto& sets = passes_.line_sets;
            auto found = std::ranges::find(sets, set.name, [](const auto& named) { return named.first; });
            image_of_set_.push_back(Index(found - sets.begin()));
            if (found == sets.end()) sets.emplace_back(set.name, filled(frame_.job.view, vec4(0.0f)));
        }
    }

    /// Ids of objects by path; 0: nobody's.
    void find_objects() {
        const Overrides& overrides = frame_.job.overrides;
        Array<std::uint32_t> ids;
        for (const std::string& name : overrides.names) ids.push_back(cryptomatte_id(name));
        objects_ = parallel_map<std::uint32_t>(frame_.paths->count(), [&](std::size_t p) {
            const Index placement = frame_.paths->placement[p];
            return placement == none || ids.empty() ? 0 : ids[overrides.objects_of_placement[placement]];
        });
    }

    /// The image of the strokes of a pen; null: of none that is requested. The first pens are those of the line sets.
    Array<vec4>* image_of(Index pen) {
        if (pen >= frame_.job.style.line_sets.size()) return passes_.hidden.empty() ? nullptr : &passes_.hidden;
        return image_of_set_.empty() ? nullptr : &passes_.line_sets[image_of_set_[pen]].second;
    }

    void tile(const Fragments& fragments, const PixelBox& box, In<Index> triangles) {
        if (triangles.empty()) return;
        Shares of_lines(box), of_objects(box);
        const Strokes& strokes = *frame_.strokes;
        fragments.each(triangles, box, [&](int x, int y, const Fragment& f) {
            if (f.alpha <= 0.0f) return;
            const Index piece = strokes.piece[f.vertex], path = frame_.clipped->path[piece];
            if (Array<vec4>* image = image_of(strokes.pen[f.vertex]))
                (*image)[at(x, y)] = over((*image)[at(x, y)], f.color, f.alpha);
            if (!passes_.depth.empty()) put_nearest(piece, f.arc, at(x, y));
            if (!lines_.empty()) of_lines.add(x, y, lines_[path], f.alpha);
            if (!objects_.empty()) of_objects.add(x, y, objects_[path], f.alpha);
        });
        std::vector<Share> ranked;
        for (int y = box.y0; y < box.y1; ++y)
            for (int x = box.x0; x < box.x1; ++x) {
                if (!lines_.empty()) put_line(of_lines, x, y, ranked);
                if (!objects_.empty()) put_objects(of_objects, x, y, ranked);
            }
    }

    void put_nearest(Index piece, double arc, std::size_t pixel) {
        const float distance = float(distance_at(*frame_.clipped, piece, arc));
        if (!(distance < passes_.depth[pixel])) return;
        passes_.depth[pixel] = distance;
        if (motion_) passes_.vector[pixel] = motion_->at(piece, arc);
    }

    void put_line(const Shares& shares, int x, int y, std::vector<Share>& ranked) {
        shares.ranked(x, y, ranked);
        if (!ranked.empty()) passes_.id[at(x, y)] = float(ranked.front().id);
    }

    void put_objects(const Shares& shares, int x, int y, std::vector<Share>& ranked) {
        shares.ranked(x, y, ranked);
        const std::size_t ranks = std::min(ranked.size(), std::size_t(frame_.job.options.matte_ranks));
        for (std::size_t rank = 0; rank < ranks; ++rank) {
            vec4& pixel = passes_.mattes[rank / 2][at(x, y)];
            pixel[rank % 2 * 2] = std::bit_cast<float>(ranked[rank].id);
            pixel[rank % 2 * 2 + 1] = ranked[rank].share;
        }
    }

    const Frame& frame_;
    LinePasses passes_;
    std::optional<LineMotion> motion_;  // none: it is not requested
    std::vector<Index> image_of_set_;
    Array<std::uint32_t> lines_, objects_;  // ids by path; empty: not requested
};

}  // namespace

bool wants_line_passes(const Options& o) {
    return o.with_hidden || o.with_line_sets || o.with_line_depth || o.with_line_vector || o.with_line_id ||
           o.matte_ranks > 0;
}

LinePasses line_passes(const Frame& frame) {
    LinePainter painter(frame);
    each_spine_tile(frame, CpuBackend().most_side, [&](const SpineTest* spine) { painter.draw(spine); });
    return painter.take();
}

}  // namespace fovea::draw
