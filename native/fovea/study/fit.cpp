// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/study/fit.h>

#include <algorithm>
#include <cmath>
#include <random>

#include <fovea/base/check.h>
#include <fovea/base/parallel.h>
#include <fovea/study/nearest_pixel.h>

namespace fovea::study {
namespace {

constexpr double beside = 1.5;  // [px] between lines that are drawn twice
constexpr double equal = 1e-12;
constexpr std::size_t most_rounds = 100;  // a handful does, unless scores are equal but for rounding

/// Number of a threshold of a definition: that of index level - 1 among its strengths, in ascending order. At pixels,
/// the highest at which it is drawn; 0: at none.
using Level = Index;

/// All that the score depends on.
struct Evidence {
    std::size_t definitions = 0;
    std::vector<Array<float>> strengths;  ///< per definition, ascending; level k has strength k - 1
    Array<std::uint32_t> owner;           ///< per pixel of a definition: which one
    Array<std::uint8_t> is_near;          ///< whether it is near to the judge
    std::vector<Array<Level>> drawn;      ///< per definition, per pixel of any: its level here, or beside another's
    std::vector<Array<Level>> reached;    ///< per definition, per pixel of the judge: its most level near to it
    std::size_t judged = 0;               ///< pixels of the judge

    Level off(std::size_t d) const { return Level(strengths[d].size()) + 1; }
};

Array<float> distinct(const Array<float>& strengths) {
    Array<float> values;
    for (const float value : strengths)
        if (value >= 0.0f) values.push_back(value);
    parallel_sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

/// Level of the weakest lines that are drawn with a threshold.
Level level_from(const Array<float>& ascending, float threshold) {
    return Level(std::ranges::lower_bound(ascending, threshold) - ascending.begin()) + 1;
}

Array<Level> levels_of(const Array<float>& strengths, const Array<float>& ascending) {
    return parallel_map<Level>(strengths.size(), [&](std::size_t i) {
        return strengths[i] < 0.0f ? Level(0) : level_from(ascending, strengths[i]);
    });
}

Evidence evidence_of(const std::vector<Strengths>& definitions, const Bitmap& judge, double tolerance) {
    Evidence all;
    all.definitions = definitions.size();
    const Array<float> to_judge = distances_to(judge);
    Array<Index> pixels;
    for (std::size_t d = 0; d < definitions.size(); ++d) {
        judge.check_size_of({definitions[d].width, definitions[d].height});
        for (std::size_t i = 0; i < to_judge.size(); ++i) {
            if (definitions[d].values[i] < 0.0f) continue;
            pixels.push_back(Index(i));
            all.owner.push_back(std::uint32_t(d));
            all.is_near.push_back(to_judge[i] <= tolerance);
        }
    }
    const Array<Index> of_judge = pixels_in(judge);
    all.judged = of_judge.size();
    for (std::size_t d = 0; d < definitions.size(); ++d) {
        Array<float> here = most_near(definitions[d], pixels, beside);
        for (std::size_t i = 0; i < pixels.size(); ++i)
            if (all.owner[i] == d) here[i] = definitions[d].values[pixels[i]];
        all.strengths.push_back(distinct(definitions[d].values));
        all.drawn.push_back(levels_of(here, all.strengths[d]));
        all.reached.push_back(levels_of(most_near(definitions[d], of_judge, tolerance), all.strengths[d]));
    }
    return all;
}

/// What a drawing gains by thresholds, and sums of it.
struct Sums {
    double drawn = 0.0, near = 0.0, recalled = 0.0;

    void add(const Sums& other) { drawn += other.drawn, near += other.near, recalled += other.recalled; }
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
        for (std::size_t turn = 0; unchanged < all.definitions && turn < most_rounds * all.definitions; ++turn)
            unchanged = improve(turn % all.definitions) ? 1 : unchanged + 1;
    }

    /// Of ranges of thresholds that are as good, to their middles, one after the other.
    void to_the_middle() {
        for (std::size_t d = 0; d < all.definitions; ++d)
            if (levels[d] < all.off(d)) center(d);
    }

    Fit found() const {
        Fit fit;
        Sums sums;
        for (std::size_t i = 0; i < all.owner.size(); ++i)
            if (is_drawn(all.owner[i], i)) sums.add({share(beside_each[i]), all.is_near[i] * share(beside_each[i])});
        sums.recalled = double(std::ranges::count_if(reaching, [](auto count) { return count > 0; }));
        for (std::size_t d = 0; d < all.definitions; ++d)
            fit.thresholds.push_back(levels[d] == all.off(d) ? no_threshold : all.strengths[d][levels[d] - 1]);
        fit.precision = precision(sums), fit.recall = recall(sums);
        fit.score =
            score(sums, std::size_t(std::ranges::count_if(fit.thresholds, [](float t) { return t < no_threshold; })));
        return fit;
    }

   private:
    static double share(std::uint32_t of) { return 1.0 / double(of); }
    bool is_drawn(std::size_t d, std::size_t i) const { return all.drawn[d][i] >= levels[d]; }
    static double precision(const Sums& sums) { return sums.drawn > equal ? sums.near / sums.drawn : 1.0; }
    double recall(const Sums& sums) const { return all.judged ? sums.recalled / double(all.judged) : 1.0; }
    double score(const Sums& sums, std::size_t used) const {
        return f_measure(precision(sums), recall(sums), asked.beta) - asked.cost * double(used);
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

}  // namespace

double Fit::f(double beta) const { return f_measure(precision, recall, beta); }

Fit fitted(const std::vector<Strengths>& definitions, const Bitmap& judge, In<float> first, const FitOptions& options) {
    check(options.tolerance >= 0.0 && options.beta > 0.0, "a fit: the tolerance is below 0, or beta is not above it");
    const Evidence all = evidence_of(definitions, judge, options.tolerance);
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

Fit judged(const std::vector<Strengths>& definitions, const Bitmap& judge, In<float> thresholds,
           const FitOptions& options) {
    const Evidence all = evidence_of(definitions, judge, options.tolerance);
    return Search(all, options, levels_from(all, thresholds)).found();
}

}  // namespace fovea::study
