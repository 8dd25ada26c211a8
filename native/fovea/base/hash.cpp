// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/base/hash.h>

#include <algorithm>
#include <xxhash.h>

#include <fovea/base/parallel.h>

namespace fovea::base {

std::uint64_t hash_bytes(const void* data, std::size_t size, std::uint64_t seed) {
    return XXH3_64bits_withSeed(data, size, seed);
}

std::uint64_t hash_many_bytes(const void* data, std::size_t size) {
    constexpr std::size_t block = 1 << 18;
    if (size <= block) return hash_bytes(data, size);
    const auto* bytes = static_cast<const char*>(data);
    const auto hashes = parallel_map<std::uint64_t>((size + block - 1) / block, [&](std::size_t i) {
        return hash_bytes(bytes + i * block, std::min(block, size - i * block));
    });
    return hash_of(std::span<const std::uint64_t>(hashes), size);
}

}  // namespace fovea::base
