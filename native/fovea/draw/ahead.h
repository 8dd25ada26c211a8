// SPDX-License-Identifier: GPL-3.0-or-later
// What pictures will need of surfaces, computed while others are still read.
#pragma once

#include <memory>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>
#include <vector>

#include <fovea/base/cancel.h>
#include <fovea/base/fork_join.h>
#include <fovea/path/line_set.h>
#include <fovea/style/style.h>

namespace fovea::draw {

/// Computes on other threads than the caller's, and caches with each surface, what frames of a style need of it
/// whatever the view: its BVH, its shape, where it passes through itself. Pictures do not depend on it: what it has not
/// done, or could not, they do, and they tell of errors. Not for surfaces that are changed before finish().
class Ahead {
   public:
    /// `cancel`: stops it, too; may be null.
    Ahead(const style::Style& style, std::shared_ptr<const Cancel> cancel);
    ~Ahead() { finish(); }

    /// A surface of which the rest is set: its field options and its shape. Larger ones are left to the frames: there
    /// all threads take their part in each. Does nothing where only one thread may work.
    void add(std::shared_ptr<const Surface> surface);
    /// Leaves what is not done, and returns when no thread works on it.
    void finish();

   private:
    /// Asks for an end where the caller does, and where finish() was called.
    struct Ending : Cancel {
        std::shared_ptr<const Cancel> caller;  // may be null
        bool asked() const override { return Cancel::asked() || (caller && caller->asked()); }
    };
    void compute(const Surface& surface) const;

    const std::vector<LineSet> sets_;
    Ending ending_;
    tbb::task_arena arena_;
    tbb::task_group group_;
    std::vector<std::unique_ptr<const base::ForkJoin>> calls_;  // one for each surface
};

}  // namespace fovea::draw
