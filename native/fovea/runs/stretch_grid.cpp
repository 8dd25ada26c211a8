// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/runs/stretch_grid.h>

#include <atomic>
#include <cmath>
#include <tuple>

#include <fovea/base/check.h>
#include <fovea/base/parallel.h>

namespace fovea::runs {

StretchGrid::StretchGrid(Array<Stretch>&& stretches) : stretches_(std::move(stretches)) {
    constexpr double least_px = 0.5, most_px = 64.0, most_cells = 8.0;  // of a stretch, in the mean
    dvec2 low(1e30), high(-1e30);
    double length = 0.0;
    for (const Stretch& stretch : stretches_) {
        low = glm::min(low, dvec2(glm::min(stretch.a, stretch.b)));
        high = glm::max(high, dvec2(glm::max(stretch.a, stretch.b)));
        length += glm::distance(stretch.a, stretch.b);
    }
    if (stretches_.empty()) low = high = dvec2(0.0);
    low_ = low;
    const dvec2 extent = high - low;
    const double count = std::max<double>(stretches_.size(), 1.0);
    size_ = std::max(std::sqrt(extent.x * extent.y / count), length / count / most_cells);
    size_ = std::clamp(size_, least_px, most_px);
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
    thin_crowds();
}

/// The ends of the part of a stretch in a cell, the lesser first [1/16 px from the cell's corner].
glm::ivec4 StretchGrid::within(const Stretch& stretch, std::size_t cell) const {
    constexpr double steps = 16.0;
    const dvec2 corner = low_ + size_ * dvec2(cell % width_, cell / width_), a(stretch.a), way = dvec2(stretch.b) - a;
    double from = 0.0, to = 1.0;
    for (int i = 0; i < 2; ++i) {
        if (way[i] == 0.0) continue;
        const double enter = (corner[i] - a[i]) / way[i], leave = (corner[i] + size_ - a[i]) / way[i];
        from = std::max(from, std::min(enter, leave));
        to = std::min(to, std::max(enter, leave));
    }
    const auto rounded = [&](double t) { return glm::ivec2(glm::floor((a + t * way - corner) * steps + 0.5)); };
    const glm::ivec2 start = rounded(std::min(from, to)), end = rounded(std::max(from, to));
    const bool ascends = std::tie(start.x, start.y) < std::tie(end.x, end.y);
    return ascends ? glm::ivec4(start, end) : glm::ivec4(end, start);
}

void StretchGrid::thin_crowds() {
    struct Entry {
        glm::ivec4 at;
        float distance;
        Index stretch;

        auto place() const { return std::tie(at.x, at.y, at.z, at.w); }
        auto order() const { return std::tie(at.x, at.y, at.z, at.w, distance, stretch); }
    };
    const std::size_t cells = starts_.size() - 1;
    std::vector<Index> kept(cells);
    parallel_for(cells, 16, [&](std::size_t cell) {
        const std::size_t count = starts_[cell + 1] - starts_[cell];
        kept[cell] = Index(count);
        if (count <= crowd) return;
        Index* const own = &entries_[starts_[cell]];
        std::vector<Entry> met(count);
        for (std::size_t k = 0; k < count; ++k)
            met[k] = {within(stretches_[own[k]], cell), stretches_[own[k]].distance, own[k]};
        std::ranges::sort(met, {}, [](const Entry& e) { return e.order(); });
        const auto same = [](const Entry& e, const Entry& f) { return e.place() == f.place(); };
        met.erase(std::unique(met.begin(), met.end(), same), met.end());
        std::ranges::transform(met, own, &Entry::stretch);
        kept[cell] = Index(met.size());
    });
    std::vector<Index> starts(kept);
    counts_to_offsets(starts);
    if (starts.back() == entries_.size()) return;
    std::vector<Index> entries(starts.back());
    parallel_for(cells,
                 [&](std::size_t cell) { std::copy_n(&entries_[starts_[cell]], kept[cell], &entries[starts[cell]]); });
    starts_ = std::move(starts);
    entries_ = std::move(entries);
}

}  // namespace fovea::runs
