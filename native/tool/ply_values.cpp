// SPDX-License-Identifier: GPL-3.0-or-later
#include <tool/ply_values.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <tool/model.h>
#include <tool/text.h>

namespace fovea::tool {
namespace {

template <typename Value>
double value_at(const char* bytes) {
    Value value;
    std::memcpy(&value, bytes, sizeof(Value));
    return double(value);
}

double value_of(PlyType type, const char* bytes) {
    switch (type) {
        case PlyType::int8:
            return value_at<std::int8_t>(bytes);
        case PlyType::uint8:
            return value_at<std::uint8_t>(bytes);
        case PlyType::int16:
            return value_at<std::int16_t>(bytes);
        case PlyType::uint16:
            return value_at<std::uint16_t>(bytes);
        case PlyType::int32:
            return value_at<std::int32_t>(bytes);
        case PlyType::uint32:
            return value_at<std::uint32_t>(bytes);
        case PlyType::float32:
            return value_at<float>(bytes);
        case PlyType::float64:
            return value_at<double>(bytes);
    }
    return 0.0;
}

}  // namespace

PlyValues::PlyValues(const std::string& file, std::string_view bytes, const PlyHeader& header)
    : file_(file),
      bytes_(bytes),
      at_(header.size),
      line_(header.lines + 1),
      is_text_(header.format == PlyFormat::ascii),
      is_swapped_((header.format == PlyFormat::big_endian) != (std::endian::native == std::endian::big)) {
    if (is_text_) pass_blanks();
}

void PlyValues::fail(const std::string& what) const { refuse(file_, unit(), place(), what); }

void PlyValues::pass_blanks() {
    for (; at_ < bytes_.size() && std::strchr(" \t\r\n", bytes_[at_]) && bytes_[at_]; ++at_)
        line_ += bytes_[at_] == '\n';
}

double PlyValues::next_word() {
    if (at_ == bytes_.size()) fail("the file ends before its last element");
    std::string_view rest = bytes_.substr(at_);
    const std::string_view word = take_word(rest);
    const std::optional<double> value = to_number(word);
    if (!value) fail("here is no number where there should be one");
    at_ += word.size();
    pass_blanks();
    return *value;
}

double PlyValues::next_binary(PlyType type) {
    const std::size_t size = size_of(type);
    if (bytes_.size() - at_ < size) fail("the file ends before its last element");
    char value[8];
    std::memcpy(value, bytes_.data() + at_, size);
    if (is_swapped_) std::reverse(value, value + size);
    at_ += size;
    return value_of(type, value);
}

std::size_t PlyValues::next_count(const PlyProperty& list) {
    const double count = next(list.count_type);
    if (!(count >= 0.0 && count == std::floor(count))) fail("a list has no whole number of values");
    const std::size_t most = room(least_size(list.type));
    if (count > double(most)) fail("the file ends before a list of '" + list.name + "' can");
    return std::size_t(count);
}

void PlyValues::check_room(const PlyElement& element) const {
    std::size_t size = 0;
    for (const PlyProperty& p : element.properties) size += least_size(p.is_list ? p.count_type : p.type);
    if (size > 0 && element.count > room(size))
        fail("the header says " + std::to_string(element.count) + " of '" + element.name + "', and there is room for " +
             std::to_string(room(size)));
}

}  // namespace fovea::tool
