// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/base/elementary.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include <fovea/base/types.h>

namespace fovea::base {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// As std::nearbyint, for |x| below 2^51; that is a call of a function for processors without SSE 4.1.
double nearest_whole(double x) {
    constexpr double shift = 0x1.8p52;  // between it and its double, doubles are 1 apart
    return std::copysign((x + shift) - shift, x);
}

/// As std::ldexp, which is a call of a function: x times 2 to the power of `doublings`, for x from 0.5 to 2.
double doubled(double x, int doublings) {
    if (doublings < -1021 || doublings > 1022) return std::ldexp(x, doublings);
    return x * std::bit_cast<double>(std::uint64_t(doublings + 1023) << 52);
}

/// Sum of some terms of a power series, divided by x to the power of `First`. `power`: x, x^2, x^4 and x^8. Halves are
/// summed up side by side, as the steps of Horner's scheme would wait for each other (Estrin 1960).
template <std::size_t First, std::size_t Terms, std::size_t Count>
double terms(const std::array<double, Count>& of, const std::array<double, 4>& power) {
    if constexpr (Terms == 1) {
        return of[First];
    } else {
        constexpr std::size_t low = std::bit_floor(Terms - 1);
        return terms<First, low>(of, power) + terms<First + low, Terms - low>(of, power) * power[std::countr_zero(low)];
    }
}

/// Coefficients of a power series, from the lowest one; each is computed by the compiler, exactly rounded. The first
/// three, which decide about the error, are summed up last and in turn.
template <std::size_t Count>
double series(const std::array<double, Count>& of, double x) {
    static_assert(Count > 4 && Count <= 19);
    const double square = x * x, fourth = square * square;
    const double tail = terms<3, Count - 3>(of, {x, square, fourth, fourth * fourth});
    return of[0] + x * (of[1] + x * (of[2] + x * tail));
}

/// (-1)^i / (2 i + first)!: sine and cosine in the square of the angle.
template <std::size_t Count>
constexpr std::array<double, Count> alternating(int first) {
    std::array<double, Count> result{};
    double factorial = 1.0;
    for (int i = 2; i <= first; ++i) factorial *= i;
    for (int i = 0; i < int(Count); ++i) {
        result[i] = (i % 2 ? -1.0 : 1.0) / factorial;
        factorial *= (2.0 * i + first + 1.0) * (2.0 * i + first + 2.0);
    }
    return result;
}

/// An angle as a whole number of right angles, modulo 4, and the rest in -pi/4..pi/4.
struct Turned {
    int quarter;
    double rest;

    explicit Turned(double angle) {
        // pi/2 in three parts, of which the first two have 33 bits: their products by the number of turns are exact.
        constexpr double first = 0x1.921fb544p+0, second = 0x1.0b4611a6p-34, third = 0x1.3198a2e037073p-69;
        const double turns = nearest_whole(angle * (2.0 / std::numbers::pi));
        quarter = static_cast<int>(static_cast<long long>(turns) & 3);
        rest = ((angle - turns * first) - turns * second) - turns * third;
    }
    double sine_of_rest() const {
        static constexpr auto of = alternating<9>(1);
        return rest * series(of, rest * rest);
    }
    double cosine_of_rest() const {
        static constexpr auto of = alternating<10>(0);
        return series(of, rest * rest);
    }
};

bool turns(double angle) { return std::abs(angle) <= 1e15; }

/// Arc tangent for |x| up to 1/16.
double small_arc(double x) {
    static constexpr std::array<double, 8> of{1.0,       -1.0 / 3.0,  1.0 / 5.0,  -1.0 / 7.0,
                                              1.0 / 9.0, -1.0 / 11.0, 1.0 / 13.0, -1.0 / 15.0};
    return x * series(of, x * x);
}

/// Arc tangent of share / whole, for 0 <= share <= whole.
double arc_of(double share, double whole) {
    // atan(i / 8), i = 0..8
    static constexpr double eighths[] = {0.0,
                                         0.12435499454676143503,
                                         0.24497866312686415417,
                                         0.35877067027057222040,
                                         0.46364760900080611621,
                                         0.55859931534356243597,
                                         0.64350110879328438680,
                                         0.71882999962162450542,
                                         0.78539816339744830962};
    const double at = nearest_whole(8.0 * (share / whole)), c = at / 8.0;
    return eighths[static_cast<int>(at)] + small_arc((share - c * whole) / (whole + c * share));
}

constexpr double ln2_high = 0x1.62e42fefa38p-1, ln2_low = 0x1.ef35793c7673p-45;

}  // namespace

double sine(double angle) {
    if (!turns(angle)) return nothing;
    const Turned turned(angle);
    const double of = turned.quarter % 2 ? turned.cosine_of_rest() : turned.sine_of_rest();
    return turned.quarter >= 2 ? -of : of;
}

double cosine(double angle) {
    if (!turns(angle)) return nothing;
    const Turned turned(angle);
    const double of = turned.quarter % 2 ? turned.sine_of_rest() : turned.cosine_of_rest();
    return turned.quarter == 1 || turned.quarter == 2 ? -of : of;
}

double angle_of(double y, double x) {
    const double along = std::abs(x), across = std::abs(y);
    if (std::isnan(along) || std::isnan(across)) return nothing;
    if (across == 0.0) return std::copysign(std::signbit(x) && x != 0.0 ? std::numbers::pi : 0.0, y);
    double angle;
    if (std::isinf(along) || std::isinf(across))
        angle = std::isinf(along) ? (std::isinf(across) ? std::numbers::pi / 4 : 0.0) : std::numbers::pi / 2;
    else
        angle = across <= along ? arc_of(across, along) : std::numbers::pi / 2 - arc_of(along, across);
    if (x < 0.0) angle = std::numbers::pi - angle;
    return std::copysign(angle, y);
}

double arc_cosine(double value) {
    const double inside = std::clamp(value, -1.0, 1.0);
    return 2.0 * angle_of(std::sqrt(1.0 - inside), std::sqrt(1.0 + inside));
}

double exponential(double x) {
    if (std::isnan(x)) return nothing;
    if (x > 709.782712893384) return infinity;
    if (x < -745.2) return 0.0;
    static constexpr auto of = [] {
        std::array<double, 15> result{};
        double factorial = 1.0;
        for (int i = 0; i < 15; ++i) {
            result[i] = 1.0 / factorial;
            factorial *= i + 1;
        }
        return result;
    }();
    const double doublings = nearest_whole(x * std::numbers::log2e);
    const double rest = (x - doublings * ln2_high) - doublings * ln2_low;
    return doubled(series(of, rest), static_cast<int>(doublings));
}

double logarithm(double x) {
    if (!(x > 0.0)) return x == 0.0 ? -infinity : nothing;
    if (std::isinf(x)) return x;
    int exponent;
    double mantissa = std::frexp(x, &exponent);  // 0.5..1
    if (mantissa < std::numbers::sqrt2 / 2) {
        mantissa *= 2.0;
        --exponent;
    }
    // 2 atanh(s), s = (m - 1) / (m + 1)
    static constexpr auto of = [] {
        std::array<double, 12> result{};
        for (int i = 0; i < 12; ++i) result[i] = 2.0 / (2 * i + 1);
        return result;
    }();
    const double s = (mantissa - 1.0) / (mantissa + 1.0);
    return exponent * ln2_high + (s * series(of, s * s) + exponent * ln2_low);
}

double power(double x, double y) {
    if (y == 0.0) return 1.0;
    if (x == 0.0) return y > 0.0 ? 0.0 : infinity;
    return exponential(y * logarithm(x));
}

}  // namespace fovea::base
