// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/study/grow_tree.h>

#include <algorithm>
#include <numeric>
#include <random>

#include <fovea/base/parallel.h>
#include <fovea/study/model_tree.h>

namespace fovea::study {
namespace {

/// Of samples: by these the squared error around their mean is known, but for the sum of their squares.
struct Sums {
    double weight = 0.0, target = 0.0;
    std::size_t count = 0;

    void add(double w, double t) { weight += w, target += w * t, ++count; }
    void add(const Sums& other) { weight += other.weight, target += other.target, count += other.count; }
    Sums less(const Sums& part) const { return {weight - part.weight, target - part.target, count - part.count}; }
    /// What the mean explains of the sum of squares.
    double explained() const { return weight > 0.0 ? target * target / weight : 0.0; }
    double mean() const { return weight > 0.0 ? target / weight : 0.0; }
};

struct Split {
    double gain = 0.0;
    int property = -1;
    double number = 0.0;
};

/// A node that is still to be split.
struct Open {
    Index node;
    std::size_t begin, end;
    int depth;
};

class Grower {
   public:
    Grower(const Samples& samples, const Binned& binned, Array<Index> numbers, const TreeOptions& options)
        : samples_(samples), binned_(binned), numbers_(std::move(numbers)), options_(options), random_(options.seed) {
        least_ = std::max<std::size_t>(1, std::min(options.least, numbers_.size() / 50));
    }

    RegressionTree grow() {
        const Sums all = sums(0, numbers_.size());
        double squares = 0.0;
        for (const Index i : numbers_) squares += double(samples_.weight[i]) * samples_.target[i] * samples_.target[i];
        least_gain_ = std::max(options_.gain * (squares - all.explained()), 0.0);
        tree_.nodes.push_back({-1, 0, all.mean()});
        std::vector<Open> open{{0, 0, numbers_.size(), 0}};
        for (std::size_t next = 0; next < open.size(); ++next) split(Open(open[next]), open);
        if (!options_.slopes) return std::move(tree_);
        std::vector<Part> parts;
        for (const Open& each : open) parts.push_back({each.begin, each.end});
        return with_slopes(tree_, samples_, numbers_, parts);
    }

   private:
    Sums sums(std::size_t begin, std::size_t end) const {
        Sums found;
        for (std::size_t k = begin; k < end; ++k) found.add(samples_.weight[numbers_[k]], samples_.target[numbers_[k]]);
        return found;
    }

    void split(const Open& at, std::vector<Open>& open) {
        if (at.depth >= options_.depth || at.end - at.begin < 2 * least_ || tree_.nodes.size() + 2 > most_nodes) return;
        const Split best = best_of(at);
        if (best.property < 0) return;
        const auto begin = numbers_.begin() + std::ptrdiff_t(at.begin), end = numbers_.begin() + std::ptrdiff_t(at.end);
        const auto middle =
            std::stable_partition(begin, end, [&](Index i) { return value(i, best.property) < best.number; });
        const auto first_above = std::size_t(middle - numbers_.begin());
        const auto child = Index(tree_.nodes.size());
        tree_.nodes[at.node] = {best.property, child, best.number};
        tree_.nodes.push_back({-1, 0, sums(at.begin, first_above).mean()});
        tree_.nodes.push_back({-1, 0, sums(first_above, at.end).mean()});
        open.push_back({child, at.begin, first_above, at.depth + 1});
        open.push_back({child + 1, first_above, at.end, at.depth + 1});
    }

    double value(Index sample, int property) const { return samples_.rows[sample][std::size_t(property)]; }

    /// Properties to try at a node, ascending.
    std::vector<int> tried() {
        std::vector<int> all(property_count);
        std::iota(all.begin(), all.end(), 0);
        if (options_.properties >= property_count) return all;
        for (std::size_t i = 0; i < options_.properties; ++i)
            std::swap(all[i], all[i + std::size_t(random_() % (property_count - i))]);
        all.resize(options_.properties);
        std::ranges::sort(all);
        return all;
    }

    Split best_of(const Open& at) {
        const Sums all = sums(at.begin, at.end);
        const std::vector<int> properties = tried();
        std::vector<Split> splits(properties.size());
        parallel_for(properties.size(), 1, [&](std::size_t i) { splits[i] = best_of(at, all, properties[i]); });
        Split best{.gain = least_gain_};
        for (const Split& each : splits)
            if (each.property >= 0 && each.gain > best.gain) best = each;
        return best;
    }

