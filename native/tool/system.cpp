// SPDX-License-Identifier: GPL-3.0-or-later
#include <tool/system.h>

#ifdef _WIN32
#include <io.h>
#include <process.h>
#else
#include <unistd.h>
#endif

namespace fovea::tool {

#ifdef _WIN32

std::FILE* opened(const std::filesystem::path& file) { return _wfopen(file.c_str(), L"wb"); }
bool on_disk(std::FILE* stream) { return std::fflush(stream) == 0 && _commit(_fileno(stream)) == 0; }
int process_number() { return _getpid(); }

#else

std::FILE* opened(const std::filesystem::path& file) { return std::fopen(file.c_str(), "wb"); }
bool on_disk(std::FILE* stream) { return std::fflush(stream) == 0 && fsync(fileno(stream)) == 0; }
int process_number() { return getpid(); }

#endif

}  // namespace fovea::tool
