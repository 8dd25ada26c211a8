// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/base/threads.h>

#include <algorithm>
#include <memory>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <fovea/base/check.h>

namespace fovea::base {

void limit_threads(int most) {
    check(most >= 0, "threads: 0 or more expected");
    static std::unique_ptr<tbb::global_control> limit;
    limit.reset();  // oneTBB applies the lowest of all limits, so the old one must be released first
    if (most > 0)
        limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism, std::size_t(most));
}

int thread_limit() { return int(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism)); }

int threads_at_hand() { return std::min(thread_limit(), tbb::this_task_arena::max_concurrency()); }

}  // namespace fovea::base
