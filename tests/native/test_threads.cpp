// SPDX-License-Identifier: GPL-3.0-or-later
#include <atomic>
#include <gtest/gtest.h>
#include <thread>

#include <fovea/base/parallel.h>
#include <fovea/base/threads.h>

using namespace fovea;

TEST(Threads, NoMoreWorkAtOnceThanAllowed) {
    const int all = thread_limit();
    limit_threads(1);
    EXPECT_EQ(thread_limit(), 1);
    std::atomic<int> now{0}, most{0};
    parallel_blocks(64, 1, [&](auto, std::size_t, std::size_t) {
        const int here = ++now;
        int before = most;
        while (before < here && !most.compare_exchange_weak(before, here)) {
        }
        std::this_thread::yield();
        --now;
    });
    EXPECT_EQ(most, 1);
    limit_threads(3);
    EXPECT_EQ(thread_limit(), 3);
    limit_threads(0);
    EXPECT_EQ(thread_limit(), all);
    EXPECT_THROW(limit_threads(-1), std::invalid_argument);
}
