// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/style/json_value.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <unordered_set>

#include <fovea/base/check.h>

namespace fovea::style {
namespace {

using Type = JsonValue::Type;

constexpr std::size_t longest = 400;  // bytes of a sentence

/// Event handler of the library's parser.
class Builder {
   public:
    explicit Builder(std::string_view text) : text_(text) {}

    JsonValue root;

    bool null() { return put({}); }
    bool boolean(bool value) { return put(JsonValue::of(value)); }
    bool number_integer(std::int64_t value) { return put(whole(double(value), std::to_string(value))); }
    bool number_unsigned(std::uint64_t value) { return put(whole(double(value), std::to_string(value))); }
    bool number_float(double value, const std::string& digits) {
        const bool is_whole = digits.find_first_of(".eE") == std::string::npos;
        return put(is_whole ? whole(value, digits) : JsonValue::of(value));
    }
    bool string(std::string& value) { return put(JsonValue::of(std::move(value))); }
    bool binary(nlohmann::json::binary_t&) { return false; }
    bool start_object(std::size_t) { return open(JsonValue::object()); }
    bool start_array(std::size_t) { return open(JsonValue::list()); }
    bool end_object() { return close(); }
    bool end_array() { return close(); }
    bool key(std::string& name) {
        if (!open_.back().keys.insert(name).second) {
            Path object = path();
            object.pop_back();
            refuse(dotted(object) + " gives '" + name + "' twice");
        }
        open_.back().key = std::move(name);
        return true;
    }
    bool parse_error(std::size_t position, const std::string& token, const nlohmann::json::exception& error) {
        if (dynamic_cast<const nlohmann::json::out_of_range*>(&error))
            refuse(dotted(path()) + " is " + token.substr(0, 20) + ", not a finite number");
        const std::string_view before = text_.substr(0, std::min(position, text_.size()));
        const std::size_t line = before.rfind('\n') + 1;  // 0 on the first line
        refuse("the style is not JSON at line " + std::to_string(std::ranges::count(before, '\n') + 1) + ", column " +
               std::to_string(std::max<std::size_t>(before.size() - line, 1)));
        return false;
    }

   private:
    struct Open {
        JsonValue* value;
        std::string key;  // the last key read
        std::unordered_set<std::string> keys;
    };

    static JsonValue whole(double value, std::string digits) {
        return {.type = Type::whole, .number = value, .text = std::move(digits)};
    }
    /// Path of the value that is read next.
    Path path() const {
        Path steps;
        for (const Open& each : open_) {
            const std::size_t after = &each == &open_.back() ? 0 : 1;  // an open value is already in its list
            const bool is_list = each.value->type == Type::list;
            steps.push_back(is_list ? Step(each.value->items.size() - after) : Step(each.key));
        }
        return steps;
    }
    bool put(JsonValue value) {
        place(std::move(value));
        return true;
    }
    JsonValue* place(JsonValue value) {
        if (open_.empty()) return &(root = std::move(value));
        JsonValue& into = *open_.back().value;
        if (into.type == Type::object) into.keys.push_back(open_.back().key);
        return &into.items.emplace_back(std::move(value));
    }
    bool open(JsonValue value) {
        if (open_.size() >= deepest)
            refuse(dotted(path()) + " is nested more than " + std::to_string(deepest) + " levels deep");
        open_.push_back({place(std::move(value)), {}, {}});
        return true;
    }
    bool close() {
        open_.pop_back();
        return true;
    }

