// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/stroke/shares.h>

#include <algorithm>
#include <utility>

namespace fovea::stroke {

void Shares::add(int x, int y, std::uint32_t id, float alpha) {
    if (alpha <= 0.0f) return;
    Index own = none;
    for (Index i = first_[at(x, y)]; i != none; i = entries_[i].next) {
        entries_[i].share.share *= 1.0f - alpha;
        if (entries_[i].share.id == id) own = i;
    }
    if (id == 0) return;
    if (own == none) {
        own = Index(entries_.size());
        entries_.push_back({{id, 0.0f}, std::exchange(first_[at(x, y)], own)});
    }
    entries_[own].share.share += alpha;
}

void Shares::ranked(int x, int y, std::vector<Share>& out) const {
    out.clear();
    for (Index i = first_[at(x, y)]; i != none; i = entries_[i].next)
        if (entries_[i].share.share > 0.0f) out.push_back(entries_[i].share);
    std::ranges::sort(
        out, [](const Share& a, const Share& b) { return a.share != b.share ? a.share > b.share : a.id < b.id; });
}

}  // namespace fovea::stroke
