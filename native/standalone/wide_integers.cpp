// SPDX-License-Identifier: GPL-3.0-or-later
// The functions that compilers call for integers of 128 bits, as far as Fovea needs them. In the library where zig has
// them are also memset, memcpy, floor and others, which would be taken before those of the C library and are slower:
// with these it is left out (-rtlib=none).
#include <bit>
#include <cstdint>

namespace {

using Wide = unsigned __int128;

int width(Wide x) {
    const auto high = static_cast<std::uint64_t>(x >> 64);
    return high ? 64 + std::bit_width(high) : std::bit_width(static_cast<std::uint64_t>(x));
}

struct Divided {
    Wide quotient, rest;
};

Divided divided(Wide a, Wide b) {
    Divided result{0, a};
    for (int shift = width(a) - width(b); shift >= 0; --shift) {
        result.quotient <<= 1;
        if (result.rest >= b << shift) {
            result.rest -= b << shift;
            result.quotient |= 1;
        }
    }
    return result;
}

}  // namespace

extern "C" {

Wide __udivti3(Wide a, Wide b) { return divided(a, b).quotient; }

Wide __umodti3(Wide a, Wide b) { return divided(a, b).rest; }

/// The nearest double, of two the even one.
double __floattidf(__int128 value) {
    constexpr int kept = 62;  // bits, of which the last one tells whether any beyond them is set
    const Wide size = value < 0 ? -Wide(value) : Wide(value);
    const int beyond = width(size) > kept ? width(size) - kept : 0;
    const bool rest = (size & ((Wide(1) << beyond) - 1)) != 0;
    const auto whole = static_cast<double>(static_cast<std::int64_t>(size >> beyond) | std::int64_t(rest));
    const auto power = std::bit_cast<double>(std::uint64_t(1023 + beyond) << 52);
    return value < 0 ? -whole * power : whole * power;
}
}
