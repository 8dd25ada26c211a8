// SPDX-License-Identifier: GPL-3.0-or-later
// A cage's topology and creases, as OpenSubdiv takes them.
#pragma once

#include <opensubdiv/far/topologyRefinerFactory.h>

#include <fovea/mesh/refine.h>

namespace fovea::mesh {

namespace Far = OpenSubdiv::Far;
namespace Sdc = OpenSubdiv::Sdc;

/// Features are isolated this many levels deeper than the vertices that are asked for: then all of them but irregular
/// ones are corners of bicubic patches, and so are the middles of their quads. Semi-sharp creases that are sharper than
/// isolation goes are made infinitely sharp.
inline constexpr int smooth_isolation = 1, crease_isolation = 3;

struct Cage {
    std::unique_ptr<Far::TopologyRefiner> refiner;
    Array<Index> number;  ///< of a vertex in the refiner; none: of no polygon
};

/// Throws as RefinedSurface does. Another refiner of the same topology: `shared`.
Cage cage_of(const std::string& name, const MeshArrays& mesh, const Refinement& refinement);
std::unique_ptr<Far::TopologyRefiner> shared(const Cage& cage);

}  // namespace fovea::mesh
