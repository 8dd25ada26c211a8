// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/base/parallel.h>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_group.h>

namespace fovea::base {

void for_ranges(std::size_t count, std::size_t grain, const void* body,
                void (*call)(const void* body, std::size_t begin, std::size_t end)) {
    const ForkJoin fork;
    const Cancel* const cancel = Cancelling::current();
    const auto run = [&](const auto& range) FOVEA_TBB_HANDS_OVER {
        const ForkJoin::Body here(fork);
        const Cancelling scope(cancel);
        call(body, range.begin(), range.end());
    };
    tbb::task_group_context alone(tbb::task_group_context::isolated);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain), run, alone);
}

}  // namespace fovea::base
