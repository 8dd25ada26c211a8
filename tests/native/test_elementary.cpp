// SPDX-License-Identifier: GPL-3.0-or-later
// Elementary functions against those of the system, in higher precision, and the bits of some of their results, which
// are the same on every machine.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

#include <fovea/base/elementary.h>
#include <fovea/base/hash.h>

using namespace fovea::base;

namespace {

/// Places from -size to size, denser around 0, irregular in their last bits.
std::vector<double> places(double size) {
    std::vector<double> all{0.0};
    for (int i = 1; i <= 4000; ++i) {
        const double share = i / 4000.0, x = size * share * share * share * (1.0 + 1e-9 * i);
        all.push_back(x);
        all.push_back(-x);
    }
    return all;
}

/// Distance from the exact value, in units in the last place of `value`, not less than that of `least`.
double units_off(double value, long double exact, double least = 0.0) {
    const double size = std::max({std::abs(value), least, 1e-300});
    return double(std::abs(value - exact) / (std::nextafter(size, HUGE_VAL) - size));
}

}  // namespace

TEST(Elementary, SineAndCosineAreWithinTwoUnits) {
    for (const double x : places(1000.0)) {
        EXPECT_LT(units_off(sine(x), std::sin((long double)x), 1e-3), 2.0) << x;
        EXPECT_LT(units_off(cosine(x), std::cos((long double)x), 1e-3), 2.0) << x;
    }
}

TEST(Elementary, AnglesOfDirectionsAreWithinTwoUnits) {
    for (const double x : places(10.0))
        for (const double y : {1e-8, 0.1, 0.7, 1.0, 3.0, -2.0})
            EXPECT_LT(units_off(angle_of(y, x), std::atan2((long double)y, (long double)x)), 2.0) << y << " " << x;
    for (const double x : places(0.99999))
        EXPECT_LT(units_off(arc_cosine(x), std::acos((long double)x), 0.1), 4.0) << x;
}

TEST(Elementary, ExponentialsAreWithinTwoUnitsAndLogarithmsWithinThree) {
    for (const double x : places(700.0)) EXPECT_LT(units_off(exponential(x), std::exp((long double)x)), 2.0) << x;
    for (const double x : places(300.0)) {
        const double of = std::exp(x);
        EXPECT_LT(units_off(logarithm(of), std::log((long double)of), 0.1), 3.0) << x;
    }
}

TEST(Elementary, PowersOfSinglePrecisionAreExact) {
    for (int i = 0; i <= 2000; ++i) {
        const float x = float(i) / 2000.0f;
        for (const double y : {2.4, 1.0 / 2.4, 0.3, 7.0})
            EXPECT_EQ(float(power(x, y)), float(std::pow((long double)x, (long double)y))) << x << " " << y;
    }
}

TEST(Elementary, EndsAreAsInIeee754) {
    constexpr double endless = std::numeric_limits<double>::infinity(), none = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(exponential(-endless), 0.0);
    EXPECT_EQ(exponential(endless), endless);
    EXPECT_EQ(logarithm(0.0), -endless);
    EXPECT_EQ(logarithm(endless), endless);
    EXPECT_EQ(power(0.0, 2.0), 0.0);
    EXPECT_EQ(power(0.0, 0.0), 1.0);
    EXPECT_EQ(angle_of(0.0, 0.0), 0.0);
    EXPECT_EQ(angle_of(0.0, -1.0), std::numbers::pi);
    EXPECT_EQ(angle_of(endless, 1.0), std::numbers::pi / 2);
    EXPECT_EQ(arc_cosine(1.5), 0.0);
    EXPECT_EQ(arc_cosine(-1.5), std::numbers::pi);
    for (const double value : {sine(endless), cosine(none), logarithm(-1.0), exponential(none), angle_of(none, 1.0)})
        EXPECT_TRUE(std::isnan(value));
}

TEST(Elementary, HaveTheSameBitsEverywhere) {
    std::uint64_t hash = 0;
    for (const double x : places(20.0)) {
        const double results[] = {sine(x),
                                  cosine(x),
                                  angle_of(x, 1.25),
                                  arc_cosine(x / 20.1),
                                  exponential(x),
                                  logarithm(std::abs(x) + 1e-9),
                                  power(std::abs(x), 0.7)};
        hash = hash_bytes(results, sizeof(results), hash);
    }
    EXPECT_EQ(hash, 11078781004727748029u);
}
