// SPDX-License-Identifier: GPL-3.0-or-later
// Memory of large arrays: images, and what is computed of surfaces and lines.
#pragma once

#include <cstddef>

#include <fovea/base/sanitizers.h>

namespace fovea::base {

/// Bytes from which arrays take memory here instead of from the heap. Not more than oneTBB's heap takes for large,
/// which Blender has on some systems: it gives Blender's own images back to the system, so that each picture takes them
/// anew, page by page, where some hundred large blocks were taken and freed since.
inline constexpr std::size_t large_memory = 8000;

/// Bytes of freed memory that are kept for the next arrays; 0: they take all from the heap, where overruns are found.
#ifdef FOVEA_ADDRESS_SANITIZER
inline constexpr std::size_t keeps_large_memory = 0;
#else
inline constexpr std::size_t keeps_large_memory = std::size_t(256) << 20;
#endif

/// Whether an array of so many bytes takes its memory here.
constexpr bool is_large(std::size_t bytes) { return keeps_large_memory > 0 && bytes >= large_memory; }

/// Uninitialized memory, aligned for any type. Every frame needs the same arrays, and a heap returns large blocks to
/// the system, which clears each page again when it is touched: so freed blocks are kept for later ones.
/// Thread-safe. Throws std::bad_alloc.
void* allocate_large(std::size_t bytes);

/// Of a pointer from allocate_large, with the same number of bytes.
void free_large(void* memory, std::size_t bytes) noexcept;

/// Bytes of freed memory that are kept now.
std::size_t large_memory_kept();

}  // namespace fovea::base
