// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces whose vertices lie on the limit of Catmull-Clark subdivision.
#pragma once

#include <fovea/mesh/surface.h>

namespace fovea::mesh {

/// How a cage is subdivided. Creases are Blender's weights w from 0 (smooth) to 1 (infinitely sharp), with sharpness 10
/// w^2; an empty array means all smooth.
struct Refinement {
    static constexpr int most_levels = 7;
    int level = 2;  ///< every cage quad becomes 2^level x 2^level quads; 1 to most_levels
    /// Round boundary corners that belong to one polygon only; else the border passes through them.
    bool round_corners = false;
    In<float> edge_crease = {};    ///< per edge of the cage
    In<float> vertex_crease = {};  ///< per vertex of the cage
};

/// The refined mesh of a cage, all quads, with its vertices moved to the limit surface. Refined polygons inherit the
/// material of their cage polygon, and refined edges on cage edges inherit their marks; loose edges are dropped.
///
/// `jets` are exact, with these exceptions. Where the limit surface is not bicubic (near extraordinary cage vertices),
/// a vertex has its exact position and normal, but second and third derivatives, which need not exist there, are taken
/// from the middles of the surrounding refined quads. Third derivatives jump where four patches meet: they are the mean
/// over the incident quads, weighted by parametric area. At a sharp edge, jets are those of one side: the sector
/// with the most quads. Semi-sharp creases that would round off only within an eighth of a refined quad count as
/// infinitely sharp.
///
/// Catmull & Clark, "Recursively generated B-spline surfaces on arbitrary topological meshes", CAD 1978; DeRose, Kass &
/// Truong, "Subdivision Surfaces in Character Animation", SIGGRAPH 1998 (creases); Stam, "Exact Evaluation of
/// Catmull-Clark Subdivision Surfaces at Arbitrary Parameter Values", SIGGRAPH 1998.
class RefinedSurface : public Surface {
   public:
    /// Throws std::invalid_argument, naming the object, for a cage without a limit surface (a polygon with a repeated
    /// vertex, an edge with more than two polygons or with two of opposite winding, surfaces that touch only in a
    /// vertex), for too many refined faces, and as Surface does.
    RefinedSurface(const std::string& name, const MeshArrays& cage, const Refinement& refinement);
    ~RefinedSurface();

    /// Moves the cage's vertices; topology and creases are unchanged. `refit`: see Surface::set_positions.
    void move_cage(In<vec3> positions, bool refit = false);

    /// As set_rest, of the cage's vertices.
    void set_cage_rest(In<vec3> positions);

    /// Interpolates values at the cage's polygon corners, `columns` numbers per corner, bilinearly to the corners of
    /// the refined mesh. `polygon_offsets`: those of the cage it was built from. Throws std::invalid_argument, naming
    /// the object, if the sizes do not match the cage.
    Array<float> mix_corners(In<float> values, int columns, In<int> polygon_offsets) const;

   private:
    struct Limit;
    static std::unique_ptr<Limit> limit_of(const std::string& name, const MeshArrays& mesh,
                                           const Refinement& refinement);
    RefinedSurface(const std::string& name, std::unique_ptr<Limit> limit);
    std::unique_ptr<Limit> limit_;
};

}  // namespace fovea::mesh
