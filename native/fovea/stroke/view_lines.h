// SPDX-License-Identifier: GPL-3.0-or-later
// The lines of one frame that depend on its view, and on what of the scene they lie: for frames near it.
#pragma once

#include <map>
#include <memory>
#include <mutex>

#include <fovea/base/point_grid.h>
#include <fovea/base/view.h>
#include <fovea/path/paths.h>
#include <fovea/project/clipped_paths.h>
#include <fovea/scene/scene.h>

namespace fovea::stroke {

/// What was found of an animation's frames and is asked again for others of them, by a number that says of which.
class HandedOn {
   public:
    /// Null: nothing is kept.
    std::shared_ptr<const Array<double>> find(std::uint64_t number) const;
    void keep(std::uint64_t number, std::shared_ptr<const Array<double>> values);

   private:
    static constexpr std::size_t most = 4;
    mutable std::mutex mutex_;
    std::map<std::uint64_t, std::shared_ptr<const Array<double>>> kept_;
};

/// The lines of a frame that depend on its view, as places a few pixels apart, without its scene, which frames share
/// and change.
struct ViewLines {
    /// Something of the scene, as this frame has it.
    struct Placed {
        std::uint64_t id;  ///< Placement::id
        dmat4 object_to_view;
        Array<vec3> positions;  ///< of vertices, object space; empty where it does not deform
    };
    struct Place {
        dvec2 px, way;  ///< in the image, and the unit vector along the line
        double arc;     ///< ClippedPaths::arc_px
        double own;     ///< see ViewLines
        double depth;   ///< distance along the view axis
        Index piece, placed;
        dvec3 position;                   ///< object space
        std::array<Index, 3> vertices{};  ///< of what deforms: those of the triangle on which it lies,
        std::array<double, 3> shares{};   ///< and how much it is of each; of an edge the third is 0
        Kinds kinds;
    };

    View view;
    std::vector<Placed> placed;  ///< ascending by id
    Rows rows;                   ///< per piece of ClippedPaths: its places in order; none of other lines
    /// Place::own is where marks are in a frame that knows no others, in pixels along the line: a closed one has whole
    /// periods. It ascends where the surface faces the right of the line, else it descends, and begins elsewhere on
    /// each.
    Array<Place> places;
    Array<double> period;             ///< per piece: length of its marks [px]
    Array<std::uint8_t> closed;       ///< per piece
    std::unique_ptr<PointGrid> grid;  ///< of the places
    std::uint64_t number = 0;         ///< of no other lines in this process
    /// Marks of the places (marks.h), of chains of frames.
    std::unique_ptr<HandedOn> handed_on = std::make_unique<HandedOn>();

    std::size_t bytes() const;  ///< about
    /// Hash of where its places are and of their own marks; 0: there are none.
    std::uint64_t content() const;
};

/// Per place: Place::own.
Array<double> own_marks(const ViewLines& lines);

/// `period`: per line set, length of the marks of its pen in px; 0: its lines have none, and no places. Lines that are
/// found in the image, and those that make a tone, have none either.
ViewLines view_lines(const ClippedPaths& clipped, const Paths& paths, const Scene& scene, const View& view,
                     In<double> period);

}  // namespace fovea::stroke
