// SPDX-License-Identifier: GPL-3.0-or-later
// What systems do in ways of their own.
#pragma once

#include <cstdio>
#include <filesystem>

namespace fovea::tool {

/// Opens a new file for writing bytes, or an old one, emptied; null, with errno, if that fails.
std::FILE* opened(const std::filesystem::path& file);

/// Waits until the disk has what was written; false, with errno, if that fails.
bool on_disk(std::FILE* stream);

/// The number of this process, which no other one has at the same time.
int process_number();

}  // namespace fovea::tool
