// SPDX-License-Identifier: GPL-3.0-or-later
#include <tool/ply_header.h>

#include <charconv>
#include <map>
#include <tool/model.h>
#include <tool/text.h>

namespace fovea::tool {
namespace {

const std::map<std::string_view, PlyFormat> formats = {
    {"ascii", PlyFormat::ascii},
    {"binary_little_endian", PlyFormat::little_endian},
    {"binary_big_endian", PlyFormat::big_endian},
};

const std::map<std::string_view, PlyType> types = {
    {"char", PlyType::int8},      {"int8", PlyType::int8},       {"uchar", PlyType::uint8},
    {"uint8", PlyType::uint8},    {"short", PlyType::int16},     {"int16", PlyType::int16},
    {"ushort", PlyType::uint16},  {"uint16", PlyType::uint16},   {"int", PlyType::int32},
    {"int32", PlyType::int32},    {"uint", PlyType::uint32},     {"uint32", PlyType::uint32},
    {"float", PlyType::float32},  {"float32", PlyType::float32}, {"double", PlyType::float64},
    {"float64", PlyType::float64}};

class HeaderReader {
   public:
    HeaderReader(const std::string& file, std::string_view bytes) : file_(file), bytes_(bytes) {}

    PlyHeader read() {
        if (trimmed(line()) != "ply") fail("a PLY file begins with a line 'ply'");
        bool has_format = false;
        for (;;) {
            std::string_view rest = line();
            const std::string_view key = take_word(rest);
            if (key == "end_header") break;
            if (key == "format") {
                header_.format = known(formats, take_word(rest), "format");
                has_format = true;
            } else if (key == "element") {
                header_.elements.push_back(element(rest));
            } else if (key == "property") {
                if (header_.elements.empty()) fail("a property comes before any element");
                header_.elements.back().properties.push_back(property(rest));
            } else if (!key.empty() && key != "comment" && key != "obj_info") {
                fail("a PLY header has no '" + shown(key) + "'");
            }
        }
        if (!has_format) fail("the header ends without a format");
        header_.size = at_;
        return std::move(header_);
    }

   private:
    [[noreturn]] void fail(const std::string& what) const { refuse(file_, "line", header_.lines, what); }

    /// A word of the file, sanitized for messages.
    static std::string shown(std::string_view word) {
        std::string text(word.substr(0, 40));
        for (char& c : text)
            if (c < ' ' || c > '~') c = '?';
        return text;
    }

    /// The header's next line. Only \n ends a line, because binary data may follow the last one.
    std::string_view line() {
        ++header_.lines;
        const std::size_t end = bytes_.find('\n', at_);
        if (end == bytes_.npos) fail("the file ends before its header does");
        const std::string_view found = bytes_.substr(at_, end - at_);
        at_ = end + 1;
        return found;
    }

    template <typename Value>
    Value known(const std::map<std::string_view, Value>& names, std::string_view word, const char* what) const {
        const auto found = names.find(word);
        if (found == names.end()) fail("there is no " + std::string(what) + " '" + shown(word) + "'");
        return found->second;
    }

    PlyElement element(std::string_view rest) const {
        const std::string_view name = take_word(rest), number = take_word(rest);
        std::uint64_t count = 0;
        const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), count);
        if (error != std::errc() || end != number.data() + number.size())
            fail("'" + shown(number) + "' is no number of elements '" + shown(name) + "'");
        return {std::string(name), count, {}};
    }

    PlyProperty property(std::string_view rest) const {
        PlyProperty made;
        std::string_view word = take_word(rest);
        made.is_list = word == "list";
        if (made.is_list) {
            made.count_type = known(types, take_word(rest), "type");
            word = take_word(rest);
        }
        made.type = known(types, word, "type");
        made.name = take_word(rest);
        return made;
    }

    const std::string& file_;
    std::string_view bytes_;
    std::size_t at_ = 0;
    PlyHeader header_;
};

}  // namespace

int size_of(PlyType type) {
    switch (type) {
        case PlyType::int8:
        case PlyType::uint8:
            return 1;
        case PlyType::int16:
        case PlyType::uint16:
            return 2;
        case PlyType::int32:
        case PlyType::uint32:
        case PlyType::float32:
            return 4;
        case PlyType::float64:
            return 8;
    }
    return 0;
}

PlyHeader ply_header(const std::string& file, std::string_view bytes) { return HeaderReader(file, bytes).read(); }

}  // namespace fovea::tool
