// SPDX-License-Identifier: GPL-3.0-or-later
// What GoogleTest makes of numbers to print them: compiled once, not in every file of tests. No file includes this; it
// is among the precompiled headers.
#pragma once

#include <gtest/gtest.h>

namespace testing {

extern template std::string PrintToString(const bool&);
extern template std::string PrintToString(const double&);
extern template std::string PrintToString(const float&);
extern template std::string PrintToString(const int&);
extern template std::string PrintToString(const unsigned&);
extern template std::string PrintToString(const unsigned long&);

}  // namespace testing
