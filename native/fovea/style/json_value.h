// SPDX-License-Identifier: GPL-3.0-or-later
// JSON of style files, whatever they hold: what is read is small, not deep, and has no key twice.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace fovea::style {

/// A step from a value to one in it: a key of an object, or an index of a list.
using Step = std::variant<std::string, std::size_t>;
using Path = std::vector<Step>;

/// A path as readers of the file write it: line_sets[0].pen.width; `the style` where it has no steps.
std::string dotted(const Path& path);

struct JsonValue {
    enum class Type { null, boolean, whole, number, text, list, object };

    Type type = Type::null;
    bool boolean = false;
    double number = 0.0;                ///< finite; of whole numbers, too
    std::string text = {};              ///< also the digits of a whole number
    std::vector<JsonValue> items = {};  ///< of a list, and of an object, by its keys
    std::vector<std::string> keys = {};

    static JsonValue of(bool value);
    static JsonValue of(int value);
    static JsonValue of(double value);
    static JsonValue of(std::string value);
    static JsonValue list() { return {.type = Type::list}; }
    static JsonValue object() { return {.type = Type::object}; }

    void add(std::string key, JsonValue value);
    /// The value of a key, or of an index: null where there is none.
    const JsonValue* at(const Step& step) const;
    JsonValue* at(const Step& step) { return const_cast<JsonValue*>(std::as_const(*this).at(step)); }

    /// In ASCII. With indent, two spaces a level, and a line for each value; without it all of it in one line.
    std::string written(bool indent) const;
};

/// What a text holds. Throws std::invalid_argument with a sentence that names the place of what is wrong: what is no
/// JSON, a key that an object has twice, numbers that are not finite, more than a megabyte, or 32 levels.
JsonValue parse_json(std::string_view text);

}  // namespace fovea::style
