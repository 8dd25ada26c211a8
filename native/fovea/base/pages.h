// SPDX-License-Identifier: GPL-3.0-or-later
// Memory from the system itself, in pages of 2 MiB.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>

#include <fovea/base/namespaces.h>

namespace fovea::base {

#if defined(__unix__) || defined(__APPLE__)
inline constexpr bool has_pages = true;
#else
inline constexpr bool has_pages = false;
#endif

inline constexpr std::size_t page_bytes = std::size_t(2) << 20;

/// `size` uninitialized bytes, a multiple of page_bytes, that start at one; null if there are none. Thread-safe. Where
/// much is mapped by then, the system is asked to back it with pages of 2 MiB of its own: a million pages of 4 KiB to
/// be cleared and entered into its tables are a large part of a first frame of a large mesh, and what reads here and
/// there waits for these tables.
void* map_pages(std::size_t size) noexcept;

/// Any part of what map_pages has given, of whole pages.
void unmap_pages(void* start, std::size_t size) noexcept;

/// Pages to be used again. Neighbors join, so that they serve arrays of any size. Not thread-safe.
class FreePages {
   public:
    /// The front of the smallest range of at least `size` bytes, which it leaves; null if there is none.
    void* take(std::size_t size);
    /// `now`: a number that increases from call to call. Throws std::bad_alloc, and has then taken nothing.
    void give(void* start, std::size_t size, std::uint64_t now);
    /// The least `now` of all that was given and is left in part; the greatest number if nothing is.
    std::uint64_t oldest() const;
    /// Unmaps pages at the end of the range that has it: `most` bytes, or all there are. Returns how many. Something
    /// must be left.
    std::size_t unmap_oldest(std::size_t most) noexcept;

   private:
    struct Range {
        std::size_t size;
        std::uint64_t at;  // the least `now` of what it was joined from
    };
    using Ranges = std::map<std::byte*, Range>;

    Ranges::const_iterator oldest_range() const;

    Ranges ranges_;  // by start; none touches the next
};

}  // namespace fovea::base
