// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/path/curves_of.h>

#include <fovea/field/fields.h>
#include <fovea/path/doubles.h>
#include <fovea/path/hysteresis.h>
#include <fovea/path/smooth.h>

namespace fovea {

CurveChains curves_of(const LineDefinition& definition, const SurfaceView& seen, const Values& values,
                      In<std::uint8_t> near) {
    CurveChains chains = chain_curves(definition.find(seen, values));
    smooth(chains, seen.surface);
    if (definition.on_smooth_surface) {
        lift(chains, seen.surface, fields_of(seen.surface)->curvature);
    } else if (definition.select) {
        if (!near.empty()) chains = without_doubles(chains, seen.surface, near);
        chains = without_hooks(chains, seen.surface);
    }
    return definition.select ? select_stretches(chains, definition.select(seen.surface, values)) : chains;
}

}  // namespace fovea
