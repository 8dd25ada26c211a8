// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/study/fit.h>

#include <algorithm>
#include <cmath>
#include <random>

#include <fovea/base/check.h>
#include <fovea/base/parallel.h>

namespace fovea::study {
namespace {

constexpr double equal = 1e-12;
constexpr std::size_t most_rounds = 100;  // a handful does, unless scores are equal but for rounding
constexpr int starts_per_fold = 2;

/// What a drawing gains by thresholds, and sums of it.
struct Sums {
    double drawn = 0.0, near = 0.0, recalled = 0.0;

    void add(const Sums& other) { drawn += other.drawn, near += other.near, recalled += other.recalled; }
    double precision() const { return drawn > equal ? near / drawn : 1.0; }
    double recall(std::size_t judged) const { return judged ? recalled / double(judged) : 1.0; }
};

double f_measure(double precision, double recall, double beta) {
    const double square = beta * beta, sum = square * precision + recall;
    return sum > 0.0 ? (1.0 + square) * precision * recall / sum : 0.0;
}

/// One search: levels from which on definitions are drawn, and how many are drawn at each place.
class Search {
   public:
    Search(const Evidence& evidence, const FitOptions& options, std::vector<Level> start)
        : all(evidence),
          asked(options),
          levels(std::move(start)),
          beside_each(evidence.owner.size(), 0),
          reaching(evidence.judged, 0) {
        for (std::size_t d = 0; d < all.definitions; ++d) count(d, 1);
    }

    void run() {
        std::size_t unchanged = 0;
        for (std::size_t turn = 0; unchanged < all.definitions && turn < most_rounds * all.definitions; ++turn) {
            Cancelling::poll();
            unchanged = improve(turn % all.definitions) ? 1 : unchanged + 1;
        }
    }

    /// Of ranges of thresholds that are as good, to their middles, one after the other.
    void to_the_middle() {
        for (std::size_t d = 0; d < all.definitions; ++d)
            if (levels[d] < all.off(d)) center(d);
    }

    Sums sums() const {
        Sums sums;
        for (std::size_t i = 0; i < all.owner.size(); ++i)
            if (is_drawn(all.owner[i], i)) sums.add({share(beside_each[i]), all.is_near[i] * share(beside_each[i])});
        sums.recalled = double(std::ranges::count_if(reaching, [](auto count) { return count > 0; }));
        return sums;
    }

    Fit found() const {
        Fit fit;
        const Sums of = sums();
        for (std::size_t d = 0; d < all.definitions; ++d)
            fit.thresholds.push_back(levels[d] == all.off(d) ? no_threshold : all.strengths[d][levels[d] - 1]);
        fit.precision = of.precision(), fit.recall = of.recall(all.judged);
        fit.score =
            score(of, std::size_t(std::ranges::count_if(fit.thresholds, [](float t) { return t < no_threshold; })));
        return fit;
    }

   private:
    static double share(std::uint32_t of) { return 1.0 / double(of); }
    bool is_drawn(std::size_t d, std::size_t i) const { return all.drawn[d][i] >= levels[d]; }
    double score(const Sums& sums, std::size_t used) const {
        return f_measure(sums.precision(), sums.recall(all.judged), asked.beta) - asked.cost * double(used);
    }

    /// Adds a definition with its level to the counts, or takes it away (-1).
    void count(std::size_t d, int by) {
        for (std::size_t i = 0; i < all.owner.size(); ++i)
            if (is_drawn(d, i)) beside_each[i] += std::uint32_t(by);
        for (std::size_t i = 0; i < all.judged; ++i)
            if (all.reached[d][i] >= levels[d]) reaching[i] += std::uint32_t(by);
    }

    /// What is drawn without a definition, and what its pixels add at each of its levels.
    std::pair<Sums, std::vector<Sums>> parts(std::size_t d) const {
        Sums without;
        std::vector<Sums> at(all.off(d));
        for (std::size_t i = 0; i < all.owner.size(); ++i) {
            const double near = all.is_near[i], more = share(beside_each[i] + 1);
            const Level level = all.drawn[d][i];
            if (all.owner[i] == d) {
                at[level].add({more, near * more});
            } else if (is_drawn(all.owner[i], i)) {
                const double now = share(beside_each[i]);
                without.add({now, near * now});
                if (level > 0) at[level].add({more - now, near * (more - now)});
            }
        }
        for (std::size_t i = 0; i < all.judged; ++i) (reaching[i] ? without : at[all.reached[d][i]]).recalled += 1.0;
        return {without, std::move(at)};
    }

    /// Scores with a definition at each of its levels, the last one of which is off; all others fixed, and their costs
    /// left out.
    std::vector<double> scores(std::size_t d) const {
        const auto [without, at] = parts(d);
        std::vector<double> found(all.off(d) + 1, 0.0);
        Sums sums = without;
        found[all.off(d)] = score(sums, 0);
        for (Level level = all.off(d) - 1; level > 0; --level) {
            sums.add(at[level]);
            found[level] = score(sums, 1);
        }
        return found;
    }

