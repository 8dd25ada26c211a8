// SPDX-License-Identifier: GPL-3.0-or-later
// Derived quantities, computed on first use and cached with the object that they are derived from.
#pragma once

#include <algorithm>
#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <tbb/task_arena.h>
#include <typeindex>

#include <fovea/base/namespaces.h>

namespace fovea::base {

/// How many quantities of a type a cache keeps.
template <typename T>
constexpr int kept_of = 4;

/// Cache of derived quantities, keyed by their type and a 64-bit key (a hash of everything else that they depend on).
/// Holds the kept_of<T> most recently used of each type. Thread-safe. A quantity is computed once, while the
/// (recursive) lock is held, and its computation may itself query the cache.
class Cache {
   public:
    template <typename T, typename Make>
    std::shared_ptr<const T> get(std::uint64_t key, const Make& make) {
        std::lock_guard lock(mutex_);
        const std::type_index type(typeid(T));
        int same_type = 0;
        for (auto it = entries_.begin(); it != entries_.end(); ++it) {
            if (it->type != type) continue;
            if (it->key == key) {
                entries_.splice(entries_.begin(), entries_, it);
                return std::static_pointer_cast<const T>(entries_.front().value);
            }
            if (++same_type >= kept_of<T>) {
                entries_.erase(it);
                break;
            }
        }
        // Isolated: while it waits inside make(), the thread must not steal a task that queries this cache again.
        std::shared_ptr<const T> value;
        tbb::this_task_arena::isolate([&] { value = std::make_shared<const T>(make()); });
        entries_.push_front({type, key, value});
        return value;
    }

    /// The cached quantity, or null if it is not cached or another thread holds the lock (while it computes something).
    template <typename T>
    std::shared_ptr<const T> find(std::uint64_t key) {
        const std::unique_lock lock(mutex_, std::try_to_lock);
        if (!lock) return nullptr;
        const auto it = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) {
            return entry.type == std::type_index(typeid(T)) && entry.key == key;
        });
        if (it == entries_.end()) return nullptr;
        entries_.splice(entries_.begin(), entries_, it);
        return std::static_pointer_cast<const T>(it->value);
    }

    /// body(), while the lock is held: for quantities that are computed together, each once. Parallel loops in it must
    /// not query this cache.
    template <typename Body>
    auto together(const Body& body) {
        std::lock_guard lock(mutex_);
        return tbb::this_task_arena::isolate(body);
    }

    void clear() {
        std::lock_guard lock(mutex_);
        entries_.clear();
    }

   private:
    struct Entry {
        std::type_index type;
        std::uint64_t key;
        std::shared_ptr<const void> value;
    };
    mutable std::recursive_mutex mutex_;
    std::list<Entry> entries_;
};

}  // namespace fovea::base
