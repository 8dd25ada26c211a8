// SPDX-License-Identifier: GPL-3.0-or-later
// Constraints between the members of a record of a style, beyond the range of each member.
#pragma once

#include <fovea/style/style.h>

namespace fovea::style {

// Each throws std::invalid_argument with a sentence that begins with `where`, the path of the record in its file.

void settle(const Transfer& transfer, const Path& where);
void settle(const Distance& distance, const Path& where);
void settle(const FocusPlace& place, const Path& where);
void settle(const Focus& focus, const Path& where);
void settle(const Elision& elision, const Path& where);
void settle(const Hidden& hidden, const Path& where);

/// Also sorts pens of hidden parts by their ranges, and updates the paths of their unknown values.
void settle(LineSet& set, const Path& where, std::vector<Unknown>& unknown);

}  // namespace fovea::style
