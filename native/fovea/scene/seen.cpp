// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/scene/seen.h>

#include <algorithm>

namespace fovea::scene {
Array<float> holdout_image(const Tracer& tracer, const Cancel& cancel) {
    const auto& placements = tracer.scene().placements;
    if (std::none_of(placements.begin(), placements.end(), [](const Placement& p) { return p.usage & usage_holdout; }))
        return {};
    tracer.check_current();
    const auto cut_at = [&](const dvec2& px) {
        // A rotated grid: no two samples share a row or a column.
        static constexpr double offsets[4][2] = {{-0.125, -0.375}, {0.375, -0.125}, {0.125, 0.375}, {-0.375, 0.125}};
        int cut = 0;
        for (const auto& offset : offsets) {
            const auto hit = tracer.seen(px + dvec2(offset[0], offset[1]));
            cut += hit && (placements[hit->placement].usage & usage_holdout);
        }
        return static_cast<float>(cut) / 4.0f;
    };
    const View& view = tracer.view();
    Array<float> image(std::size_t(view.width) * view.height);
    parallel_for(view.height, 1, [&](std::size_t y) {
        cancel.poll();
        for (int x = 0; x < view.width; ++x) image[y * view.width + x] = cut_at(dvec2(x + 0.5, y + 0.5));
    });
    return image;
}

}  // namespace fovea::scene
