// SPDX-License-Identifier: GPL-3.0-or-later
// Lines, words and numbers of text, whatever the locale.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace fovea::tool {

/// The lines of a text, without their ends: \n, \r\n or \r. One that ends in a backslash goes on in the next.
class Lines {
   public:
    explicit Lines(std::string_view text) : text_(text) {}
    /// The next line, valid until the one after it; nothing at the end.
    std::optional<std::string_view> next();
    /// Where it stands, from 1: its first line, if it goes on.
    std::size_t number() const { return number_; }

   private:
    std::string_view cut();

    std::string_view text_;
    std::string joined_;
    std::size_t number_ = 0, read_ = 0;
};

/// Takes the next word off the front of a text; empty at its end. Blanks, tabs and line ends divide words.
std::string_view take_word(std::string_view& text);

/// Without blanks around it.
std::string_view trimmed(std::string_view text);

/// A number that is all of a word, as C writes it; infinite beyond the range.
std::optional<double> to_number(std::string_view word);

/// The whole number that a word begins with, taken off its front.
std::optional<std::int64_t> take_integer(std::string_view& word);

}  // namespace fovea::tool
