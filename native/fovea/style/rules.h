// SPDX-License-Identifier: GPL-3.0-or-later
// What must hold between the members of a record of a style, whatever each of them may be.
#pragma once

#include <fovea/style/style.h>

namespace fovea::style {

// Each throws std::invalid_argument with a sentence that begins with the place `where` the record stands in its file.

void settle(const Transfer& transfer, const Path& where);
void settle(const Distance& distance, const Path& where);
void settle(const FocusPlace& place, const Path& where);
void settle(const Focus& focus, const Path& where);
void settle(const Elision& elision, const Path& where);
void settle(const Hidden& hidden, const Path& where);

/// Brings pens of hidden parts into the order of their ranges; what is not known of them moves with them.
void settle(LineSet& set, const Path& where, std::vector<Unknown>& unknown);

}  // namespace fovea::style
