// SPDX-License-Identifier: GPL-3.0-or-later
// Reading of small files that may be anything: nothing is read before what it is and its size are known.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace fovea::base {

/// The bytes of a regular file of at most `most` bytes. Throws std::invalid_argument with a sentence that names it and
/// the cause: it is not there, it is none (a folder, a pipe, a device), it is too large, or the system does not give
/// it.
std::string bytes_of_file(const std::filesystem::path& file, std::size_t most);

}  // namespace fovea::base
