// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/style/mix.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace fovea::style {
namespace {

/// Values without interpolation switch at share .5.
template <typename T>
T between(const T& a, const T& b, double share) {
    return share < 0.5 ? a : b;
}

double between(const double& a, const double& b, double share) { return a + (b - a) * share; }

int between(const int& a, const int& b, double share) { return int(std::nearbyint(a + (b - a) * share)); }

template <Record S>
S between(const S& a, const S& b, double share);

template <int N>
glm::vec<N, double> between(const glm::vec<N, double>& a, const glm::vec<N, double>& b, double share) {
    return a + (b - a) * share;
}

template <typename T>
std::optional<T> between(const std::optional<T>& a, const std::optional<T>& b, double share) {
    if (!a || !b) return share < 0.5 ? a : b;
    return between(*a, *b, share);
}

/// Lists of the same length are interpolated element by element, others switch at share .5.
template <typename T>
std::vector<T> between(const std::vector<T>& a, const std::vector<T>& b, double share) {
    if (a.size() != b.size()) return share < 0.5 ? a : b;
    std::vector<T> mixed;
    for (std::size_t i = 0; i < a.size(); ++i) mixed.push_back(between(a[i], b[i], share));
    return mixed;
}

template <Record S>
S between(const S& a, const S& b, double share) {
    S mixed = a;
    for_each_field<S>(
        [&](const auto& field) { mixed.*field.member = between(a.*field.member, b.*field.member, share); });
    return mixed;
}

/// Scales the opacity of the pens of a line set or of hidden parts.
template <typename S>
void fade(S& drawn, double opacity) {
    drawn.pen.opacity *= opacity;
    if (drawn.pen_away) drawn.pen_away->opacity *= opacity;
}

/// The out-of-focus pen of two line sets or hidden pens; one that has none uses its pen in focus.
template <typename S>
std::optional<Pen> mixed_away(const S& a, const S& b, double share) {
    if (!a.pen_away && !b.pen_away) return std::nullopt;
    return between(a.pen_away.value_or(a.pen), b.pen_away.value_or(b.pen), share);
}

/// Interpolates pens if the ranges are the same; else those of one style fade out, then those of the other fade in.
std::vector<Hidden> mixed_hidden(const std::vector<Hidden>& a, const std::vector<Hidden>& b, double share) {
    const auto same_range = [](const Hidden& x, const Hidden& y) { return x.first == y.first && x.last == y.last; };
    std::vector<Hidden> mixed = share < 0.5 ? a : b;
    if (std::ranges::equal(a, b, same_range)) {
        for (std::size_t i = 0; i < a.size(); ++i) {
            mixed[i].pen = between(a[i].pen, b[i].pen, share);
            mixed[i].pen_away = mixed_away(a[i], b[i], share);
        }
        return mixed;
    }
    const double opacity = share < 0.5 ? 1.0 - 2.0 * share : 2.0 * share - 1.0;
    for (Hidden& hidden : mixed) fade(hidden, opacity);
    return mixed;
}

template <typename T>
const T* find(const std::vector<std::pair<std::string, T>>& named, const std::string& name) {
    const auto found = std::ranges::find(named, name, &std::pair<std::string, T>::first);
    return found == named.end() ? nullptr : &found->second;
}

/// Parameters that either style leaves at the default switch at share .5.
Parameters mixed_parameters(const Parameters& a, const Parameters& b, double share) {
    Parameters mixed = share < 0.5 ? a : b;
    for (auto& [name, value] : mixed) {
        const line::ParameterValue *x = find(a, name), *y = find(b, name);
        if (x && y) value.number = between(x->number, y->number, share);
    }
    return mixed;
}

using Names = std::vector<std::string>;

/// A line set reduced to `kinds`, with opacity scaled.
LineSet fading(const LineSet& set, const Names& kinds, double opacity) {
    LineSet faded = set;
    faded.kinds.clear();
    for (const std::string& kind : kinds) faded.kinds.emplace_back(kind, *find(set.kinds, kind));
    fade(faded, opacity);
    for (Hidden& hidden : faded.hidden) fade(hidden, opacity);
    return faded;
}

LineSet mixed_set(const LineSet& a, const LineSet& b, const Names& kinds, double share) {
    LineSet mixed = between(a, b, share);
    mixed.kinds.clear();
    for (const std::string& kind : kinds)
        mixed.kinds.emplace_back(kind, mixed_parameters(*find(a.kinds, kind), *find(b.kinds, kind), share));
    if (a.overshoot_away || b.overshoot_away)
        mixed.overshoot_away =
            between(a.overshoot_away.value_or(a.overshoot), b.overshoot_away.value_or(b.overshoot), share);
    mixed.pen_away = mixed_away(a, b, share);
    mixed.hidden = mixed_hidden(a.hidden, b.hidden, share);
    return mixed;
}

auto filters(const LineSet& set) {
    return std::tie(set.collection, set.outside, set.object, set.other_objects, set.material, set.other_materials);
}

/// A line definition (`kind`) drawn by line set `set` of a style; `earlier`: number of preceding sets with the same
/// filters that draw it, too.
struct Drawn {
    std::string kind;
    std::size_t set;
    int earlier;
};

std::vector<Drawn> drawn(const Style& style) {
    std::vector<Drawn> found;
    for (std::size_t i = 0; i < style.line_sets.size(); ++i)
        for (const auto& [kind, parameters] : style.line_sets[i].kinds) {
            const auto same = [&, &name = kind](const Drawn& other) {
                return other.kind == name && filters(style.line_sets[other.set]) == filters(style.line_sets[i]);
            };
            found.push_back({kind, i, int(std::ranges::count_if(found, same))});
        }
    return found;
}

/// Line sets of two styles that draw the same kinds with the same filters; `nobody`: no such set in that style.
struct Pair {
    std::size_t one, other;
    Names kinds;
};
constexpr std::size_t nobody = ~std::size_t(0);

std::vector<Pair> paired(const Style& one, const Style& other) {
    const std::vector<Drawn> ours = drawn(one), theirs = drawn(other);
    std::vector<Pair> pairs;
    const auto add = [&](std::size_t i, std::size_t j, const std::string& kind) {
        const auto found = std::ranges::find_if(pairs, [&](const Pair& p) { return p.one == i && p.other == j; });
        (found == pairs.end() ? pairs.emplace_back(i, j, Names()) : *found).kinds.push_back(kind);
    };
    const auto same = [&](const Drawn& x, const Drawn& y) {
        return x.kind == y.kind && x.earlier == y.earlier &&
               filters(one.line_sets[x.set]) == filters(other.line_sets[y.set]);
    };
    for (const Drawn& x : ours) {
        const auto y = std::ranges::find_if(theirs, [&](const Drawn& each) { return same(x, each); });
        add(x.set, y == theirs.end() ? nobody : y->set, x.kind);
    }
    for (const Drawn& y : theirs)
        if (std::ranges::none_of(ours, [&](const Drawn& each) { return same(each, y); })) add(nobody, y.set, y.kind);
    return pairs;
}

/// For each pair of line sets with the same filters and common kinds, one set for these; and one for the kinds of
/// either set that the other style does not draw. Edges belong to the first set that draws them, so the order is that
/// of the nearer style.
std::vector<LineSet> mixed_sets(const Style& one, const Style& other, double share) {
    std::vector<Pair> pairs = paired(one, other);
    std::ranges::stable_sort(pairs, {}, [&](const Pair& pair) {
        const std::size_t last = std::max(one.line_sets.size(), other.line_sets.size());
        const std::size_t i = std::min(pair.one, last), j = std::min(pair.other, last);
        return share < 0.5 ? std::pair(i, j) : std::pair(j, i);
    });
    std::vector<LineSet> mixed;
    for (const Pair& pair : pairs)
        if (pair.other == nobody)
            mixed.push_back(fading(one.line_sets[pair.one], pair.kinds, 1.0 - share));
        else if (pair.one == nobody)
            mixed.push_back(fading(other.line_sets[pair.other], pair.kinds, share));
        else
            mixed.push_back(mixed_set(one.line_sets[pair.one], other.line_sets[pair.other], pair.kinds, share));
    return mixed.empty() ? std::vector{LineSet()} : mixed;
}

}  // namespace

Style mix(const Style& one, const Style& other, double share) {
    Style mixed = share < 1.0 ? one : other;
    if (share > 0.0 && share < 1.0) {
        for_each_field<Style>([&]<typename V>(const Field<Style, V>& field) {
            if constexpr (Record<V> && !std::is_same_v<V, Focus>)
                mixed.*field.member = between(one.*field.member, other.*field.member, share);
        });
        mixed.line_sets = mixed_sets(one, other, share);
    }
    mixed.focus = one.focus;
    return mixed;
}

}  // namespace fovea::style
