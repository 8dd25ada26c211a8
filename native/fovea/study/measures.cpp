// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/study/measures.h>

#include <algorithm>
#include <numeric>

#include <fovea/base/check.h>
#include <fovea/base/parallel.h>
#include <fovea/study/nearest_pixel.h>

namespace fovea::study {
namespace {

/// Of the pixels of `of`, in ascending order.
Array<float> sorted_distances(const Bitmap& of, const Array<float>& distances) {
    Array<float> found = values_where(distances, [&](std::size_t i) { return of.set[i] != 0; });
    std::ranges::sort(found);
    return found;
}

double share_within(const Array<float>& sorted, double distance, double of_none) {
    if (sorted.empty()) return of_none;
    return double(std::ranges::upper_bound(sorted, distance) - sorted.begin()) / double(sorted.size());
}

Distances distances_of(const Array<float>& sorted) {
    if (sorted.empty()) return {};
    const auto at = [&](double share) { return double(sorted[std::size_t(share * double(sorted.size() - 1) + 0.5)]); };
    return {std::accumulate(sorted.begin(), sorted.end(), 0.0) / double(sorted.size()), at(0.5), at(0.95)};
}

double iou(const Array<float>& to_a, const Array<float>& to_b, double tolerance) {
    std::size_t both = 0, any = 0;
    for (std::size_t i = 0; i < to_a.size(); ++i) {
        const bool a = to_a[i] <= tolerance, b = to_b[i] <= tolerance;
        both += a && b;
        any += a || b;
    }
    return any ? double(both) / double(any) : 1.0;
}

}  // namespace

Nearness::Nearness(const Bitmap& a, const Bitmap& b) {
    a.check_size_of(b);
    parallel_invoke([&] { to_a_ = distances_to(a); }, [&] { to_b_ = distances_to(b); });
    parallel_invoke([&] { of_a_ = sorted_distances(a, to_b_); }, [&] { of_b_ = sorted_distances(b, to_a_); });
}

Measures Nearness::at(double tolerance) const {
    check(tolerance >= 0.0, "tolerance: it is below 0");
    const Distances from_a = distances_of(of_a_), from_b = distances_of(of_b_);
    Measures found;
    found.precision = share_within(of_a_, tolerance, 1.0);
    found.recall = share_within(of_b_, tolerance, 1.0);
    const double sum = found.precision + found.recall;
    found.f1 = sum > 0.0 ? 2.0 * found.precision * found.recall / sum : 0.0;
    found.chamfer_px = 0.5 * (from_a.mean + from_b.mean);
    found.iou = iou(to_a_, to_b_, tolerance);
    found.mean_to_b_px = from_a.mean, found.median_to_b_px = from_a.median, found.most_to_b_px = from_a.most;
    found.mean_to_a_px = from_b.mean, found.median_to_a_px = from_b.median, found.most_to_a_px = from_b.most;
    found.pixels_a = of_a_.size(), found.pixels_b = of_b_.size();
    return found;
}

Array<double> Nearness::shares_within(const std::vector<double>& distances) const {
    Array<double> shares;
    for (const double distance : distances) {
        const double near = share_within(of_a_, distance, 0.0) * double(of_a_.size()) +
                            share_within(of_b_, distance, 0.0) * double(of_b_.size());
        shares.push_back(pixels() ? near / double(pixels()) : 1.0);
    }
    return shares;
}

}  // namespace fovea::study
