// SPDX-License-Identifier: GPL-3.0-or-later
// Values at the atlas samples of clipped paths.
#pragma once

#include <fovea/base/parallel.h>
#include <fovea/project/clipped_paths.h>

namespace fovea::focus {

/// Position of an atlas sample: on the segment from `point` of ClippedPaths to the next, at these fractions of it on
/// the screen and in space.
struct SamplePlace {
    Index sample, point;
    float on_screen, in_space;
};

/// Evaluates value(SamplePlace) at every atlas sample, in parallel.
template <typename Value>
auto at_samples(const ClippedPaths& clipped, const Value& value) {
    Array<decltype(value(SamplePlace()))> values(clipped.samples);
    parallel_blocks(clipped.px.size(), 4096, [&](std::size_t, std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const Index count = clipped.sample_count[i];
            if (count == 0) continue;
            const bool flat = clipped.orthographic;
            const float wa = flat ? 1.0f : -clipped.position_view[i].z;
            const float wb = flat ? 1.0f : -clipped.position_view[i + 1].z;
            for (Index j = 0; j < count; ++j) {
                const float s = (float(j) + 0.5f) / float(count), t = s * wa / (wb + s * (wa - wb));
                const Index sample = clipped.sample_start[i] + j;
                values[sample] = value(SamplePlace{sample, Index(i), s, t});
            }
        }
    });
    return values;
}

inline vec2 px_at(const ClippedPaths& clipped, const SamplePlace& at) {
    return glm::mix(clipped.px[at.point], clipped.px[at.point + 1], at.on_screen);
}

inline vec3 position_at(const ClippedPaths& clipped, const SamplePlace& at) {
    return glm::mix(clipped.position_view[at.point], clipped.position_view[at.point + 1], at.in_space);
}

}  // namespace fovea::focus
