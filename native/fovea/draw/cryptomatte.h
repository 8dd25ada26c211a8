// SPDX-License-Identifier: GPL-3.0-or-later
// Ids of Cryptomatte (Friedman and Jones, "Fully automatic ID mattes with support for motion blur and transparency",
// SIGGRAPH 2015 posters; specification 1.2.0).
#pragma once

#include <cstdint>
#include <string_view>

namespace fovea::draw {

/// The hash "MurmurHash3_32" of a name in UTF-8, with seed 0.
std::uint32_t murmur_hash(std::string_view name);

/// Bits of the float by which pixels name what has this name, "uint32_to_float32": the hash, with an exponent that is
/// neither of zero nor of infinity.
std::uint32_t cryptomatte_id(std::string_view name);

}  // namespace fovea::draw
