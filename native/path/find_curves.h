// The lines across triangles that line sets ask for.
#pragma once

#include "base/check.h"
#include "path/chain_curves.h"
#include "path/line_set.h"

namespace fovea {

/// Curves across triangles that one definition finds for one line set.
struct FoundCurves {
    std::uint8_t line_set;
    Index definition;
    std::shared_ptr<const CurveChains> chains;
    Index other = none;  // the second placement on which they lie
};

/// Of one placement's surface: of definitions that hold for all views, or those that do not. `near`, `hard`: of
/// doubles.h, or empty. A definition goes to the first line set that has it.
std::vector<FoundCurves> find_curves(const SurfaceView& seen, const std::vector<LineSet>& sets, bool of_surface,
                                     In<std::uint8_t> near = {}, In<std::uint8_t> hard = {});

/// Of the whole scene, each with the placement that has it.
std::vector<std::pair<Index, FoundCurves>> find_curves_in_scene(const Scene& scene, In<Index> drawn,
                                                                const std::vector<LineSet>& sets,
                                                                const Cancel& cancel);

/// Of the frame, in view space. They are of no placement: sets that are for some only have none.
std::vector<FoundCurves> find_curves_in_image(const std::vector<LineSet>& sets, const Tracer& tracer,
                                              const Cancel& cancel);

}  // namespace fovea
