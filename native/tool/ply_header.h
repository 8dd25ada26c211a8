// SPDX-License-Identifier: GPL-3.0-or-later
// What the header of a PLY file says of what follows it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace fovea::tool {

enum class PlyFormat { ascii, little_endian, big_endian };

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// Bytes of a binary value.
int size_of(PlyType type);

struct PlyProperty {
    std::string name;
    PlyType type;
    bool is_list = false;
    PlyType count_type = PlyType::uint8;  ///< of a list
};

struct PlyElement {
    std::string name;
    std::uint64_t count;
    std::vector<PlyProperty> properties;
};

struct PlyHeader {
    PlyFormat format = PlyFormat::ascii;
    std::vector<PlyElement> elements;
    std::size_t size = 0;   ///< bytes up to the first value
    std::size_t lines = 0;  ///< of text
};

/// Throws std::invalid_argument, naming the file and the line, for what is no header.
PlyHeader ply_header(const std::string& file, std::string_view bytes);

}  // namespace fovea::tool
