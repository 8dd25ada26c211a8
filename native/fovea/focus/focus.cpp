// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/focus/focus.h>

#include <algorithm>
#include <cmath>

#include <fovea/base/check.h>
#include <fovea/base/parallel.h>
#include <fovea/focus/at_samples.h>
#include <fovea/focus/from_surfaces.h>

namespace fovea::focus {
namespace {

constexpr std::size_t rows_per_block = 8;

/// 0 up to `near`, 1 from `far` on, linear between; near == far is a step. NaN: 1.
float between(float distance, float near, float far) {
    if (distance <= near) return 0.0f;
    return distance < far ? (distance - near) / (far - near) : 1.0f;
}

}  // namespace

float Focus::operator()(vec2 px, vec3 position_view) const {
    if (points.empty()) return 0.0f;
    const bool in_image = space == FocusSpace::image;
    float least = 1.0f, in_focus = 0.0f;
    for (const FocusPoint& point : points) {
        const float away = in_image ? glm::distance(px, vec2(point.at)) : point.distance(position_view);
        const float f = between(away, point.near, point.far);
        least = std::min(least, f);
        in_focus += 1.0f - f;
    }
    return sum ? 1.0f - std::min(in_focus, 1.0f) : least;
}

bool Focus::of_surfaces() const {
    return std::ranges::any_of(points, [](const FocusPoint& point) { return point.surface != nullptr; });
}

float Focus::steepness() const {
    float most = 0.0f, all = 0.0f;
    for (const FocusPoint& point : points) {
        const float own = 1.0f / (point.far - point.near);
        most = std::max(most, own);
        all += own;
    }
    return sum ? all : most;
}

Array<float> focus_of_samples(const ClippedPaths& clipped, const Focus& focus) {
    if (focus.points.empty()) return Array<float>(clipped.samples, 0.0f);
    if (focus.of_surfaces()) return focus_along_pieces(clipped, focus);
    return at_samples(clipped,
                      [&](const SamplePlace& at) { return focus(px_at(clipped, at), position_at(clipped, at)); });
}

Array<float> values_of_samples(const ClippedPaths& clipped, In<float> values) {
    const auto last = std::ranges::max_element(clipped.source);
    check(last == clipped.source.end() || *last < values.size(), "values: one per point of the paths expected");
    return at_samples(clipped, [&](const SamplePlace& at) {
        return glm::mix(clipped.at_point(values, at.point), clipped.at_point(values, at.point + 1), at.in_space);
    });
}

Array<float> focus_of_pixels(const View& view, In<float> distance, const Focus& focus) {
    check(distance.size() == std::size_t(view.width) * view.height, "distance: one value per pixel expected");
    if (focus.of_surfaces()) return focus_between_pixels(view, distance, focus);
    Array<float> f(distance.size());
    const dmat4 clip_to_view = glm::inverse(view.view_to_clip);
    parallel_blocks(view.height, rows_per_block, [&](std::size_t, std::size_t first, std::size_t last) {
        for (std::size_t y = first; y < last; ++y)
            for (int x = 0; x < view.width; ++x) {
                const std::size_t i = y * view.width + x;
                const vec2 px(x + 0.5f, y + 0.5f);
                const bool in_scene = focus.space == FocusSpace::scene;
                // Background: from_pixels would give NaN (infinity times 0).
                const bool nothing = in_scene && !std::isfinite(distance[i]);
                const vec3 place =
                    in_scene && !nothing ? vec3(from_pixels(view, clip_to_view, px, distance[i])) : vec3(0.0f);
                f[i] = nothing && !focus.points.empty() ? 1.0f : focus(px, place);
            }
    });
    return f;
}

Array<float> distance_of_samples(const ClippedPaths& clipped, float near, float far) {
    return at_samples(clipped, [&](const SamplePlace& at) { return between(-position_at(clipped, at).z, near, far); });
}

}  // namespace fovea::focus
