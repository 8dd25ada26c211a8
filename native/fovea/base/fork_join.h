// SPDX-License-Identifier: GPL-3.0-or-later
// Annotations of parallel loops for the thread sanitizer, which does not see into oneTBB: each body starts after the
// call and ends before the call returns. No order among bodies is annotated, so races between them are still found.
// Without the sanitizer everything here compiles to nothing.
#pragma once

#include <fovea/base/sanitizers.h>

#ifdef FOVEA_THREAD_SANITIZER
// Declared as in sanitizer/tsan_interface.h, which is in another package of Debian than Clang.
extern "C" void __tsan_acquire(void* place);
extern "C" void __tsan_release(void* place);
/// For lambdas that oneTBB copies between threads: oneTBB synchronizes what they capture.
#define FOVEA_TBB_HANDS_OVER __attribute__((no_sanitize("thread")))
#else
#define FOVEA_TBB_HANDS_OVER
#endif

namespace fovea::base {

/// Scope of one parallel call: constructed before it, destroyed after it.
class ForkJoin {
   public:
    ForkJoin() { release(begun_); }
    ~ForkJoin() { acquire(ended_); }
    ForkJoin(const ForkJoin&) = delete;
    ForkJoin& operator=(const ForkJoin&) = delete;

    /// Scope of one body of the call.
    class Body {
       public:
        explicit Body(const ForkJoin& call) : call_(call) { acquire(call_.begun_); }
        ~Body() { release(call_.ended_); }
        Body(const Body&) = delete;
        Body& operator=(const Body&) = delete;

       private:
        const ForkJoin& call_;
    };

   private:
#ifdef FOVEA_THREAD_SANITIZER
    static void acquire(const char& place) { __tsan_acquire(const_cast<char*>(&place)); }
    static void release(const char& place) { __tsan_release(const_cast<char*>(&place)); }
#else
    static void acquire(const char&) {}
    static void release(const char&) {}
#endif
    char begun_ = 0, ended_ = 0;  // only their addresses are used
};

}  // namespace fovea::base
