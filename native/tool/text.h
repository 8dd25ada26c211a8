// SPDX-License-Identifier: GPL-3.0-or-later
// Lines, words and numbers of text, independent of the locale.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace fovea::tool {

/// Iterates over the lines of a text, without their ends: \n, \r\n or \r. A backslash at the end of a line continues
/// it.
class Lines {
   public:
    explicit Lines(std::string_view text) : text_(text) {}
    /// The next line, valid until the next call; empty optional at the end.
    std::optional<std::string_view> next();
    /// Number of the last line, from 1; of its first part, if it was continued.
    std::size_t number() const { return number_; }

   private:
    std::string_view cut();

    std::string_view text_;
    std::string joined_;
    std::size_t number_ = 0, read_ = 0;
};

/// Removes and returns the next word of a text; empty at its end. Words are separated by blanks, tabs and line ends.
std::string_view take_word(std::string_view& text);

/// The text without leading and trailing blanks.
std::string_view trimmed(std::string_view text);

/// Parses a whole word as a number in C notation; infinite beyond the range of double.
std::optional<double> to_number(std::string_view word);

/// Removes and returns the integer at the front of a word.
std::optional<std::int64_t> take_integer(std::string_view& word);

}  // namespace fovea::tool
