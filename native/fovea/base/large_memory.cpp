// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/base/large_memory.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <mutex>
#include <new>
#include <vector>

#ifndef FOVEA_LARGE_MEMORY_IN_HEAP
#include <sys/mman.h>
#endif

namespace fovea::base {

#ifdef FOVEA_LARGE_MEMORY_IN_HEAP

void* allocate_large(std::size_t bytes) { return ::operator new(bytes); }

void free_large(void* memory, std::size_t) noexcept { ::operator delete(memory); }

std::size_t large_memory_kept() { return 0; }

#else

namespace {

constexpr std::size_t huge_page = std::size_t(2) << 20;

/// Mapped memory, aligned to huge pages.
struct Block {
    void* start;
    std::size_t size;
};

/// Null if the system has no memory left.
void* mapped(std::size_t size) {
    // A page more than needed, of which the ends before and after the aligned part are returned.
    void* const found = mmap(nullptr, size + huge_page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (found == MAP_FAILED) return nullptr;
    char* const start = static_cast<char*>(found);
    const std::size_t before = (huge_page - reinterpret_cast<std::uintptr_t>(start) % huge_page) % huge_page;
    if (before > 0) munmap(start, before);
    munmap(start + before + size, huge_page - before);
    madvise(start + before, size, MADV_HUGEPAGE);
    return start + before;
}

/// Freed blocks, kept for later arrays.
class Freed {
   public:
    Freed() { blocks_.reserve(keeps_large_memory / large_memory); }

    /// A block of this size; null if there is none.
    void* take(std::size_t size) {
        const std::lock_guard lock(mutex_);
        const auto found = std::ranges::find(blocks_, size, &Block::size);
        if (found == blocks_.end()) return nullptr;
        void* const start = found->start;
        blocks_.erase(found);
        kept_ -= size;
        return start;
    }

    /// The oldest blocks make room for it.
    void give(Block block) noexcept {
        const std::lock_guard lock(mutex_);
        shrink(keeps_large_memory - std::min(block.size, keeps_large_memory));
        if (block.size > keeps_large_memory) {
            munmap(block.start, block.size);
            return;
        }
        blocks_.push_back(block);
        kept_ += block.size;
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
    void shrink(std::size_t size) noexcept {
        const auto end = std::ranges::find_if(blocks_, [&](const Block& block) {
            if (kept_ <= size) return true;
            munmap(block.start, block.size);
            kept_ -= block.size;
            return false;
        });
        blocks_.erase(blocks_.begin(), end);
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
    const std::size_t step = std::max(std::bit_floor(bytes) / 4, huge_page);
    return (bytes + step - 1) / step * step;
}

}  // namespace

void* allocate_large(std::size_t bytes) {
    if (bytes > SIZE_MAX / 2) throw std::bad_alloc();
    const std::size_t size = size_class(bytes);
    if (void* const found = freed().take(size)) return found;
    if (void* const found = mapped(size)) return found;
    freed().clear();
    if (void* const found = mapped(size)) return found;
    throw std::bad_alloc();
}

void free_large(void* memory, std::size_t bytes) noexcept { freed().give({memory, size_class(bytes)}); }

std::size_t large_memory_kept() { return freed().kept(); }

#endif

}  // namespace fovea::base
