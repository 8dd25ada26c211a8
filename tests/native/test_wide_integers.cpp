// SPDX-License-Identifier: GPL-3.0-or-later
// Integers of 128 bits, whose division and conversion are functions of a compiler's library, or of
// native/standalone/wide_integers.cpp.
#include <bit>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <random>
#include <vector>

namespace {

using Wide = __int128;
using Bits = unsigned __int128;

/// Of all sizes, with runs of bits; also the least and the greatest.
std::vector<Bits> numbers() {
    std::mt19937_64 random(5);
    std::vector<Bits> all{0, 1, 2, ~Bits(0), Bits(1) << 127, (Bits(1) << 127) - 1, Bits(~std::uint64_t(0))};
    for (int width = 1; width <= 128; ++width) {
        const Bits any = Bits(random()) << 64 | random();
        const Bits one = Bits(1) << (width - 1);
        for (const Bits x : {any >> (128 - width), one, one - 1, one + 1, one | one >> 53, one | one >> 53 | 1})
            all.push_back(x);
    }
    return all;
}

Wide distance(Wide a, Wide b) { return a < b ? b - a : a - b; }

}  // namespace

TEST(WideIntegers, AreDividedWithARestBelowTheDivisor) {
    for (const Bits a : numbers())
        for (const Bits b : numbers()) {
            if (b == 0) continue;
            volatile Bits dividend = a, divisor = b;  // else the compiler may know the result
            const Bits quotient = dividend / divisor, rest = dividend % divisor;
            ASSERT_TRUE(rest < b && quotient * b + rest == a && (quotient == 0 || b <= a / quotient));
        }
}

TEST(WideIntegers, BecomeTheNearestDoubleOfTwoTheEvenOne) {
    for (const Bits size : numbers()) {
        if (size >> 126) continue;
        for (const Wide value : {Wide(size), -Wide(size)}) {
            volatile Wide exact = value;
            const auto found = static_cast<double>(exact);
            const Wide off = distance(static_cast<Wide>(found), value);
            for (const double beside : {std::nextafter(found, -HUGE_VAL), std::nextafter(found, HUGE_VAL)}) {
                if (std::abs(beside) < 0x1p53) continue;  // whole numbers below are exact
                const Wide other = distance(static_cast<Wide>(beside), value);
                ASSERT_TRUE(off < other || (off == other && (std::bit_cast<std::uint64_t>(found) & 1) == 0)) << found;
            }
            ASSERT_TRUE(std::abs(found) >= 0x1p53 || off == 0) << found;
        }
    }
}
