// SPDX-License-Identifier: GPL-3.0-or-later
// Names of files, the same on every system, and reading of small files that may be anything: nothing is read before
// what it is and its size are known.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <system_error>

namespace fovea::base {

/// A file's name as text: UTF-8 on Windows, elsewhere its bytes as they are.
std::string name_of(const std::filesystem::path& file);
/// The file of such a name.
std::filesystem::path file_of(const std::string& name);

/// The cause that a system tells, in C's words, which are English everywhere.
std::string cause_of(const std::error_code& problem);

/// The bytes of a regular file of at most `most` bytes. Throws std::invalid_argument with a sentence that names it and
/// the cause: it is not there, it is none (a folder, a pipe, a device), it is too large, or the system does not give
/// it.
std::string bytes_of_file(const std::filesystem::path& file, std::size_t most);

}  // namespace fovea::base
