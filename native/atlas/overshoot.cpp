#include <cmath>

#include "atlas/filters.h"
#include "atlas/strand.h"
#include "base/check.h"

namespace fovea {

Runs overshoot(const ClippedPaths& clipped, const Runs& runs, In<float> amount_px) {
    check(clipped.path.empty() || clipped.path.back() < amount_px.size(), "amount_px: one value per path expected");
    for (float amount : amount_px) check(std::isfinite(amount), "amount_px: not a finite number");
    const auto changes = [&](Index path) { return amount_px[path] != 0.0f; };
    return change_visible(clipped, runs, changes, [&](const Strand& strand, std::vector<Span>& spans) {
        const double amount = amount_px[clipped.path[strand.parts()[0].piece]];
        for (Span& span : spans) {
            if (strand.is_whole(span)) continue;
            // At the frame the line only seems to end.
            if (strand.ends_at_begin || !strand.reaches_begin(span)) span.begin -= amount;
            if (strand.ends_at_end || !strand.reaches_end(span)) span.end += amount;
        }
        std::erase_if(spans, [](const Span& span) { return span.begin >= span.end; });
    });
}

}  // namespace fovea
