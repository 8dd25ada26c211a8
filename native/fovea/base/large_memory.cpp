// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/base/large_memory.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <mutex>
#include <new>
#include <vector>

namespace fovea::base {

namespace {

struct Block {
    void* start;
    std::size_t size;
};

/// Freed blocks, kept for later arrays.
class Freed {
   public:
    Freed() { blocks_.reserve(keeps_large_memory / large_memory + 1); }

    /// The block of this size that was freed last; null if there is none.
    void* take(std::size_t size) {
        const std::lock_guard lock(mutex_);
        const auto found = std::ranges::find(blocks_.rbegin(), blocks_.rend(), size, &Block::size);
        if (found == blocks_.rend()) return nullptr;
        void* const start = found->start;
        blocks_.erase(std::next(found).base());
        kept_ -= size;
        return start;
    }

    /// The oldest blocks make room for it.
    void give(Block block) noexcept {
        const std::lock_guard lock(mutex_);
        blocks_.push_back(block);
        kept_ += block.size;
        shrink(keeps_large_memory);
    }

    void clear() {
        const std::lock_guard lock(mutex_);
        shrink(0);
    }

    std::size_t kept() {
        const std::lock_guard lock(mutex_);
        return kept_;
    }

   private:
    void shrink(std::size_t most) noexcept {
        while (kept_ > most) {
            std::free(blocks_.front().start);
            kept_ -= blocks_.front().size;
            blocks_.erase(blocks_.begin());
        }
    }

    std::mutex mutex_;
    std::vector<Block> blocks_;  // the oldest first; never more than were reserved
    std::size_t kept_ = 0;
};

Freed& freed() {
    static auto* const blocks = new Freed;  // outlives all arrays
    return *blocks;
}

/// Size of the block for an array: at most a quarter larger, so that arrays of similar size serve each other. What is
/// not touched takes no memory.
std::size_t size_class(std::size_t bytes) {
    const std::size_t step = std::bit_floor(bytes) / 4;
    return (bytes + step - 1) / step * step;
}

}  // namespace

void* allocate_large(std::size_t bytes) {
    if (bytes > SIZE_MAX / 2) throw std::bad_alloc();
    const std::size_t size = size_class(bytes);
    if (void* const found = freed().take(size)) return found;
    if (void* const found = std::malloc(size)) return found;
    freed().clear();
    if (void* const found = std::malloc(size)) return found;
    throw std::bad_alloc();
}

void free_large(void* memory, std::size_t bytes) noexcept { freed().give({memory, size_class(bytes)}); }

std::size_t large_memory_kept() { return freed().kept(); }

}  // namespace fovea::base
