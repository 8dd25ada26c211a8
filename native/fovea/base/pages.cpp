// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/base/pages.h>

#include <algorithm>
#include <iterator>
#include <utility>

#if defined(__unix__) || defined(__APPLE__)
#include <atomic>
#include <sys/mman.h>
#endif

namespace fovea::base {

#if defined(__unix__) || defined(__APPLE__)

namespace {

/// Bytes above which there is much. Below, later frames took up to half as long again with pages of 2 MiB, on a virtual
/// machine whose host keeps page tables of its own for it.
constexpr std::size_t much = std::size_t(256) << 20;

std::atomic<std::size_t> mapped = 0;  // bytes, by now

}  // namespace

void* map_pages(std::size_t size) noexcept {
    void* const found = mmap(nullptr, size + page_bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (found == MAP_FAILED) return nullptr;
    auto* const start = static_cast<std::byte*>(found);
    const std::size_t before = (page_bytes - reinterpret_cast<std::uintptr_t>(found) % page_bytes) % page_bytes;
    if (before > 0) munmap(start, before);
    munmap(start + before + size, page_bytes - before);
    if (mapped.fetch_add(size) + size > much) {
#ifdef MADV_HUGEPAGE
        madvise(start + before, size, MADV_HUGEPAGE);  // a wish: nothing depends on whether it is fulfilled
#endif
    }
    return start + before;
}

void unmap_pages(void* start, std::size_t size) noexcept {
    munmap(start, size);
    mapped -= size;
}

#else

void* map_pages(std::size_t) noexcept { return nullptr; }
void unmap_pages(void*, std::size_t) noexcept {}

#endif

void* FreePages::take(std::size_t size) {
    auto best = ranges_.end();
    for (auto range = ranges_.begin(); range != ranges_.end(); ++range)
        if (range->second.size >= size && (best == ranges_.end() || range->second.size < best->second.size))
            best = range;
    if (best == ranges_.end()) return nullptr;
    std::byte* const start = best->first;
    auto node = ranges_.extract(best);
    if (node.mapped().size > size) {
        node.key() += size;
        node.mapped().size -= size;
        ranges_.insert(std::move(node));
    }
    return start;
}

void FreePages::give(void* start, std::size_t size, std::uint64_t now) {
    const auto here = ranges_.insert({static_cast<std::byte*>(start), {size, now}}).first;
    const auto next = std::next(here);
    if (next != ranges_.end() && here->first + here->second.size == next->first) {
        here->second = {size + next->second.size, next->second.at};
        ranges_.erase(next);
    }
    if (here == ranges_.begin()) return;
    const auto before = std::prev(here);
    if (before->first + before->second.size == here->first) {
        before->second = {before->second.size + here->second.size, std::min(before->second.at, here->second.at)};
        ranges_.erase(here);
    }
}

FreePages::Ranges::const_iterator FreePages::oldest_range() const {
    return std::ranges::min_element(ranges_, {}, [](const auto& range) { return range.second.at; });
}

std::uint64_t FreePages::oldest() const { return ranges_.empty() ? UINT64_MAX : oldest_range()->second.at; }

std::size_t FreePages::unmap_oldest(std::size_t most) noexcept {
    const auto range = ranges_.find(oldest_range()->first);
    const std::size_t size = std::min(most, range->second.size);
    range->second.size -= size;
    unmap_pages(range->first + range->second.size, size);
    if (range->second.size == 0) ranges_.erase(range);
    return size;
}

}  // namespace fovea::base
