// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/path/curves_of.h>

#include <fovea/field/fields.h>
#include <fovea/path/doubles.h>
#include <fovea/path/hysteresis.h>
#include <fovea/path/smooth.h>

namespace fovea {

CurveChains curves_of(const CurveRule& rule, const SurfaceView& seen, const Values& values, In<std::uint8_t> near) {
    CurveChains chains = chain_curves(rule.find(seen, values));
    smooth(chains, seen.surface);
    switch (rule.type) {
        case CurveType::level_set:
            return chains;
        case CurveType::contour:
            lift(chains, seen.surface, fields_of(seen.surface)->curvature);
            break;
        case CurveType::feature:
            if (!near.empty()) chains = without_doubles(chains, seen.surface, near);
            chains = without_hooks(chains, seen.surface);
            break;
    }
    return select_stretches(chains, rule.select(seen.surface, values));
}

}  // namespace fovea
