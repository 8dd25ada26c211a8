// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of lines of the mesh, which are the same in every frame.
#pragma once

#include <fovea/path/paths.h>
#include <fovea/scene/scene.h>

namespace fovea::elision {

/// Interval of a path of one frame that a key denotes: from .. to in arc length, object units, against the path where
/// `to` is less. Paths may be longer or shorter in another frame, where an earlier line set takes edges from them. So a
/// key is of an edge of the mesh, each of which is on one path only, or of a whole path across triangles; and a place
/// is told by the key and the fraction of its interval. Both hold under motion and deformation, and as long as the
/// object has the same edges: a change of topology makes other keys of them.
struct LinePart {
    std::uint64_t key;
    Index path;
    double from, to;
};

/// The parts of some paths, none of which depends on the view.
class LineParts {
   public:
    /// Borrows all but `some`: paths, ascending.
    LineParts(const Paths& paths, const Scene& scene, In<Index> some);

    Array<LinePart> sorted;  ///< by key

    /// Index into `sorted` of the part that contains the segment from a point of a path.
    Index of(Index path, Index point) const;

   private:
    bool on_edges(Index path) const;
    LinePart part(Index path, Index point) const;

    const Paths& paths_;
    const Scene& scene_;
    Array<std::uint64_t> object_;  // per placement: hash of its id and its edges
    Array<Index> first_;           // per path: number of its first part, as they are before they are sorted
    Array<Index> place_;           // per number: index into `sorted`
};

/// Per part of a frame, sorted by key: index of the part of another frame that has its key; `none` unless there is one.
Array<Index> matched_parts(In<LinePart> now, In<LinePart> there);

}  // namespace fovea::elision
