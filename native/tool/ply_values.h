// SPDX-License-Identifier: GPL-3.0-or-later
// The values of a PLY file one after the other, as text or binary.
#pragma once

#include <tool/ply_header.h>

namespace fovea::tool {

/// All integers of the format fit into a double. Throws std::invalid_argument, naming the file and the place, where
/// there is no value.
class PlyValues {
   public:
    PlyValues(const std::string& file, std::string_view bytes, const PlyHeader& header);

    double next(PlyType type) { return is_text_ ? next_word() : next_binary(type); }

    /// How many values there may be for a list that begins here.
    std::size_t next_count(const PlyProperty& list);

    /// Throws where the file ends before so many elements can.
    void check_room(const PlyElement& element) const;

    /// Where the next value stands: a line of text, from 1, or a byte, from 0.
    std::size_t place() const { return is_text_ ? line_ : at_; }
    const char* unit() const { return is_text_ ? "line" : "byte"; }

   private:
    double next_word();
    double next_binary(PlyType type);
    void pass_blanks();
    /// Fewest bytes that a value takes.
    std::size_t least_size(PlyType type) const { return is_text_ ? 2 : std::size_t(size_of(type)); }
    /// Most values of so many bytes that can follow; the last word of a text needs no blank after it.
    std::size_t room(std::size_t size) const { return (bytes_.size() - at_ + std::size_t(is_text_)) / size; }
    [[noreturn]] void fail(const std::string& what) const;

    const std::string& file_;
    std::string_view bytes_;
    std::size_t at_, line_;
    bool is_text_, is_swapped_;
};

}  // namespace fovea::tool
