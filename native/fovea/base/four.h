// SPDX-License-Identifier: GPL-3.0-or-later
// Four numbers at once: vectors of the compiler, which become registers where the processor has them (SSE, NEON).
#pragma once

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include <bit>

#include <fovea/base/types.h>

namespace fovea::base {

using Four = float __attribute__((vector_size(16)));
/// Of a comparison: all bits of a lane are set where it holds.
using FourInts = std::int32_t __attribute__((vector_size(16)));

inline Four four(float value) { return Four{} + value; }
inline FourInts four_ints(std::int32_t value) { return FourInts{} + value; }
inline Four size_of(Four a) { return std::bit_cast<Four>(std::bit_cast<FourInts>(a) & 0x7fffffff); }

/// a < b ? a : b and a > b ? a : b: b where one is NaN.
inline Four lesser(Four a, Four b) {
#ifdef __SSE2__
    return _mm_min_ps(a, b);
#else
    return a < b ? a : b;
#endif
}
inline Four greater(Four a, Four b) {
#ifdef __SSE2__
    return _mm_max_ps(a, b);
#else
    return a > b ? a : b;
#endif
}

/// Bit i is set where lane i of a comparison holds.
inline unsigned bits(FourInts held) {
#ifdef __SSE2__
    return static_cast<unsigned>(_mm_movemask_ps(std::bit_cast<Four>(held)));
#else
    const FourInts of_lanes = held & FourInts{1, 2, 4, 8};
    return static_cast<unsigned>(of_lanes[0] | of_lanes[1] | of_lanes[2] | of_lanes[3]);
#endif
}

/// Calls body(lane) for every set bit, ascending.
template <typename Body>
void for_each_lane(unsigned bits, const Body& body) {
    for (; bits != 0; bits &= bits - 1) body(std::countr_zero(bits));
}

}  // namespace fovea::base
