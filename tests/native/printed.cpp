// SPDX-License-Identifier: GPL-3.0-or-later
#include "printed.h"

namespace testing {

template std::string PrintToString(const bool&);
template std::string PrintToString(const double&);
template std::string PrintToString(const float&);
template std::string PrintToString(const int&);
template std::string PrintToString(const unsigned&);
template std::string PrintToString(const unsigned long&);

}  // namespace testing
