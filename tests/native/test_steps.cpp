// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers of steps.
#include <gtest/gtest.h>
#include <limits>

#include <fovea/base/steps.h>

using fovea::base::steps_of;

TEST(Steps, AreFromOneToTheirBoundForEveryNumber) {
    const double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
    for (const double less : {-infinity, -1e30, 0.0, 1.0, nan}) EXPECT_EQ(steps_of(less, 100), 1) << less;
    EXPECT_EQ(steps_of(1.5, 100), 2);
    EXPECT_EQ(steps_of(99.5, 100), 100);
    for (const double more : {100.5, 1e10, 1e300, infinity}) EXPECT_EQ(steps_of(more, 100), 100) << more;
}
