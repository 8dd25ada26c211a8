// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/study/precision_recall.h>

#include <algorithm>
#include <cmath>

#include <fovea/base/parallel.h>
#include <fovea/study/nearest_pixel.h>

namespace fovea::study {
namespace {

constexpr float in_any_case = std::numeric_limits<float>::infinity();
constexpr float never = -1.0f;
constexpr int parts_of_area = 500;

double share(std::size_t of, std::size_t all) { return all ? double(of) / double(all) : 1.0; }

}  // namespace

Array<Index> pixels_in(const Bitmap& bitmap) {
    return parallel_where(bitmap.set.size(), [&](Index i) { return bitmap.set[i] != 0; });
}

Array<float> most_near(const Strengths& strengths, In<Index> pixels, double distance) {
    const int reach = int(std::floor(distance));
    return parallel_map<float>(pixels.size(), [&](std::size_t p) {
        const int width = strengths.width, x = int(pixels[p] % Index(width)), y = int(pixels[p] / Index(width));
        float most = never;
        for (int dy = std::max(-reach, -y); dy <= std::min(reach, strengths.height - 1 - y); ++dy) {
            const int half = int(std::floor(std::sqrt(distance * distance - double(dy) * dy)));
            const auto row = strengths.values.begin() + std::ptrdiff_t(y + dy) * width;
            const auto first = row + std::max(0, x - half), last = row + std::min(width, x + half + 1);
            most = std::max(most, *std::max_element(first, last));
        }
        return most;
    });
}

Bitmap Strengths::above(float threshold) const {
    Bitmap bitmap(width, height);
    for (std::size_t i = 0; i < values.size(); ++i) bitmap.set[i] = values[i] >= 0.0f && values[i] >= threshold;
    return bitmap;
}

int PrecisionRecall::best_at(double precision_wanted) const {
    int best = -1;
    for (std::size_t i = 0; i < recall.size(); ++i)
        if (precision[i] >= precision_wanted && (best < 0 || recall[i] > recall[std::size_t(best)])) best = int(i);
    return best;
}

double PrecisionRecall::recall_at(double precision_wanted) const {
    if (const int best = best_at(precision_wanted); best >= 0) return recall[std::size_t(best)];
    const auto highest = std::size_t(std::ranges::max_element(precision) - precision.begin());
    return recall[highest] * (1.0 - precision_wanted) / (1.0 - precision[highest]);
}

double PrecisionRecall::area() const {
    double sum = 0.0;
    for (int i = 0; i < parts_of_area; ++i) sum += recall_at(0.5 + 0.5 * (i + 0.5) / parts_of_area);
    return sum / parts_of_area;
}

PrecisionRecall precision_recall(const Strengths& given, const Bitmap& always, const Bitmap& judge, double tolerance) {
    always.check_size_of(judge);
    always.check_size_of({given.width, given.height});
    Strengths strengths = given;
    for (std::size_t i = 0; i < always.set.size(); ++i)
        if (always.set[i]) strengths.values[i] = in_any_case;
    const Array<float> to_judge = distances_to(judge);
    struct Drawn {
        float strength;
        bool is_near;
    };
    std::vector<Drawn> drawn;
    for (std::size_t i = 0; i < to_judge.size(); ++i)
        if (strengths.values[i] >= 0.0f) drawn.push_back({strengths.values[i], to_judge[i] <= tolerance});
    std::ranges::sort(drawn, std::greater(), &Drawn::strength);
    Array<float> found = most_near(strengths, pixels_in(judge), tolerance);
    std::ranges::sort(found, std::greater());
    PrecisionRecall curve;
    std::size_t count = 0, near = 0, recalled = 0;
    for (float threshold = in_any_case;;) {
        for (; count < drawn.size() && drawn[count].strength >= threshold; ++count) near += drawn[count].is_near;
        while (recalled < found.size() && found[recalled] >= threshold) ++recalled;
        curve.threshold.push_back(threshold);
        curve.precision.push_back(share(near, count));
        curve.recall.push_back(share(recalled, found.size()));
        if (count == drawn.size()) return curve;
        threshold = drawn[count].strength;
    }
}

}  // namespace fovea::study
