// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/base/large_memory.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <deque>
#include <mutex>
#include <new>

#include <fovea/base/pages.h>
#include <fovea/base/release_memory.h>

namespace fovea::base {
namespace {

/// Blocks of at least this size are of pages of their own, all others from the heap.
constexpr std::size_t least_in_pages = has_pages ? 2 * page_bytes : SIZE_MAX;

bool is_in_pages(std::size_t size) { return size >= least_in_pages; }

/// Size of the block for an array: of large ones as many pages as they need; of others at most a quarter larger, so
/// that arrays of similar size serve each other (the largest of these are in pages, too, as they are rounded up to
/// least_in_pages). What is not touched takes no memory, but for the rest of one of the system's pages.
std::size_t block_size(std::size_t bytes) {
    const std::size_t step = is_in_pages(bytes) ? page_bytes : std::bit_floor(bytes) / 4;
    return (bytes + step - 1) / step * step;
}

/// Number of a block_size from the heap: four for each power of two.
std::size_t number_of(std::size_t size) {
    const std::size_t power = std::bit_floor(size);
    return 4 * std::size_t(std::countr_zero(power)) + size / (power / 4) - 4;
}

/// Freed blocks, kept for later arrays.
class Freed {
   public:
    /// A block of this size, of those from the heap the one that was freed last; null if there is none.
    void* take(std::size_t size) {
        const std::lock_guard lock(mutex_);
        void* const start = is_in_pages(size) ? pages_.take(size) : take_alike(size);
        if (start) kept_ -= size;
        return start;
    }

    /// The oldest blocks make room for it.
    void give(void* start, std::size_t size) noexcept {
        const std::lock_guard lock(mutex_);
        try {
            if (is_in_pages(size))
                pages_.give(start, size, ++freed_);
            else
                of_size_[number_of(size)].push_back({start, size, ++freed_});
            kept_ += size;
        } catch (const std::bad_alloc&) {
            is_in_pages(size) ? unmap_pages(start, size) : std::free(start);
        }
        shrink(keeps_large_memory);
    }

    void clear() noexcept {
        const std::lock_guard lock(mutex_);
        shrink(0);
    }

    std::size_t kept() {
        const std::lock_guard lock(mutex_);
        return kept_;
    }

   private:
    struct Block {
        void* start;
        std::size_t size;
        std::uint64_t at;  ///< how many were freed by then

        static std::uint64_t first_at(const std::deque<Block>& alike) {
            return alike.empty() ? UINT64_MAX : alike.front().at;
        }
    };

    void* take_alike(std::size_t size) {
        std::deque<Block>& alike = of_size_[number_of(size)];
        if (alike.empty()) return nullptr;
        void* const start = alike.back().start;
        alike.pop_back();
        return start;
    }

    void shrink(std::size_t most) noexcept {
        while (kept_ > most) {
            std::deque<Block>& alike = *std::ranges::min_element(of_size_, {}, &Block::first_at);
            if (pages_.oldest() < Block::first_at(alike)) {
                kept_ -= pages_.unmap_oldest((kept_ - most + page_bytes - 1) / page_bytes * page_bytes);
                continue;
            }
            std::free(alike.front().start);
            kept_ -= alike.front().size;
            alike.pop_front();
        }
    }

    std::mutex mutex_;
    std::array<std::deque<Block>, 4 * 8 * sizeof(std::size_t)> of_size_;  // by number_of; the oldest first
    FreePages pages_;
    std::uint64_t freed_ = 0;
    std::size_t kept_ = 0;
};

Freed& freed() {
    static auto* const blocks = new Freed;  // outlives all arrays
    return *blocks;
}

/// Uninitialized memory of a block_size; null if there is none.
void* fresh(std::size_t size) { return is_in_pages(size) ? map_pages(size) : std::malloc(size); }

}  // namespace

void* allocate_large(std::size_t bytes) {
    if (bytes > SIZE_MAX / 2) throw std::bad_alloc();
    const std::size_t size = block_size(bytes);
    if (void* const found = freed().take(size)) return found;
    if (void* const found = fresh(size)) return found;
    freed().clear();
    if (void* const found = fresh(size)) return found;
    throw std::bad_alloc();
}

void free_large(void* memory, std::size_t bytes) noexcept { freed().give(memory, block_size(bytes)); }

void release_large_memory() noexcept { freed().clear(); }

std::size_t large_memory_kept() { return freed().kept(); }

}  // namespace fovea::base
