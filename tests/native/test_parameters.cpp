// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters of line definitions as structs with named members.
#include <gtest/gtest.h>

#include <fovea/line/registry.h>

using namespace fovea;
using namespace fovea::draw;

namespace {

struct Base {
    double threshold;
};
struct Example : Base {
    int count;
    bool closed;
    double angle;
};

const Parameters<Example> parameters =
    Parameters<Example>{{&Example::threshold, "threshold", "Threshold", 0.5, 0.0, 1.0, Unit::none, "A number"},
                        {&Example::count, "count", "Count", 10, 1, 100, "A whole number"}}
        .with({{&Example::closed, "closed", "Closed", true, "A switch"},
               {&Example::angle, "angle", "Angle", 30.0, 0.0, 180.0, Unit::degrees, "An angle", Per::object}});

}  // namespace

TEST(Parameters, EachValueIsReadIntoTheMemberThatItWasDeclaredWith) {
    const Example read = parameters.read({0.25, 7.9, 0.0, 45.0});
    EXPECT_EQ(read.threshold, 0.25);
    EXPECT_EQ(read.count, 7) << "whole numbers are cut off";
    EXPECT_FALSE(read.closed);
    EXPECT_EQ(read.angle, 45.0);
    EXPECT_TRUE(parameters.read({0, 0, 0.5, 0}).closed) << "a switch is on unless it is 0";
}

TEST(Parameters, AreDeclaredInTheirOrderWithLimitsUnitsAndDefaultsByTheirKind) {
    const std::vector<Parameter> declared = parameters;
    ASSERT_EQ(declared.size(), 4u);
    EXPECT_STREQ(declared[1].name, "count");
    EXPECT_EQ(declared[1].value, 10.0);
    EXPECT_EQ(declared[2].unit, Unit::boolean);
    EXPECT_EQ(declared[2].low, 0.0);
    EXPECT_EQ(declared[2].value, 1.0);
    EXPECT_EQ(declared[3].unit, Unit::degrees);
    EXPECT_EQ(declared[3].per, Per::object);
    EXPECT_EQ(declared[0].per, Per::line_set);
}

TEST(Parameters, AFunctionOfTheStructIsCalledWithValuesInItsPlace) {
    const std::function<double(double, const Values&, int&)> called =
        parameters.of([](double factor, const Example& example, int& calls) {
            ++calls;
            return factor * example.angle;
        });
    int calls = 0;
    EXPECT_EQ(called(2.0, {0, 0, 0, 45.0}, calls), 90.0);
    EXPECT_EQ(calls, 1) << "other arguments are passed on, not copied";
}

TEST(Parameters, MoreOrFewerValuesThanADefinitionHasAreRefused) {
    EXPECT_THROW(parameters.read({1.0}), std::invalid_argument);
    EXPECT_THROW(parameters.read({1.0, 2.0, 3.0, 4.0, 5.0}), std::invalid_argument);
}
