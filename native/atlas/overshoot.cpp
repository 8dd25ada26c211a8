#include <cmath>

#include "atlas/filters.h"
#include "atlas/strand.h"
#include "base/check.h"

namespace fovea {
namespace {

void check_amounts(const ClippedPaths& clipped, In<float> amounts, const char* name) {
    check(clipped.path.empty() || clipped.path.back() < amounts.size(),
          std::string(name) + ": one value per path expected");
    for (float amount : amounts) check(std::isfinite(amount), std::string(name) + ": not a finite number");
}

/// Lengthens spans by amount_at(path, strand, place).
template <typename Changes, typename Amount>
Runs lengthen(const ClippedPaths& clipped, const Runs& runs, const Changes& changes, const Amount& amount_at) {
    return change_visible(clipped, runs, changes, [&](const Strand& strand, std::vector<Span>& spans) {
        const Index path = clipped.path[strand.parts()[0].piece];
        for (Span& span : spans) {
            if (strand.is_whole(span)) continue;
            const double before = amount_at(path, strand, span.begin), after = amount_at(path, strand, span.end);
            // At the frame the line only seems to end.
            if (strand.ends_at_begin || !strand.reaches_begin(span)) span.begin -= before;
            if (strand.ends_at_end || !strand.reaches_end(span)) span.end += after;
        }
        std::erase_if(spans, [](const Span& span) { return span.begin >= span.end; });
    });
}

}  // namespace

Runs overshoot(const ClippedPaths& clipped, const Runs& runs, In<float> amount_px) {
    check_amounts(clipped, amount_px, "amount_px");
    return lengthen(
        clipped, runs, [&](Index path) { return amount_px[path] != 0.0f; },
        [&](Index path, const Strand&, double) { return double(amount_px[path]); });
}

Runs overshoot(const ClippedPaths& clipped, const Runs& runs, In<float> amount_px, In<float> other_px, In<float> mix) {
    check_amounts(clipped, amount_px, "amount_px");
    check_amounts(clipped, other_px, "other_px");
    check(mix.size() == clipped.samples, "mix: one value per atlas sample expected");
    return lengthen(
        clipped, runs, [&](Index path) { return amount_px[path] != 0.0f || other_px[path] != 0.0f; },
        [&](Index path, const Strand& strand, double at) {
            return double(glm::mix(amount_px[path], other_px[path], strand.value(clipped, mix, at, 0.0f)));
        });
}

}  // namespace fovea
