// SPDX-License-Identifier: GPL-3.0-or-later
// The header of a PLY file.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace fovea::tool {

enum class PlyFormat { ascii, little_endian, big_endian };

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// Size of a binary value in bytes.
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
    std::size_t size = 0;   ///< size of the header in bytes
    std::size_t lines = 0;  ///< lines of the header
};

/// Parses a header. Throws std::invalid_argument, naming the file and the line, if it is invalid.
PlyHeader ply_header(const std::string& file, std::string_view bytes);

}  // namespace fovea::tool
