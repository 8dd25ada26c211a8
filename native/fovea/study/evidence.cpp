// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/study/evidence.h>

#include <algorithm>

#include <fovea/base/check.h>
#include <fovea/base/parallel.h>
#include <fovea/study/nearest_pixel.h>

namespace fovea::study {
namespace {

constexpr double beside = 1.5;  // [px] between lines that are drawn twice
constexpr std::size_t block_folds = 5;
constexpr int blocks_along = 10;  // the longer side

Array<float> distinct(const std::vector<Judging>& drawings, std::size_t d) {
    Array<float> values;
    for (std::size_t k = 0; k < drawings.size(); ++k) {
        const bool known = k && drawings[k].definitions[d] == drawings[k - 1].definitions[d];
        if (known) continue;
        for (const float value : drawings[k].definitions[d]->values)
            if (value >= 0.0f) values.push_back(value);
    }
    parallel_sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

void append_levels(Array<Level>& levels, const Array<float>& strengths, const Array<float>& ascending) {
    const Array<Level> more = parallel_map<Level>(strengths.size(), [&](std::size_t i) {
        return strengths[i] < 0.0f ? Level(0) : level_from(ascending, strengths[i]);
    });
    levels.insert(levels.end(), more.begin(), more.end());
}

/// Which part each pixel of a picture belongs to: neighbors to the right or above to others.
struct Folds {
    int width;
    int side;

    explicit Folds(const Bitmap& drawing)
        : width(drawing.width), side(std::max(1, (std::max(drawing.width, drawing.height) - 1) / blocks_along + 1)) {}

    std::uint32_t of(Index pixel) const {
        const Index x = pixel % Index(width) / Index(side), y = pixel / Index(width) / Index(side);
        return std::uint32_t((x + 2 * y) % block_folds);
    }
};

/// Appends what one drawing tells. `only`: it is the only one.
void append(Evidence& all, const Judging& one, std::uint32_t number, bool only, double tolerance) {
    const Bitmap& judge = *one.judge;
    const Folds folds(judge);
    const Array<float> to_judge = distances_to(judge);
    Array<Index> pixels;
    const std::size_t before = all.owner.size();
    for (std::size_t d = 0; d < all.definitions; ++d) {
        judge.check_size_of({one.definitions[d]->width, one.definitions[d]->height});
        for (std::size_t i = 0; i < to_judge.size(); ++i) {
            if (one.definitions[d]->values[i] < 0.0f) continue;
            pixels.push_back(Index(i));
            all.owner.push_back(std::uint32_t(d));
            all.is_near.push_back(to_judge[i] <= tolerance);
            all.fold.push_back(only ? folds.of(Index(i)) : number);
        }
    }
    const Array<Index> of_judge = pixels_in(judge);
    all.judged += of_judge.size();
    for (const Index i : of_judge) all.judge_fold.push_back(only ? folds.of(i) : number);
    for (std::size_t d = 0; d < all.definitions; ++d) {
        const Strengths& strengths = *one.definitions[d];
        Array<float> here = most_near(strengths, pixels, beside);
        for (std::size_t i = 0; i < pixels.size(); ++i)
            if (all.owner[before + i] == d) here[i] = strengths.values[pixels[i]];
        append_levels(all.drawn[d], here, all.strengths[d]);
        append_levels(all.reached[d], most_near(strengths, of_judge, tolerance), all.strengths[d]);
    }
}

/// Those of the values whose part is kept.
template <typename T>
Array<T> kept(const Array<T>& values, const Array<std::uint32_t>& fold, std::size_t number, bool held_out) {
    Array<T> some;
    for (std::size_t i = 0; i < values.size(); ++i)
        if ((fold[i] == number) == held_out) some.push_back(values[i]);
    return some;
}

}  // namespace

Level level_from(const Array<float>& ascending, float threshold) {
    return Level(std::ranges::lower_bound(ascending, threshold) - ascending.begin()) + 1;
}

Evidence evidence_of(const std::vector<Judging>& drawings, double tolerance) {
    check(!drawings.empty(), "a fit needs a drawing");
    Evidence all;
    all.definitions = drawings[0].definitions.size();
    for (const Judging& one : drawings)
        check(one.definitions.size() == all.definitions, "a fit: the same definitions expected for each drawing");
    for (std::size_t d = 0; d < all.definitions; ++d) all.strengths.push_back(distinct(drawings, d));
    all.drawn.resize(all.definitions);
    all.reached.resize(all.definitions);
    const bool only = drawings.size() == 1;
    all.folds = only ? block_folds : drawings.size();
    for (std::size_t k = 0; k < drawings.size(); ++k) append(all, drawings[k], std::uint32_t(k), only, tolerance);
    return all;
}

Evidence Evidence::part(std::size_t number, bool held_out) const {
    Evidence some;
    some.definitions = definitions;
    some.strengths = strengths;
    some.owner = kept(owner, fold, number, held_out);
    some.is_near = kept(is_near, fold, number, held_out);
    some.fold = kept(fold, fold, number, held_out);
    some.judge_fold = kept(judge_fold, judge_fold, number, held_out);
    some.judged = some.judge_fold.size();
    some.folds = folds;
    for (std::size_t d = 0; d < definitions; ++d) {
        some.drawn.push_back(kept(drawn[d], fold, number, held_out));
        some.reached.push_back(kept(reached[d], judge_fold, number, held_out));
    }
    return some;
}

}  // namespace fovea::study
