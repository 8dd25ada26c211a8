// SPDX-License-Identifier: GPL-3.0-or-later
// JSON values of style files. Files are untrusted: size, depth and duplicate keys are checked.
#pragma once

#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <fovea/base/files.h>

namespace fovea::style {

inline constexpr std::size_t largest = 1 << 20;  ///< bytes; shipped styles have about two thousand
inline constexpr std::size_t deepest = 32;       ///< levels of objects and lists

/// One step of a path into a JSON value: an object key or a list index.
using Step = std::variant<std::string, std::size_t>;
using Path = std::vector<Step>;

/// Dotted notation of a path, such as line_sets[0].pen.width; `the style` if it is empty.
std::string dotted(const Path& path);

/// Throws std::invalid_argument with a sentence about a file: on one line, and shortened, as a file may hold anything.
[[noreturn]] void refuse(std::string sentence);

struct JsonValue {
    enum class Type { null, boolean, whole, number, text, list, object };

    Type type = Type::null;
    bool boolean = false;
    double number = 0.0;                ///< finite; also set for whole numbers
    std::string text = {};              ///< a string's value, or the digits of a whole number
    std::vector<JsonValue> items = {};  ///< of a list; of an object, parallel to `keys`
    std::vector<std::string> keys = {};

    static JsonValue of(bool value);
    static JsonValue of(int value);
    static JsonValue of(double value);
    static JsonValue of(std::string value);
    static JsonValue list() { return {.type = Type::list}; }
    static JsonValue object() { return {.type = Type::object}; }

    void add(std::string key, JsonValue value);
    /// Value at a key or an index; null if absent.
    const JsonValue* at(const Step& step) const;
    JsonValue* at(const Step& step) { return const_cast<JsonValue*>(std::as_const(*this).at(step)); }

    /// Serializes to ASCII: with `indent`, two spaces per level and one value per line; else on one line.
    std::string written(bool indent) const;
};

/// parse(text) of a style's file, or one beside it. Throws std::invalid_argument with a sentence that names the file.
template <typename Parse>
auto read_file(const std::filesystem::path& file, const Parse& parse) {
    const std::string text = base::bytes_of_file(file, largest);
    try {
        return parse(text);
    } catch (const std::invalid_argument& problem) {
        throw std::invalid_argument(base::name_of(file) + ": " + problem.what());
    }
}

/// Parses a text. Throws std::invalid_argument with a sentence that names the place, for invalid JSON, duplicate keys
/// in an object, non-finite numbers, or a text that is larger or deeper than the limits.
JsonValue parse_json(std::string_view text);

}  // namespace fovea::style
