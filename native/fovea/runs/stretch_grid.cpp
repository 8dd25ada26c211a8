// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/runs/stretch_grid.h>

#include <atomic>
#include <cmath>

#include <fovea/base/check.h>
#include <fovea/base/parallel.h>

namespace fovea::runs {

StretchGrid::StretchGrid(Array<Stretch>&& stretches) : stretches_(std::move(stretches)) {
    constexpr double least_px = 0.5, most_px = 64.0;
    dvec2 low(1e30), high(-1e30);
    for (const Stretch& stretch : stretches_) {
        low = glm::min(low, dvec2(glm::min(stretch.a, stretch.b)));
        high = glm::max(high, dvec2(glm::max(stretch.a, stretch.b)));
    }
    if (stretches_.empty()) low = high = dvec2(0.0);
    low_ = low;
    const dvec2 extent = high - low;
    size_ = std::clamp(std::sqrt(extent.x * extent.y / std::max<double>(stretches_.size(), 1.0)), least_px, most_px);
    width_ = static_cast<int>(extent.x / size_) + 1;
    height_ = static_cast<int>(extent.y / size_) + 1;

    // Parallel counting sort: only the order within a cell depends on the threads.
    starts_.assign(std::size_t(width_) * height_, 0);
    parallel_for(stretches_.size(), [&](std::size_t i) {
        cells(stretches_[i].a, stretches_[i].b,
              [&](std::size_t cell) { std::atomic_ref(starts_[cell]).fetch_add(1, std::memory_order_relaxed); });
    });
    std::uint64_t total = 0;
    for (Index count : starts_) total += count;
    check(total < none, "halo: too many visible segments");
    counts_to_offsets(starts_);
    entries_.resize(total);
    std::vector<Index> next(starts_.begin(), starts_.end() - 1);
    parallel_for(stretches_.size(), [&](std::size_t i) {
        cells(stretches_[i].a, stretches_[i].b, [&](std::size_t cell) {
            entries_[std::atomic_ref(next[cell]).fetch_add(1, std::memory_order_relaxed)] = static_cast<Index>(i);
        });
    });
}

}  // namespace fovea::runs
