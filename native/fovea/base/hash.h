// SPDX-License-Identifier: GPL-3.0-or-later
// Content hashes: cache keys depend on what data contains, never on its address.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <fovea/base/namespaces.h>

namespace fovea::base {

/// 64-bit hash of bytes (XXH3).
std::uint64_t hash_bytes(const void* data, std::size_t size, std::uint64_t seed = 0);

/// The same, in parallel where there are many bytes, of which it is another number than hash_bytes has.
std::uint64_t hash_many_bytes(const void* data, std::size_t size);

template <typename T>
std::uint64_t hash_of(std::span<const T> values, std::uint64_t seed = 0) {
    return hash_bytes(values.data(), values.size_bytes(), seed);
}

/// Hash of the values, converted to 64 bits each; depends on their order.
template <typename... T>
std::uint64_t hash_numbers(T... values) {
    const std::uint64_t words[] = {static_cast<std::uint64_t>(values)...};
    return hash_bytes(words, sizeof(words));
}

}  // namespace fovea::base
