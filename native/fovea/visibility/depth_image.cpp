// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/visibility/depth_image.h>

#include <algorithm>
#include <limits>

#include <fovea/visibility/depth.h>

namespace fovea::visibility {
namespace {

/// Nearness, the compared quantity: larger is nearer. For orthographic views it is -distance: depth, measured from the
/// far plane, would lose precision near the camera.
constexpr float nothing = -std::numeric_limits<float>::infinity();

/// Depth image with hierarchical occlusion culling: triangles behind everything already drawn in a tile are skipped
/// there. This pays off in crowded scenes and changes no pixel.
class Nearest {
   public:
    explicit Nearest(const View& view)
        : width_(view.width),
          scale_(view.orthographic ? view.far_clip - view.near_clip : 1.0),
          offset_(view.orthographic ? -view.far_clip : 0.0),
          across_((view.width + side - 1) / side),
          image_(std::size_t(view.width) * view.height),
          tiles_(std::size_t(across_) * ((view.height + side - 1) / side)) {
        parallel_for(view.height, 16, [&](std::size_t y) { std::fill_n(row(int(y)), width_, nothing); });
    }

    /// Rasterizes rows y0 to y1 (excluded), which lie in one row of tiles.
    void draw(const RasterTriangle& triangle, int y0, int y1) {
        int first = triangle.x0 / side, last = (triangle.x1 - 1) / side;
        while (first <= last && hidden(triangle, first, y0, y1)) ++first;
        while (first < last && hidden(triangle, last, y0, y1)) --last;
        if (first > last) return;
        const TriangleRows rows(triangle);
        for (int x = first; x <= last; ++x) ++tile(x, y0).drawn;
        for (int y = y0; y < y1; ++y) {
            const double depth_y = triangle.depth_y(y);
            const auto [begin, end] = rows.covered(y);
            float* const texels = row(y);
            for (int x = std::max(begin, first * side), stop = std::min(end, (last + 1) * side); x < stop; ++x)
                texels[x] = std::max(texels[x], nearness(triangle.depth(x, depth_y)));
        }
    }

    float* row(int y) { return &image_[std::size_t(y) * width_]; }
    Array<float> take() { return std::move(image_); }

   private:
    static constexpr int side = raster_band_rows;
    static constexpr int draws_between_looks = 8;

    struct Tile {
        float farthest = nothing;  ///< bound over its texels, from the last update; they can only be nearer
        int drawn = 0;             ///< triangles drawn since then
    };

    float nearness(double depth) const { return static_cast<float>(scale_ * depth + offset_); }
    Tile& tile(int x, int y) { return tiles_[std::size_t(y / side) * across_ + x]; }

    bool hidden(const RasterTriangle& triangle, int x, int y0, int y1) {
        // A plane is nearest at a corner of the tile; computed as for the texels, so that rounding is monotonic.
        const int left = std::max(x * side, triangle.x0), right = std::min((x + 1) * side, triangle.x1) - 1;
        const double depth_y = triangle.depth_y(triangle.plane.y > 0.0 ? y1 - 1 : y0);
        const float nearest = nearness(triangle.depth(triangle.plane.x > 0.0 ? right : left, depth_y));
        Tile& here = tile(x, y0);
        if (nearest > here.farthest && here.drawn >= draws_between_looks) look(here, x, y0);
        return nearest <= here.farthest;
    }

    void look(Tile& here, int x, int y) {
        const int left = x * side, right = std::min(left + side, width_), low = y / side * side;
        const int high = std::min(low + side, static_cast<int>(image_.size() / width_));
        float farthest = std::numeric_limits<float>::infinity();
        for (int v = low; v < high; ++v) {
            const float* const texels = row(v);
            for (int u = left; u < right; ++u) farthest = std::min(farthest, texels[u]);
        }
        here = {farthest, 0};
    }

    int width_;
    double scale_, offset_;
    int across_;
    Array<float> image_;
    Array<Tile> tiles_;
};

}  // namespace

Array<float> depth_image(const Tracer& tracer, const Cancel& cancel) {
    tracer.check_current();
    cancel.poll();
    const View& view = tracer.view();
    Nearest nearest(view);
    draw_triangles(raster_target(view, depth_layout(view, {.scale = 1, .margin = 0.0})),
                   depth_meshes(tracer.scene(), view, 0.0), &cancel,
                   [&](const RasterTriangle& triangle, int y0, int y1) { nearest.draw(triangle, y0, y1); });
    parallel_for(view.height, 16, [&](std::size_t y) {
        float* const row = nearest.row(int(y));
        std::transform(row, row + view.width, row, [&](float nearness) {
            if (nearness == nothing) return background_depth;
            const float distance = view.orthographic ? -nearness : static_cast<float>(view.near_clip / nearness);
            return distance >= 0.0f ? std::min(distance, background_depth) : background_depth;
        });
    });
    return nearest.take();
}

}  // namespace fovea::visibility
