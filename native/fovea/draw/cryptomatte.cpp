// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/draw/cryptomatte.h>

#include <algorithm>
#include <bit>

namespace fovea::draw {

std::uint32_t murmur_hash(std::string_view name) {
    // MurmurHash3_x86_32 (Appleby 2011), byte order independent.
    std::uint32_t hash = 0;
    for (std::size_t begin = 0; begin < name.size(); begin += 4) {
        const std::string_view block = name.substr(begin, 4);
        std::uint32_t word = 0;
        for (std::size_t i = 0; i < block.size(); ++i) word |= std::uint32_t(std::uint8_t(block[i])) << (8 * i);
        hash ^= std::rotl(word * 0xcc9e2d51u, 15) * 0x1b873593u;
        if (block.size() == 4) hash = std::rotl(hash, 13) * 5 + 0xe6546b64u;
    }
    hash ^= std::uint32_t(name.size());
    hash = (hash ^ (hash >> 16)) * 0x85ebca6bu;
    hash = (hash ^ (hash >> 13)) * 0xc2b2ae35u;
    return hash ^ (hash >> 16);
}

std::uint32_t cryptomatte_id(std::string_view name) {
    const std::uint32_t hash = murmur_hash(name);
    const std::uint32_t exponent = std::clamp((hash >> 23) & 255u, 1u, 254u);
    return (hash & ~(255u << 23)) | (exponent << 23);
}

}  // namespace fovea::draw
