#include "focus/focus.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "base/parallel.h"

namespace fovea {
namespace {

constexpr std::size_t rows_per_block = 8, points_per_block = 4096;

/// 0 up to `near`, 1 from `far` on; equal: a step there. What is no number is far.
float between(float distance, float near, float far) {
    if (distance <= near) return 0.0f;
    return distance < far ? (distance - near) / (far - near) : 1.0f;
}

/// Calls out(sample, px, view-space position) for every atlas sample.
template <typename Out>
void each_sample(const ClippedPaths& clipped, const Out& out) {
    parallel_blocks(clipped.px.size(), points_per_block, [&](std::size_t, std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const Index count = clipped.sample_count[i];
            if (count == 0) continue;
            const vec3 a = clipped.position_view[i], b = clipped.position_view[i + 1];
            const bool flat = clipped.orthographic;
            const float wa = flat ? 1.0f : -a.z, wb = flat ? 1.0f : -b.z;
            for (Index j = 0; j < count; ++j) {
                const float s = (float(j) + 0.5f) / float(count), t = s * wa / (wb + s * (wa - wb));
                out(clipped.sample_start[i] + j, glm::mix(clipped.px[i], clipped.px[i + 1], s), glm::mix(a, b, t));
            }
        }
    });
}

}  // namespace

float Focus::operator()(vec2 px, vec3 position_view) const {
    if (points.empty()) return 0.0f;
    const vec3 here = space == FocusSpace::image ? vec3(px, 0.0f) : position_view;
    float least = 1.0f, in_focus = 0.0f;
    for (const FocusPoint& point : points) {
        const vec3 at = space == FocusSpace::image ? vec3(vec2(point.at), 0.0f) : point.at;
        const float f = between(glm::distance(here, at), point.near, point.far);
        least = std::min(least, f);
        in_focus += 1.0f - f;
    }
    return sum ? 1.0f - std::min(in_focus, 1.0f) : least;
}

Array<float> focus_of_samples(const ClippedPaths& clipped, const Focus& focus) {
    Array<float> f(clipped.samples, 0.0f);
    if (!focus.points.empty())
        each_sample(clipped, [&](Index sample, vec2 px, vec3 position) { f[sample] = focus(px, position); });
    return f;
}

Array<float> focus_of_pixels(const View& view, In<float> distance, const Focus& focus) {
    check(distance.size() == std::size_t(view.width) * view.height, "distance: one value per pixel expected");
    Array<float> f(distance.size());
    const dmat4 clip_to_view = glm::inverse(view.view_to_clip);
    parallel_blocks(view.height, rows_per_block, [&](std::size_t, std::size_t first, std::size_t last) {
        for (std::size_t y = first; y < last; ++y)
            for (int x = 0; x < view.width; ++x) {
                const std::size_t i = y * view.width + x;
                const vec2 px(x + 0.5f, y + 0.5f);
                const bool in_scene = focus.space == FocusSpace::scene;
                // Beyond everything: infinity times 0 is no number.
                const bool nothing = in_scene && !std::isfinite(distance[i]);
                const vec3 place = in_scene && !nothing ? vec3(from_pixels(view, clip_to_view, px, distance[i])) : vec3(0.0f);
                f[i] = nothing && !focus.points.empty() ? 1.0f : focus(px, place);
            }
    });
    return f;
}

Array<float> distance_of_samples(const ClippedPaths& clipped, float near, float far) {
    Array<float> d(clipped.samples, 0.0f);
    each_sample(clipped, [&](Index sample, vec2, vec3 position) { d[sample] = between(-position.z, near, far); });
    return d;
}

}  // namespace fovea
