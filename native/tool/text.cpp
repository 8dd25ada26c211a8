// SPDX-License-Identifier: GPL-3.0-or-later
#include <tool/text.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>

namespace fovea::tool {
namespace {

constexpr const char* blanks = " \t\r\n\v\f";

std::string_view without_plus(std::string_view word) {
    if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
    return word;
}

}  // namespace

std::string_view Lines::cut() {
    const std::size_t end = std::min(text_.find_first_of("\r\n"), text_.size());
    const std::string_view line = text_.substr(0, end);
    text_.remove_prefix(end);
    text_.remove_prefix(text_.starts_with("\r\n") ? 2 : text_.empty() ? 0 : 1);
    ++read_;
    return line;
}

std::optional<std::string_view> Lines::next() {
    if (text_.empty()) return {};
    std::string_view line = cut();
    number_ = read_;
    if (!line.ends_with('\\')) return line;
    joined_.clear();
    while (line.ends_with('\\')) {
        joined_ += line.substr(0, line.size() - 1);
        joined_ += ' ';
        line = cut();
    }
    joined_ += line;
    return joined_;
}

std::string_view take_word(std::string_view& text) {
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    const std::string_view word = text.substr(0, text.find_first_of(blanks));
    text.remove_prefix(word.size());
    return word;
}

std::string_view trimmed(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    return text.substr(0, text.find_last_not_of(blanks) + 1);
}

std::optional<double> to_number(std::string_view word) {
    word = without_plus(word);
    double value = 0.0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (end != word.data() + word.size()) return {};
    // Too large or too small for a double: std::strtod gives infinity or zero.
    if (error == std::errc::result_out_of_range) return std::strtod(std::string(word).c_str(), nullptr);
    return error == std::errc() ? std::optional(value) : std::nullopt;
}

std::optional<std::int64_t> take_integer(std::string_view& word) {
    const std::string_view digits = without_plus(word);
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc()) return {};
    word.remove_prefix(end - word.data());
    return value;
}

}  // namespace fovea::tool
