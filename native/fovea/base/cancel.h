// SPDX-License-Identifier: GPL-3.0-or-later
// Cancellation of long calls.
#pragma once

#include <atomic>
#include <stdexcept>

#include <fovea/base/namespaces.h>

namespace fovea::base {

/// Thrown when a long call is cancelled.
struct Cancelled : std::runtime_error {
    Cancelled() : std::runtime_error("cancelled") {}
};

/// A flag that long calls poll once per block; may be set from any thread.
struct Cancel {
    std::atomic<bool> requested{false};

    virtual ~Cancel() = default;
    virtual bool asked() const { return requested.load(std::memory_order_relaxed); }
    void poll() const {
        if (asked()) throw Cancelled();
    }
};

/// Scope in which the calling thread, and the parallel loops that it starts, poll a Cancel (null: none). Scopes nest.
class Cancelling {
   public:
    explicit Cancelling(const Cancel* cancel) : before_(current_) { current_ = cancel; }
    ~Cancelling() { current_ = before_; }
    Cancelling(const Cancelling&) = delete;
    Cancelling& operator=(const Cancelling&) = delete;

    static const Cancel* current() { return current_; }
    static void poll() {
        if (current_) current_->poll();
    }

   private:
    static inline thread_local const Cancel* current_ = nullptr;
    const Cancel* const before_;
};

}  // namespace fovea::base
