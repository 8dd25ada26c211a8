// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/vector/grain.h>

#include <algorithm>

#include <fovea/stroke/ink.h>
#include <fovea/stroke/octaves.h>

namespace fovea::vector {
namespace {

/// Lengths of ink and of gaps in turn, from the first start of ink on.
void find_dashes(In<float> ink, Grain& grain) {
    const std::size_t count = ink.size();
    const auto inked = [&](std::size_t x) { return ink[x % count] > 0.5f; };
    std::size_t x = 0;
    while (x < count && !(inked(x) && !inked(x + count - 1))) ++x;
    if (x == count) return;
    grain.first = double(x) / double(count);
    for (const std::size_t end = x + count; x < end;) {
        const std::size_t from = x;
        while (x < end && inked(x) == inked(from)) ++x;
        grain.dashes.push_back(double(x - from) / double(count));
    }
}

}  // namespace

Grain grain_of(const PenTexture* texture, bool anchored) {
    Grain grain;
    if (!texture || texture->ink.empty()) return grain;
    const In<float> middle = texture->row(texture->height / 2);
    if (stroke::is_dashed(*texture)) {
        find_dashes(middle, grain);
        // Of a half disc the outermost rows have next to none.
        grain.round = stroke::mean_ink(texture->row(0)) < 0.9 * stroke::mean_ink(middle);
        if (anchored) {
            grain.dividing = *texture;
            grain.dividing.dashed = true;
            grain.dividing.octaves = stroke::octaves_of(grain.dividing);
        }
        return grain;
    }
    double sum = 0.0, most = 0.0;
    for (int y = 0; y < texture->height; ++y) {
        const double ink = stroke::mean_ink(texture->row(y));
        sum += ink;
        most = std::max(most, ink);
    }
    if (most <= 0.0) return grain;
    grain.opacity = most;
    grain.width = sum / texture->height / most;
    return grain;
}

}  // namespace fovea::vector
