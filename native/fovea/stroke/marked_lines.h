// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of the view with marks, as a frame that knows no others has them.
#pragma once

#include <map>
#include <memory>
#include <mutex>

#include <fovea/elision/view_lines.h>

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

struct MarkedLines {
    std::shared_ptr<const ViewLines> lines;
    /// Per place: where marks are, in pixels along the line; a closed one has whole periods. It ascends where the
    /// surface faces the right of the line, else it descends, and begins elsewhere on each. 0 on lines without marks.
    Array<double> own;
    Array<double> period;      ///< per piece: length of its marks [px]; 0: it has none
    std::uint64_t number = 0;  ///< of no other lines in this process
    /// Marks of the places (marks.h), of chains of frames.
    std::unique_ptr<HandedOn> handed_on = std::make_unique<HandedOn>();

    /// About, without `lines`; with what is handed on along them.
    std::size_t bytes() const { return 5 * own.size() * sizeof(double) + period.size() * sizeof(double); }
    /// Hash of where the places with marks are and of their own marks; 0: there are none.
    std::uint64_t content() const;
    /// Values per place, of those with marks alone.
    Array<double> packed(In<double> values) const;
    /// The other way around; 0 elsewhere. Throws std::invalid_argument where they are not as many.
    Array<double> unpacked(In<double> packed) const;
};

/// `lines`: of the same paths. `period`: per line set, length of the marks of its pen in px; 0: its lines have none.
MarkedLines marked_lines(std::shared_ptr<const ViewLines> lines, const ClippedPaths& clipped, const Paths& paths,
                         const Scene& scene, In<double> period);

}  // namespace fovea::stroke
