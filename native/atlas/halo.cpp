#include <algorithm>
#include <cmath>

#include "atlas/filters.h"
#include "atlas/strand.h"
#include "base/check.h"

namespace fovea {

Runs halo(const ClippedPaths& clipped, const Runs& runs, In<float> gap_px) {
    check(clipped.path.empty() || clipped.path.back() < gap_px.size(), "gap_px: one value per path expected");
    for (float gap : gap_px) check(std::isfinite(gap) && gap >= 0.0f, "gap_px: not a number of 0 or more");
    const auto changes = [&](Index path) { return gap_px[path] > 0.0f; };
    return change_visible(clipped, runs, changes, [&](const Strand& strand, std::vector<Span>& spans) {
        const double gap = gap_px[clipped.path[strand.parts()[0].piece]];
        for (Span& span : spans) {
            if (strand.is_whole(span)) continue;
            if (!strand.reaches_begin(span)) span.begin += gap;
            if (!strand.reaches_end(span)) span.end -= gap;
        }
        std::erase_if(spans, [](const Span& span) { return span.begin >= span.end; });
    });
}

}  // namespace fovea
