// SPDX-License-Identifier: GPL-3.0-or-later
// A cage's topology and creases as an OpenSubdiv refiner.
#pragma once

#include <opensubdiv/far/topologyRefinerFactory.h>

#include <fovea/mesh/refine.h>

namespace fovea::mesh {

namespace Far = OpenSubdiv::Far;
namespace Sdc = OpenSubdiv::Sdc;

/// Features are isolated this many levels deeper than the level of the refined vertices. Then all those vertices but
/// irregular ones are corners of bicubic patches, and so are the middles of their quads. Semi-sharp creases sharper
/// than the isolation depth are made infinitely sharp.
inline constexpr int smooth_isolation = 1, crease_isolation = 3;

struct Cage {
    std::unique_ptr<Far::TopologyRefiner> refiner;
    Array<Index> number;  ///< per mesh vertex: its number in the refiner; none if it is in no polygon
};

/// cage_of throws as RefinedSurface does. shared: another refiner that shares the cage's topology.
Cage cage_of(const std::string& name, const MeshArrays& mesh, const Refinement& refinement);
std::unique_ptr<Far::TopologyRefiner> shared(const Cage& cage);

}  // namespace fovea::mesh
