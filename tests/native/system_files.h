// SPDX-License-Identifier: GPL-3.0-or-later
// Files of tests, and kinds of files that not every system has: what makes those says whether it did.
#pragma once

#include <filesystem>
#include <string>
#include <tool/system.h>

#if __has_include(<sys/resource.h>)
#include <csignal>
#include <sys/resource.h>
#include <sys/stat.h>
#define FOVEA_POSIX_FILES 1
#endif

namespace fovea {

/// A path that no other test process has; nothing is there yet.
inline std::filesystem::path own_path(const std::string& name) {
    return std::filesystem::temp_directory_path() / ("fovea-" + name + "-" + std::to_string(tool::process_number()));
}

/// A symbolic link. Windows lets only some users make them, and Wine makes none.
inline bool make_link(const std::filesystem::path& to, const std::filesystem::path& file) {
    std::error_code problem;
    std::filesystem::create_symlink(to, file, problem);
    return !problem && std::filesystem::is_symlink(file, problem);
}

#ifdef FOVEA_POSIX_FILES

/// A pipe with a name.
inline bool make_pipe(const std::filesystem::path& file) { return mkfifo(file.c_str(), 0600) == 0; }

/// While it lives, files of this process become no larger.
class FileLimit {
   public:
    explicit FileLimit(std::size_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit{bytes, before_.rlim_max};
        holds_ = setrlimit(RLIMIT_FSIZE, &limit) == 0;
    }
    FileLimit(const FileLimit&) = delete;
    ~FileLimit() {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }
    bool holds() const { return holds_; }

   private:
    void (*handler_)(int);
    rlimit before_{};
    bool holds_;
};

#else

inline bool make_pipe(const std::filesystem::path&) { return false; }

struct FileLimit {
    explicit FileLimit(std::size_t) {}
    bool holds() const { return false; }
};

#endif

}  // namespace fovea
