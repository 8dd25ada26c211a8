// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces whose vertices lie on the limit of Catmull-Clark subdivision.
#pragma once

#include <fovea/mesh/surface.h>

namespace fovea::mesh {

/// How a cage is subdivided. Creases are Blender's weights, from 0 (smooth) to 1 (infinitely sharp), of which the
/// sharpness is 10 w^2; an empty array is all smooth.
struct Refinement {
    static constexpr int most_levels = 7;
    int level = 2;                 ///< every quad of the cage becomes 2^level x 2^level, 1 to most_levels
    bool round_corners = false;    ///< also at corners of one polygon on a border; else the border goes through them
    In<float> edge_crease = {};    ///< per edge of the cage
    In<float> vertex_crease = {};  ///< per vertex of the cage
};

/// A cage's refined mesh, all quads, whose vertices are moved to the limit surface. Polygons keep the material of the
/// cage's, edges along the cage's keep their marks; infinitely sharp edges are marked sharp. Loose edges are left out.
///
/// `jets` are exact: the limit surface is bicubic but near cage vertices where not four quads meet, on which refined
/// vertices lie that have an exact position and normal; their second and third derivatives need not exist, and stand
/// for those in the middle of the refined quads around. Third derivatives jump where four patches meet: the mean over
/// the quads around, weighted by their area in the patch's parameters. At a sharp edge jets are those of one side, the
/// one of the largest angle. Semi-sharp creases that round off within an eighth of a refined quad count as sharp.
///
/// Catmull & Clark, "Recursively generated B-spline surfaces on arbitrary topological meshes", CAD 1978; DeRose, Kass &
/// Truong, "Subdivision Surfaces in Character Animation", SIGGRAPH 1998 (creases); Stam, "Exact Evaluation of
/// Catmull-Clark Subdivision Surfaces at Arbitrary Parameter Values", SIGGRAPH 1998.
class RefinedSurface : public Surface {
   public:
    /// Throws std::invalid_argument, naming the object, for a cage without a limit surface (polygons with a vertex
    /// twice, edges of more than two polygons or of two that disagree about which side is out, surfaces that touch in a
    /// vertex), for too many refined faces, and as Surface does.
    RefinedSurface(const std::string& name, const MeshArrays& cage, const Refinement& refinement);
    ~RefinedSurface();

    /// Moves the cage's vertices; topology and creases stay. `refit`: see Surface::set_positions.
    void move_cage(In<vec3> positions, bool refit = false);

    /// Values at the corners of the cage's polygons, `columns` numbers each, mixed bilinearly over its faces: the same
    /// at the corners of the refined mesh. `polygon_offsets`: the cage's, as it was built from. Throws
    /// std::invalid_argument, naming the object, where the sizes are not the cage's.
    Array<float> mix_corners(In<float> values, int columns, In<int> polygon_offsets) const;

   private:
    struct Limit;
    static std::unique_ptr<Limit> limit_of(const std::string& name, const MeshArrays& mesh,
                                           const Refinement& refinement);
    RefinedSurface(const std::string& name, std::unique_ptr<Limit> limit);
    std::unique_ptr<Limit> limit_;
};

}  // namespace fovea::mesh
