#include "atlas/depth_image.h"

#include <algorithm>
#include <limits>

#include "atlas/depth_triangles.h"

namespace fovea {

Array<float> depth_image(const Tracer& tracer, const Cancel& cancel) {
    tracer.check_current();
    cancel.poll();
    const View& view = tracer.view();
    // Nearness as it is compared: larger is nearer. Of an orthographic view it is -distance: depth, which counts from the
    // far plane, would lose what lies near.
    constexpr float nothing = -std::numeric_limits<float>::infinity();
    const double range = view.far_clip - view.near_clip;
    const double scale = view.orthographic ? range : 1.0, offset = view.orthographic ? -view.far_clip : 0.0;
    Array<float> image(std::size_t(view.width) * view.height);
    const auto each_row = [&](const auto& body) {
        parallel_for(view.height, [&](std::size_t y) { body(image.begin() + y * view.width, view.width); }, 16);
    };
    each_row([&](auto row, int count) { std::fill_n(row, count, nothing); });
    const auto draw = [&](const DepthTriangle& triangle, int y0, int y1) {
        for (int y = y0; y < y1; ++y) {
            float* row = &image[std::size_t(y) * view.width];
            const auto nearness = [&](double depth) { return static_cast<float>(scale * depth + offset); };
            const auto in_front = [&](int x, double depth) { return nearness(depth) > row[x]; };
            each_texel(triangle, y, in_front, [&](int x, double depth) { row[x] = nearness(depth); });
        }
    };
    const DepthBuffer layout = depth_layout(view, {.scale = 1, .margin = 0.0});
    draw_triangles(layout, view, depth_meshes(tracer.scene(), view, 0.0), &cancel, draw);
    each_row([&](auto row, int count) {
        std::transform(row, row + count, row, [&](float nearness) {
            if (nearness == nothing) return background_depth;
            const float distance = view.orthographic ? -nearness : static_cast<float>(view.near_clip / nearness);
            return distance >= 0.0f ? std::min(distance, background_depth) : background_depth;
        });
    });
    return image;
}

}  // namespace fovea
