// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/visibility/depth_image.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <utility>

#include <fovea/base/four.h>
#include <fovea/visibility/depth.h>

namespace fovea::visibility {
namespace {

/// Nearness of each texel: larger is nearer. For perspective views it is the depth, and 0 where there is nothing; for
/// orthographic ones -distance, as depth, measured from the far plane, would lose precision near the camera. With
/// hierarchical occlusion culling: triangles behind everything already drawn in a tile are skipped there. This pays off
/// in crowded scenes and changes no pixel.
class Nearest {
   public:
    explicit Nearest(const View& view)
        : width_(view.width),
          scale_(view.orthographic ? view.far_clip - view.near_clip : 1.0),
          offset_(view.orthographic ? -view.far_clip : 0.0),
          nothing_(view.orthographic ? -infinity : 0.0f),
          across_((view.width + side - 1) / side),
          image_(std::size_t(view.width) * view.height),
          tiles_(std::size_t(across_) * ((view.height + side - 1) / side)) {
        parallel_for(view.height, 16, [&](std::size_t y) { std::fill_n(row(int(y)), width_, nothing_); });
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

    /// Draws a triangle of few texels; of several threads' the nearest stays.
    void draw_few(const RasterTriangle& triangle) {
        unsigned bits = triangle.few;
        for (int y = triangle.y0; bits; ++y) {
            const double depth_y = triangle.depth_y(y);
            for (int x = triangle.x0; x < triangle.x1; ++x, bits >>= 1) {
                if (!(bits & 1u)) continue;
                const std::atomic_ref<float> texel(row(y)[x]);
                const float here = nearness(triangle.depth(x, depth_y));
                for (float there = texel.load(std::memory_order_relaxed);
                     here > there && !texel.compare_exchange_weak(there, here, std::memory_order_relaxed););
            }
        }
    }

    float* row(int y) { return &image_[std::size_t(y) * width_]; }
    Array<float> take() { return std::move(image_); }

   private:
    static constexpr int side = raster_band_rows;
    static constexpr int draws_between_looks = 8;

    struct Tile {
        float farthest = -infinity;  ///< bound over its texels, from the last update; they can only be nearer
        int drawn = 0;               ///< triangles drawn since then
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
        float farthest = infinity;
        Four of_lanes = four(infinity);
        for (int v = low; v < high; ++v) {
            const float* const texels = row(v);
            int u = left;
            for (; u + 4 <= right; u += 4) {
                Four next;
                std::memcpy(&next, texels + u, sizeof(next));
                of_lanes = lesser(of_lanes, next);
            }
            for (; u < right; ++u) farthest = std::min(farthest, texels[u]);
        }
        for (int lane = 0; lane < 4; ++lane) farthest = std::min(farthest, of_lanes[lane]);
        here = {farthest, 0};
    }

    int width_;
    double scale_, offset_;
    float nothing_;
    int across_;
    Array<float> image_;
    Array<Tile> tiles_;
};

/// Triangles of the occluders, roughly from near to far: so those that are hidden are found before they are drawn.
std::vector<RasterMesh> from_near_to_far(const Scene& scene, const View& view) {
    const std::vector<Occluder> found = occluders(scene, view, 0.0);
    Array<std::pair<double, Index>> order(found.size());
    parallel_for(found.size(), [&](std::size_t i) {
        const Sphere sphere = bounding_sphere(scene.placements[found[i].placement], view);
        const double nearest = -sphere.center.z - sphere.radius;
        order[i] = {std::isfinite(nearest) ? nearest : 0.0, Index(i)};
    });
    parallel_sort(order.begin(), order.end());
    std::vector<Occluder> sorted;
    for (const auto& [nearest, i] : order) sorted.push_back(found[i]);
    return depth_meshes(scene, sorted);
}

}  // namespace

Array<float> depth_image(const Tracer& tracer, const Cancel& cancel) {
    tracer.check_current();
    cancel.poll();
    const View& view = tracer.view();
    Nearest nearest(view);
    draw_triangles(
        raster_target(view, depth_layout(view, {.scale = 1, .margin = 0.0})), from_near_to_far(tracer.scene(), view),
        &cancel, [&](const RasterTriangle& triangle, int y0, int y1) { nearest.draw(triangle, y0, y1); },
        [&](const RasterTriangle& triangle) { nearest.draw_few(triangle); });
    parallel_for(view.height, 16, [&](std::size_t y) {
        float* const row = nearest.row(int(y));
        const auto each = [&](const auto& distance) { std::transform(row, row + view.width, row, distance); };
        if (view.orthographic)
            each([](float nearness) {
                return nearness <= 0.0f ? std::min(-nearness, background_depth) : background_depth;
            });
        else
            each([near = view.near_clip](float nearness) {
                return std::min(static_cast<float>(near / nearness), background_depth);
            });
    });
    return nearest.take();
}

}  // namespace fovea::visibility