    std::string_view text_;
    std::vector<Open> open_;
};

/// Shortest decimal that parses to the same number, always with a point or an exponent.
std::string digits_of(double value) {
    char found[32];
    const auto end = std::to_chars(found, std::end(found), std::abs(value), std::chars_format::scientific).ptr;
    const std::string_view all(found, end);
    const std::size_t e = all.find('e');
    std::string digits(all.substr(0, e));
    int exponent = 0;
    const std::string_view power = all.substr(e + (all[e + 1] == '+' ? 2 : 1));
    std::from_chars(power.data(), power.data() + power.size(), exponent);
    std::erase(digits, '.');
    const int count = int(digits.size());
    if (exponent < -4 || exponent >= 16) {
        if (count > 1) digits.insert(1, ".");
        const std::string size = std::to_string(std::abs(exponent));
        digits += (exponent < 0 ? "e-" : "e+") + std::string(size.size() < 2 ? "0" : "") + size;
    } else if (exponent < 0) {
        digits = "0." + std::string(-exponent - 1, '0') + digits;
    } else if (count <= exponent + 1) {
        digits += std::string(exponent + 1 - count, '0') + ".0";
    } else {
        digits.insert(exponent + 1, ".");
    }
    return (std::signbit(value) ? "-" : "") + digits;
}

std::string quoted(const std::string& text) {
    return nlohmann::json(text).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

/// `level`: of indentation; -1: all on one line.
std::string text_of(const JsonValue& value, int level) {
    switch (value.type) {
        case Type::null:
            return "null";
        case Type::boolean:
            return value.boolean ? "true" : "false";
        case Type::whole:
            return value.text;
        case Type::number:
            return digits_of(value.number);
        case Type::text:
            return quoted(value.text);
        default:
            break;
    }
    const bool is_object = value.type == Type::object;
    std::string out = is_object ? "{" : "[";
    const auto start_line = [&](int at) {
        if (at >= 0) out += "\n" + std::string(2 * at, ' ');
    };
    const int inner = level < 0 ? level : level + 1;
    for (std::size_t i = 0; i < value.items.size(); ++i) {
        if (i) out += level < 0 ? ", " : ",";
        start_line(inner);
        if (is_object) out += quoted(value.keys[i]) + ": ";
        out += text_of(value.items[i], inner);
    }
    if (!value.items.empty()) start_line(level);
    return out + (is_object ? "}" : "]");
}

}  // namespace

std::string dotted(const Path& path) {
    std::string found;
    for (const Step& step : path)
        if (const auto* key = std::get_if<std::string>(&step))
            found += (found.empty() ? "" : ".") + *key;
        else
            found += "[" + std::to_string(std::get<std::size_t>(step)) + "]";
    return path.empty() ? "the style" : found;
}

JsonValue JsonValue::of(bool value) { return {.type = Type::boolean, .boolean = value}; }
JsonValue JsonValue::of(int value) {
    return {.type = Type::whole, .number = double(value), .text = std::to_string(value)};
}
JsonValue JsonValue::of(double value) { return {.type = Type::number, .number = value}; }
JsonValue JsonValue::of(std::string value) { return {.type = Type::text, .text = std::move(value)}; }

void JsonValue::add(std::string key, JsonValue value) {
    keys.push_back(std::move(key));
    items.push_back(std::move(value));
}

void refuse(std::string sentence) {
    if (sentence.size() > longest) {
        const auto begins = [&](std::size_t i) { return (sentence[i] & 0xc0) != 0x80; };  // a letter, in UTF-8
        std::size_t cut = longest - 100, on = sentence.size() - 90;
        while (!begins(cut)) --cut;
        while (!begins(on)) --on;
        sentence = sentence.substr(0, cut) + " ... " + sentence.substr(on);
    }
    for (char& c : sentence)
        if (std::iscntrl(static_cast<unsigned char>(c))) c = ' ';
    throw std::invalid_argument(sentence);
}

const JsonValue* JsonValue::at(const Step& step) const {
    if (const auto* key = std::get_if<std::string>(&step)) {
        const auto found = type == Type::object ? std::ranges::find(keys, *key) : keys.end();
        return found == keys.end() ? nullptr : &items[found - keys.begin()];
    }
    const auto index = std::get<std::size_t>(step);
    return type == Type::list && index < items.size() ? &items[index] : nullptr;
}

std::string JsonValue::written(bool indent) const { return text_of(*this, indent ? 0 : -1); }

JsonValue parse_json(std::string_view text) {
    check(text.size() <= largest, "the style has more than 1 MB: that is no style");
    Builder builder(text);
    nlohmann::json::sax_parse(text.begin(), text.end(), &builder);
    return std::move(builder.root);
}

}  // namespace fovea::style
