// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/style/rules.h>

#include <algorithm>
#include <numeric>
#include <span>

#include <fovea/base/check.h>

namespace fovea::style {
namespace {

/// Name of a member in messages.
std::string of(const Path& where, const char* member) { return (where.empty() ? "" : dotted(where) + ".") + member; }

/// Updates the paths of unknown values in a list whose entries were reordered: entry i is now at place[i].
void follow(std::vector<Unknown>& unknown, const Path& list, const std::vector<std::size_t>& place) {
    for (Unknown& each : unknown) {
        if (each.path.size() <= list.size()) continue;
        if (!std::ranges::equal(list, std::span(each.path).first(list.size()))) continue;
        auto& index = std::get<std::size_t>(each.path[list.size()]);
        index = place[index];
    }
}

}  // namespace

void settle(const Transfer& transfer, const Path& where) {
    const std::vector<dvec2>& curve = transfer.curve;
    check(curve.size() <= Transfer::most_points,
          of(where, "curve") + " must be a list of at most " + std::to_string(Transfer::most_points) + " points");
    const auto not_ascending = [](const dvec2& a, const dvec2& b) { return a.x >= b.x; };
    if (std::ranges::adjacent_find(curve, not_ascending) != curve.end())
        throw std::invalid_argument(of(where, "curve") + ": points must ascend in x");
}

void settle(const Distance& distance, const Path& where) {
    check(distance.far > distance.near, of(where, "far") + " must be more than near");
}

void settle(const FocusPlace& place, const Path& where) {
    check(place.far >= place.near, of(where, "far") + " must not be less than near");
}

void settle(const Focus& focus, const Path& where) {
    check(focus.points.size() <= Focus::most_places,
          of(where, "points") + " must be a list of at most " + std::to_string(Focus::most_places) + " points");
    check(!focus.is_painted() || !focus.attribute.empty(), of(where, "attribute") + " must name what is painted");
}

void settle(const Elision& elision, const Path& where) {
    std::string weights;
    for_each_field<Elision>([&](const auto& field) {
        if (std::string_view(field.group) == Elision::weights)
            weights += (weights.empty() ? "" : ", ") + std::string(field.name);
    });
    check(elision.ranks(), dotted(where) + ": some of " + weights + " must count");
}

void settle(const Hidden& hidden, const Path& where) {
    if (!hidden.last || *hidden.last >= hidden.first) return;
    throw std::invalid_argument(of(where, "to") + " is " + std::to_string(*hidden.last) + ", less than " +
                                of(where, "from") + ", which is " + std::to_string(hidden.first));
}

void settle(LineSet& set, const Path& where, std::vector<Unknown>& unknown) {
    std::vector<Hidden>& hidden = set.hidden;
    std::vector<std::size_t> order(hidden.size()), place(hidden.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return hidden[i].first; });
    std::vector<Hidden> sorted;
    for (std::size_t i = 0; i < order.size(); ++i) {
        place[order[i]] = i;
        sorted.push_back(std::move(hidden[order[i]]));
    }
    hidden = std::move(sorted);
    for (std::size_t i = 1; i < hidden.size(); ++i)
        if (const auto& last = hidden[i - 1].last; !last || *last >= hidden[i].first)
            throw std::invalid_argument(of(where, "hidden") + ": two ranges hold what " +
                                        std::to_string(hidden[i].first) + " surfaces hide");
    Path list = where;
    list.emplace_back("hidden");
    follow(unknown, list, place);
}

}  // namespace fovea::style
