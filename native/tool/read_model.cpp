// SPDX-License-Identifier: GPL-3.0-or-later
#include <tool/read_model.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <tool/read_obj.h>
#include <tool/read_ply.h>
#include <vector>

#include <fovea/base/check.h>
#include <fovea/base/files.h>

namespace fovea::tool {
namespace {

std::string bytes_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    check(!std::filesystem::is_directory(path) && file.is_open(), name_of(path) + " cannot be opened");
    std::string bytes;
    std::vector<char> block(1 << 20);
    while (file.read(block.data(), std::streamsize(block.size())), file.gcount() > 0)
        bytes.append(block.data(), std::size_t(file.gcount()));
    check(!file.bad(), name_of(path) + " cannot be read to its end");
    return bytes;
}

}  // namespace

Model read_model(const std::filesystem::path& path) {
    std::string ending = name_of(path.extension());
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    check(ending == ".obj" || ending == ".ply", name_of(path) + " is neither an .obj nor a .ply file");
    const std::string bytes = bytes_of(path);
    return ending == ".obj" ? read_obj(name_of(path), bytes) : read_ply(name_of(path), bytes);
}

}  // namespace fovea::tool
