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

#ifdef __linux__
#include <sys/mman.h>
#endif

#include <fovea/base/release_memory.h>

namespace fovea::base {

namespace {

/// Size of the block for an array: at most a quarter larger, so that arrays of similar size serve each other. What is
/// not touched takes no memory, but for the rest of a page.
std::size_t size_class(std::size_t bytes) {
    const std::size_t step = std::bit_floor(bytes) / 4;
    return (bytes + step - 1) / step * step;
}

/// Number of a size of size_class: four for each power of two.
std::size_t number_of(std::size_t size) {
    const std::size_t power = std::bit_floor(size);
    return 4 * std::size_t(std::countr_zero(power)) + size / (power / 4) - 4;
}

/// Freed blocks, kept for later arrays.
class Freed {
   public:
    /// The block of this size that was freed last; null if there is none.
    void* take(std::size_t size) {
        const std::lock_guard lock(mutex_);
        std::deque<Block>& alike = of_size_[number_of(size)];
        if (alike.empty()) return nullptr;
        void* const start = alike.back().start;
        alike.pop_back();
        kept_ -= size;
        return start;
    }

    /// The oldest blocks make room for it.
    void give(void* start, std::size_t size) noexcept {
        const std::lock_guard lock(mutex_);
        try {
            of_size_[number_of(size)].push_back({start, size, ++freed_});
            kept_ += size;
        } catch (const std::bad_alloc&) {
            std::free(start);
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

    void shrink(std::size_t most) noexcept {
        while (kept_ > most) {
            std::deque<Block>& alike = *std::ranges::min_element(of_size_, {}, &Block::first_at);
            std::free(alike.front().start);
            kept_ -= alike.front().size;
            alike.pop_front();
        }
    }

    std::mutex mutex_;
    std::array<std::deque<Block>, 4 * 8 * sizeof(std::size_t)> of_size_;  // by number_of; the oldest first
    std::uint64_t freed_ = 0;
    std::size_t kept_ = 0;
};

Freed& freed() {
    static auto* const blocks = new Freed;  // outlives all arrays
    return *blocks;
}

/// Uninitialized memory from the heap, of a size from size_class; null if there is none. Arrays of large meshes are
/// made of pages of 2 MiB where the system gives such to those who ask: a million pages of 4 KiB to be cleared and
/// entered into its tables are a large part of a first frame, and what reads here and there waits for these tables.
void* from_heap(std::size_t size) {
#ifdef __linux__
    constexpr std::size_t huge_page = std::size_t(2) << 20;
    if (size >= 16 * huge_page) {  // all of which are multiples of it
        void* const found = std::aligned_alloc(huge_page, size);
        if (found) madvise(found, size, MADV_HUGEPAGE);  // a wish: nothing depends on whether it is fulfilled
        return found;
    }
#endif
    return std::malloc(size);
}

}  // namespace

void* allocate_large(std::size_t bytes) {
    if (bytes > SIZE_MAX / 2) throw std::bad_alloc();
    const std::size_t size = size_class(bytes);
    if (void* const found = freed().take(size)) return found;
    if (void* const found = from_heap(size)) return found;
    freed().clear();
    if (void* const found = from_heap(size)) return found;
    throw std::bad_alloc();
}

void free_large(void* memory, std::size_t bytes) noexcept { freed().give(memory, size_class(bytes)); }

void release_large_memory() noexcept { freed().clear(); }

std::size_t large_memory_kept() { return freed().kept(); }

}  // namespace fovea::base
