// SPDX-License-Identifier: GPL-3.0-or-later
#include "model_files.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace fovea::model_files {
namespace {

constexpr int quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};

/// Writes values as text or binary.
class Writer {
   public:
    Writer(tool::PlyFormat format, const std::string& line_end) : format_(format), line_end_(line_end) {}

    void put(const std::string& type, double value) {
        if (format_ == tool::PlyFormat::ascii) return void(text += std::to_string(int(value)) + " ");
        if (type == "float") put_bytes(float(value));
        if (type == "double") put_bytes(value);
        if (type == "char" || type == "uchar" || type == "uint8") put_bytes(std::int8_t(value));
        if (type == "short" || type == "ushort") put_bytes(std::int16_t(value));
        if (type == "int" || type == "uint" || type == "int32") put_bytes(std::int32_t(value));
    }
    void end_element() {
        if (format_ == tool::PlyFormat::ascii) text += line_end_;
    }

    std::string text;

   private:
    template <typename Value>
    void put_bytes(Value value) {
        char bytes[sizeof(Value)];
        std::memcpy(bytes, &value, sizeof(Value));
        const bool is_big = format_ == tool::PlyFormat::big_endian;
        if (is_big != (std::endian::native == std::endian::big)) std::reverse(bytes, bytes + sizeof(Value));
        text.append(bytes, sizeof(Value));
    }

    tool::PlyFormat format_;
    std::string line_end_;
};

std::string header(const PlyKind& kind) {
    const char* formats[] = {"ascii", "binary_little_endian", "binary_big_endian"};
    const std::string more = kind.with_more ? "property uchar red\n" : "";
    const std::string marks = kind.with_more ? "element mark 2\nproperty list uchar short of\n" : "";
    std::string text = std::string("ply\nformat ") + formats[int(kind.format)] + " 1.0\ncomment a cube\n" + marks +
                       "element vertex 8\n" + more;
    for (const char* axis : {"x", "y", "z"}) text += std::string("property ") + kind.coordinate + " " + axis + "\n";
    text += std::string("element face 6\n") + more + "property list " + kind.count + " " + kind.index +
            " vertex_indices\nend_header\n";
    for (std::size_t at = 0; kind.line_end != "\n" && (at = text.find('\n', at)) != text.npos;
         at += kind.line_end.size())
        text.replace(at, 1, kind.line_end);
    return text;
}

}  // namespace

std::string cube_obj(const std::string& corner, const std::string& line_end) {
    std::string text = "o cube" + line_end;
    for (int i = 0; i < 8; ++i)
        text +=
            "v " + std::to_string(i & 1) + " " + std::to_string(i >> 1 & 1) + " " + std::to_string(i >> 2) + line_end;
    for (const auto& quad : quads) {
        text += "f";
        for (const int v : quad) {
            std::string word = corner;
            word.replace(word.find('%'), 1, std::to_string(v + 1));
            text += " " + word;
        }
        text += line_end;
    }
    return text;
}

std::string cube_ply(const PlyKind& kind) {
    Writer out(kind.format, kind.line_end);
    out.text = header(kind);
    for (int mark = 0; kind.with_more && mark < 2; ++mark) {
        out.put("uchar", mark);
        for (int i = 0; i < mark; ++i) out.put("short", -300);
        out.end_element();
    }
    for (int i = 0; i < 8; ++i) {
        if (kind.with_more) out.put("uchar", 100 + i);
        for (const int value : {i & 1, i >> 1 & 1, i >> 2}) out.put(kind.coordinate, value);
        out.end_element();
    }
    for (const auto& quad : quads) {
        if (kind.with_more) out.put("uchar", 7);
        out.put(kind.count, 4);
        for (const int v : quad) out.put(kind.index, v);
        out.end_element();
    }
    return out.text;
}

}  // namespace fovea::model_files