    /// Puts a definition at its best level, all others fixed, of equal ones at that of the fewest lines; whether that
    /// is another one.
    bool improve(std::size_t d) {
        const Level before = levels[d];
        count(d, -1);
        const std::vector<double> found = scores(d);
        Level best = all.off(d);
        for (Level level = best - 1; level > 0; --level)
            if (found[level] > found[best] + equal) best = level;
        levels[d] = best;
        count(d, 1);
        return best != before;
    }

    /// Puts a definition in the middle of the range of levels that are as good as its own.
    void center(std::size_t d) {
        count(d, -1);
        const std::vector<double> found = scores(d);
        const double enough = found[levels[d]] - asked.slack;
        Level low = levels[d], high = low;
        while (low > 1 && found[low - 1] >= enough) --low;
        while (high + 1 < all.off(d) && found[high + 1] >= enough) ++high;
        levels[d] = middle(d, low, high);
        count(d, 1);
    }

    /// The level of the threshold next to the mean of two, by factors.
    Level middle(std::size_t d, Level low, Level high) const {
        const Array<float>& strengths = all.strengths[d];
        const double wanted = std::sqrt(double(strengths[low - 1]) * double(strengths[high - 1]));
        const Level above = std::min(level_from(strengths, float(wanted)), high);
        const auto ratio = [&](Level level) { return double(strengths[level - 1]) / wanted; };
        return above > low && ratio(above) * ratio(above - 1) > 1.0 ? above - 1 : above;
    }

    const Evidence& all;
    const FitOptions& asked;
    std::vector<Level> levels;
    Array<std::uint32_t> beside_each;  ///< per pixel of a definition: how many are drawn here
    Array<std::uint32_t> reaching;     ///< per pixel of the judge: how many are near to it
};

std::vector<Level> levels_from(const Evidence& all, In<float> thresholds) {
    check(thresholds.size() == all.definitions, "thresholds: one per definition expected");
    std::vector<Level> levels;
    for (std::size_t d = 0; d < all.definitions; ++d) levels.push_back(level_from(all.strengths[d], thresholds[d]));
    return levels;
}

std::vector<Level> random_levels(const Evidence& all, int seed) {
    std::mt19937 random{std::uint32_t(seed)};
    std::vector<Level> levels;
    for (std::size_t d = 0; d < all.definitions; ++d) levels.push_back(1 + Level(random() % all.off(d)));
    return levels;
}

Fit best_of(const Evidence& all, In<float> first, const FitOptions& options) {
    std::vector<Search> searches;
    searches.reserve(std::size_t(options.starts) + 2);
    searches.emplace_back(all, options, levels_from(all, first));
    searches.emplace_back(all, options, levels_from(all, std::vector<float>(all.definitions, no_threshold)));
    for (int seed = 1; seed <= options.starts; ++seed) searches.emplace_back(all, options, random_levels(all, seed));
    std::vector<double> scores(searches.size());
    parallel_for(searches.size(), 1, [&](std::size_t i) {
        searches[i].run();
        scores[i] = searches[i].found().score;
    });
    std::size_t best = 0;
    for (std::size_t i = 1; i < scores.size(); ++i)
        if (scores[i] > scores[best] + equal) best = i;
    searches[best].to_the_middle();
    return searches[best].found();
}

void check_options(const FitOptions& options) {
    check(options.tolerance >= 0.0 && options.beta > 0.0, "a fit: the tolerance is below 0, or beta is not above it");
}

}  // namespace

double Fit::f(double beta) const { return f_measure(precision, recall, beta); }

Fit fitted(const Evidence& evidence, In<float> first, const FitOptions& options) {
    check_options(options);
    return best_of(evidence, first, options);
}

Fit judged(const Evidence& evidence, In<float> thresholds, const FitOptions& options) {
    return Search(evidence, options, levels_from(evidence, thresholds)).found();
}

Fit fitted(const std::vector<Judging>& drawings, In<float> first, const FitOptions& options) {
    check_options(options);
    return fitted(evidence_of(drawings, options.tolerance), first, options);
}

Fit judged(const std::vector<Judging>& drawings, In<float> thresholds, const FitOptions& options) {
    return judged(evidence_of(drawings, options.tolerance), thresholds, options);
}

Fit cross_validated(const Evidence& all, In<float> first, const FitOptions& options) {
    check_options(options);
    FitOptions of_fold = options;
    of_fold.starts = std::min(options.starts, starts_per_fold);
    Sums sums;
    for (std::size_t fold = 0; fold < all.folds; ++fold) {
        const Fit fit = best_of(all.part(fold, false), first, of_fold);
        const Evidence held_out = all.part(fold, true);
        sums.add(Search(held_out, options, levels_from(held_out, fit.thresholds)).sums());
    }
    Fit found;
    found.precision = sums.precision(), found.recall = sums.recall(all.judged);
    found.score = found.f(options.beta);
    return found;
}

std::vector<Judging> judging(const std::vector<Strengths>& definitions, const Bitmap& judge) {
    Judging one{{}, &judge};
    for (const Strengths& strengths : definitions) one.definitions.push_back(&strengths);
    return {one};
}

}  // namespace fovea::study
