// SPDX-License-Identifier: GPL-3.0-or-later
// The choices that an input consists of, drawn from its seed: the same on every machine, unlike the distributions of
// the standard library.
#pragma once

#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>

#include <fovea/base/hash.h>
#include <fovea/base/types.h>

namespace fovea::fuzz {
using namespace draw;

class Choices {
   public:
    explicit Choices(std::uint64_t seed) : seed_(seed) {}

    std::uint64_t bits() { return hash_numbers(seed_, count_++); }
    /// 0 .. count - 1.
    int below(int count) { return static_cast<int>(bits() % std::uint64_t(count)); }
    int between(int least, int most) { return least + below(most - least + 1); }
    double between(double least, double most) { return least + (most - least) * (double(bits() >> 11) * 0x1p-53); }
    bool chance(double share) { return between(0.0, 1.0) < share; }
    /// A power of ten.
    double size(double least, double most) { return std::pow(10.0, between(least, most)); }
    /// About -1 to 1, both small and large.
    double about_one() { return between(-1.0, 1.0) * (chance(0.1) ? size(-6.0, 2.0) : 1.0); }

    template <typename Values>
    const auto& one_of(const Values& values) {
        return *(std::begin(values) + below(static_cast<int>(std::size(values))));
    }
    template <typename T>
    T one_of(std::initializer_list<T> values) {
        return *(values.begin() + below(static_cast<int>(values.size())));
    }

    /// A number that nobody means.
    double broken() {
        constexpr double inf = std::numeric_limits<double>::infinity();
        return one_of({std::numeric_limits<double>::quiet_NaN(), inf, -inf, 0.0, -0.0, -1.0, 1e-45, 1e-20, 1e9, 1e18,
                       -1e30, 3e38, 1e300});
    }

   private:
    std::uint64_t seed_, count_ = 0;
};

}  // namespace fovea::fuzz