    Split best_of(const Open& at, const Sums& all, int property) const {
        std::array<Sums, Binned::bins> bins;
        const std::uint8_t* const codes = binned_.of(std::size_t(property));
        for (std::size_t k = at.begin; k < at.end; ++k)
            bins[codes[numbers_[k]]].add(samples_.weight[numbers_[k]], samples_.target[numbers_[k]]);
        Sums below;
        double most = 0.0;
        std::size_t best = Binned::bins;
        for (std::size_t bin = 0; bin + 1 < Binned::bins; ++bin) {
            below.add(bins[bin]);
            if (bins[bin].count == 0 || !fits(below, all)) continue;
            const double gain = gain_of(below, all);
            if (gain > most) most = gain, best = bin;
        }
        // A threshold may lie within the first or the last interval that has samples: then any is looked into.
        if (best == Binned::bins) return exact(at, all, property, 0, Binned::bins);
        std::size_t next = best + 1;
        while (next + 1 < Binned::bins && bins[next].count == 0) ++next;
        return exact(at, all, property, best, next + 1);
    }

    bool fits(const Sums& below, const Sums& all) const {
        return below.count >= least_ && all.count - below.count >= least_;
    }
    static double gain_of(const Sums& below, const Sums& all) {
        return below.explained() + all.less(below).explained() - all.explained();
    }

    /// The best threshold between samples of the intervals from `first` to before `last`.
    Split exact(const Open& at, const Sums& all, int property, std::size_t first, std::size_t last) const {
        const std::uint8_t* const codes = binned_.of(std::size_t(property));
        Sums below;
        std::vector<std::pair<double, Sums>> within;  // by value; of an interval of one value all samples at once
        std::array<std::size_t, Binned::bins> place;
        place.fill(none);
        for (std::size_t k = at.begin; k < at.end; ++k) {
            const Index i = numbers_[k];
            const std::size_t bin = codes[i];
            if (bin >= last) continue;
            Sums* sums = &below;
            if (bin >= first) {
                if (place[bin] == none) {
                    if (binned_.is_one_value(std::size_t(property), bin)) place[bin] = within.size();
                    within.emplace_back(value(i, property), Sums());
                    sums = &within.back().second;
                } else {
                    sums = &within[place[bin]].second;
                }
            }
            sums->add(samples_.weight[i], samples_.target[i]);
        }
        std::ranges::stable_sort(within, {}, [](const auto& each) { return each.first; });
        Split best;
        for (std::size_t k = 0; k + 1 < within.size(); ++k) {
            below.add(within[k].second);
            const double here = within[k].first, after = within[k + 1].first;
            if (here == after || !fits(below, all)) continue;
            const double gain = gain_of(below, all);
            if (gain > best.gain) best = {gain, property, 0.5 * (here + after)};
        }
        return best;
    }

    const Samples& samples_;
    const Binned& binned_;
    Array<Index> numbers_;
    TreeOptions options_;
    std::mt19937_64 random_;
    std::size_t least_ = 1;
    double least_gain_ = 0.0;
    RegressionTree tree_;
};

}  // namespace

Binned::Binned(In<PropertyRow> rows) {
    parallel_for(property_count, 1, [&](std::size_t property) {
        Array<float> sorted(rows.size());
        for (std::size_t i = 0; i < rows.size(); ++i) sorted[i] = rows[i][property];
        std::sort(sorted.begin(), sorted.end());
        std::vector<float> ends;  // of intervals, each the first value of the next one
        for (std::size_t bin = 1; bin < bins; ++bin) {
            const float value = sorted[bin * sorted.size() / bins];
            if (ends.empty() ? value > sorted[0] : value > ends.back()) ends.push_back(value);
        }
        for (std::size_t bin = 0; bin <= ends.size(); ++bin) {
            const float first = bin ? ends[bin - 1] : sorted[0];
            const auto next =
                bin < ends.size() ? std::lower_bound(sorted.begin(), sorted.end(), ends[bin]) : sorted.end();
            one_value_[property][bin] = *(next - 1) == first;
        }
        codes_[property].resize(rows.size());
        for (std::size_t i = 0; i < rows.size(); ++i)
            codes_[property][i] =
                std::uint8_t(std::upper_bound(ends.begin(), ends.end(), rows[i][property]) - ends.begin());
    });
}

RegressionTree grown(const Samples& samples, const Binned& binned, Array<Index> numbers, const TreeOptions& options) {
    return Grower(samples, binned, std::move(numbers), options).grow();
}

}  // namespace fovea::study
