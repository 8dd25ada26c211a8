// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/base/files.h>

#include <fstream>

#include <fovea/base/check.h>

namespace fovea::base {

std::string name_of(const std::filesystem::path& file) {
    const std::u8string name = file.u8string();
    return std::string(name.begin(), name.end());
}

std::filesystem::path file_of(const std::string& name) { return std::u8string(name.begin(), name.end()); }

std::string cause_of(const std::error_code& problem) { return problem.default_error_condition().message(); }

std::string bytes_of_file(const std::filesystem::path& file, std::size_t most) {
    const auto hold = [&](bool holds, const std::string& cause) {
        check(holds, name_of(file.c_str()) + " cannot be read: " + cause);
    };
    hold(file.native().find(std::filesystem::path::value_type()) == file.native().npos, "its name has a zero");
    std::error_code problem;
    const auto status = std::filesystem::status(file, problem);
    hold(!problem, cause_of(problem));
    hold(std::filesystem::is_regular_file(status), "it is no file");
    const std::string too_large = "it has more than " + std::to_string(most >> 20) + " MB";
    hold(std::filesystem::file_size(file, problem) <= most, problem ? cause_of(problem) : too_large);
    std::ifstream stream(file, std::ios::binary);
    std::string bytes(most + 1, '\0');  // sizes of files of the system are not true
    stream.read(bytes.data(), std::streamsize(bytes.size()));
    hold(!stream.bad() && (stream.eof() || stream.good()), "the system does not give it");
    hold(std::size_t(stream.gcount()) <= most, too_large);
    bytes.resize(std::size_t(stream.gcount()));
    return bytes;
}

}  // namespace fovea::base
