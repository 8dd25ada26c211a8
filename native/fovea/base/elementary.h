// SPDX-License-Identifier: GPL-3.0-or-later
// Elementary functions whose results are the same bits on every machine: those of the system's libm differ between
// systems, their versions and processors. Of sums, products, quotients and square roots in double precision alone,
// which IEEE 754 rounds in one way; errors are below 3 units in the last place.
#pragma once

#include <fovea/base/namespaces.h>

namespace fovea::base {

/// Sine and cosine of an angle in radians; of |angle| up to 1e6 as exact as said above. NaN of what is not finite.
double sine(double angle);
double cosine(double angle);
/// Angle of the direction (x, y) from the x axis, in -pi..pi; 0 of (0, 0).
double angle_of(double y, double x);
/// Arc cosine in 0..pi; of values beyond -1 and 1 that of the nearest one.
double arc_cosine(double value);
/// e to the power of x: 0 below -745, infinity above 709.
double exponential(double x);
/// Natural logarithm; -infinity of 0, NaN below.
double logarithm(double x);
/// x to the power of y, for x >= 0; its error grows with |y log x|. 1 where y is 0, 0 where x is 0 and y is positive.
double power(double x, double y);

}  // namespace fovea::base
