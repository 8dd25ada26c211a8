#include "path/curves_of.h"

#include "base/parallel.h"
#include "field/fields.h"
#include "path/doubles.h"
#include "path/hysteresis.h"
#include "path/smooth.h"

namespace fovea {
namespace {

Array<vec3> normals_of(const Surface& surface) {
    const auto fields = fields_of(surface);
    Array<vec3> normals(fields->curvature.size());
    parallel_for(normals.size(), [&](std::size_t v) { normals[v] = fields->curvature[v].normal; });
    return normals;
}

}  // namespace

CurveChains curves_of(const LineDefinition& definition, const SurfaceView& seen, const Values& values,
                      In<std::uint8_t> near) {
    CurveChains chains = chain_curves(definition.find(seen, values));
    smooth(chains, seen.surface);
    if (definition.on_smooth_surface) lift(chains, seen.surface, normals_of(seen.surface));
    else if (definition.select && !near.empty()) chains = without_doubles(chains, seen.surface, near);
    return definition.select ? select_stretches(chains, definition.select(seen.surface, values)) : chains;
}

}  // namespace fovea
