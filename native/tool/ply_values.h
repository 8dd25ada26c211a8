// SPDX-License-Identifier: GPL-3.0-or-later
// Sequential reader of the values of a PLY file, text or binary.
#pragma once

#include <tool/ply_header.h>

namespace fovea::tool {

/// Values are doubles, which hold all integers of the format. Throws std::invalid_argument, naming the file and the
/// place, if there is no value.
class PlyValues {
   public:
    PlyValues(const std::string& file, std::string_view bytes, const PlyHeader& header);

    double next(PlyType type) { return is_text_ ? next_word() : next_binary(type); }

    /// Reads the length of the list that begins here.
    std::size_t next_count(const PlyProperty& list);

    /// Throws if the rest of the file is too short for the elements.
    void check_room(const PlyElement& element) const;

    /// Position of the next value: a line of text, from 1, or a byte offset, from 0.
    std::size_t place() const { return is_text_ ? line_ : at_; }
    const char* unit() const { return is_text_ ? "line" : "byte"; }

   private:
    double next_word();
    double next_binary(PlyType type);
    void pass_blanks();
    /// Minimum size of a value in bytes.
    std::size_t least_size(PlyType type) const { return is_text_ ? 2 : std::size_t(size_of(type)); }
    /// Maximum number of values of `size` bytes that can follow; the last word of a text needs no blank after it.
    std::size_t room(std::size_t size) const { return (bytes_.size() - at_ + std::size_t(is_text_)) / size; }
    [[noreturn]] void fail(const std::string& what) const;

    const std::string& file_;
    std::string_view bytes_;
    std::size_t at_, line_;
    bool is_text_, is_swapped_;
};

}  // namespace fovea::tool
