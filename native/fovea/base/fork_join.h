// SPDX-License-Identifier: GPL-3.0-or-later
// What the thread sanitizer has to be told of a parallel loop, as it does not see into oneTBB: bodies begin after the
// call and end before its return. It is told nothing of the order of bodies among each other, so races between them are
// found. Without the sanitizer all of this is empty.
#pragma once

#if defined(__SANITIZE_THREAD__)  // GCC
#define FOVEA_THREAD_SANITIZER 1
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)  // Clang
#define FOVEA_THREAD_SANITIZER 1
#endif
#endif

#ifdef FOVEA_THREAD_SANITIZER
// As sanitizer/tsan_interface.h has them, which Debian's Clang lacks.
extern "C" void __tsan_acquire(void* place);
extern "C" void __tsan_release(void* place);
/// Of a lambda that oneTBB copies from thread to thread: what it captures is oneTBB's to hand over.
#define FOVEA_TBB_HANDS_OVER __attribute__((no_sanitize("thread")))
#else
#define FOVEA_TBB_HANDS_OVER
#endif

namespace fovea::base {

/// One parallel call, made before it and gone after it.
class ForkJoin {
   public:
    ForkJoin() { release(begun_); }
    ~ForkJoin() { acquire(ended_); }
    ForkJoin(const ForkJoin&) = delete;
    ForkJoin& operator=(const ForkJoin&) = delete;

    /// One body of the call, from its begin to its end.
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
    char begun_ = 0, ended_ = 0;  // only their addresses count
};

}  // namespace fovea::base
