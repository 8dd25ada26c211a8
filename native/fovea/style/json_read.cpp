// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cctype>
#include <map>
#include <sstream>

#include <fovea/line/registry.h>
#include <fovea/style/json.h>
#include <fovea/style/rules.h>

namespace fovea::style {
namespace {

using Type = JsonValue::Type;

/// Formats a number for messages: 2 and 0.5, not 2.000000.
std::string plain(double number) {
    std::ostringstream text;
    text << number;
    return text.str();
}

std::string joined(const std::vector<std::string>& words) {
    std::string all;
    for (const std::string& word : words) all += (all.empty() ? "" : ", ") + word;
    return all;
}

/// Whether a string has no control characters and at most `most` characters (UTF-8 code points).
bool is_name(const std::string& text, std::size_t most) {
    std::size_t letters = 0;
    for (const unsigned char byte : text) {
        if (byte < 0x20 || byte == 0x7f) return false;
        letters += (byte & 0xc0) != 0x80;
    }
    return letters <= most;
}

/// Reads records, and tracks the path of the current value for messages.
class Reader {
   public:
    /// `is_file`: it reads a style file, whose other files lie beside it.
    Reader(const Shipped* shipped, std::vector<Unknown>& unknown, bool is_file)
        : shipped_(shipped), unknown_(unknown), is_file_(is_file) {}

    template <Record S>
    void read(const JsonValue& json, S& record) {
        expect(json.type == Type::object, "must be a JSON object");
        for_each_field<S>([&]<typename V>(const Field<S, V>& field) {
            if constexpr (!std::is_same_v<V, std::vector<Unknown>>) {
                const JsonValue* value = json.at(Step(field.key()));
                if (value) in(field.key(), [&] { read_member(*value, record, field); });
            }
        });
        keep_unknown(json, [&](const std::string& key) { return knows<S>(key); });
        if constexpr (requires { settle(record, path_); })
            settle(record, path_);
        else if constexpr (std::is_same_v<S, LineSet>)
            settle(record, path_, unknown_);
    }

    /// Parameters of a definition; unknown ones are preserved.
    Parameters parameters(const JsonValue& json, const LineDefinition& definition) {
        expect(json.type == Type::object, "must map parameters to numbers");
        Parameters found;
        const char* of_file = definition.file ? definition.file->name : "";
        read_known(
            json, definition.parameters, &Parameter::name,
            [&](const JsonValue& value, const Parameter& known) {
                found.emplace_back(known.name, value_of(value, known));
            },
            of_file);
        const JsonValue* file = definition.file ? json.at(Step(of_file)) : nullptr;
        if (file) in(of_file, [&] { found.emplace_back(of_file, path_of(*file, *definition.file)); });
        return found;
    }

    template <typename Read>
    void in(const Step& step, const Read& read) {
        path_.push_back(step);
        read();
        path_.pop_back();
    }
    void expect(bool holds, const std::string& sentence) const {
        if (!holds) refuse(sentence);
    }
    [[noreturn]] void refuse(const std::string& sentence) const { style::refuse(dotted(path_) + " " + sentence); }

   private:
    template <Record S, typename V>
    void read_member(const JsonValue& json, S& record, const Field<S, V>& field) {
        if constexpr (std::is_same_v<V, std::optional<Pen>>)
            if (json.type == Type::object) (record.*field.member).emplace(record.pen);
        read(json, record.*field.member, field.domain);
    }

    void read(const JsonValue& json, bool& value, const Domain&) {
        expect(json.type == Type::boolean, "must be true or false");
        value = json.boolean;
    }

    void read(const JsonValue& json, double& value, const Domain& domain) {
        expect(json.type == Type::number || json.type == Type::whole, "must be a number");
        value = json.number;
        within(value, domain);
    }

    void read(const JsonValue& json, int& value, const Domain& domain) {
        expect(json.type == Type::whole, "must be a whole number");
        within(json.number, domain);
        value = int(json.number);
    }

    void within(double number, const Domain& domain) {
        if (number < domain.least || number > domain.most)
            refuse("is " + plain(number) + ", outside " + plain(domain.least) + " to " + plain(domain.most));
    }

    void read(const JsonValue& json, std::string& value, const Domain& domain) {
        const std::size_t most = most_letters(domain.names);
        if (most && (json.type != Type::text || !is_name(json.text, most)))
            refuse("must be text of at most " + std::to_string(most) + " letters");
        expect(json.type == Type::text, "must be text");
        value = json.text;
        if (domain.names == Names::texture) ships(value, shipped_ ? &shipped_->textures : nullptr);
        if (domain.names == Names::paper) ships(value, shipped_ ? &shipped_->papers : nullptr);
    }

    /// Checks the name of a texture or paper. Names become file names, so none may leave the folder.
    void ships(const std::string& name, const std::vector<std::string>* known) {
        const bool is_plain = std::ranges::all_of(
            name, [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-' || c >= 0x80; });
        expect(is_plain && !name.empty(), "is '" + name + "'; only letters, digits, _ and - are allowed");
        if (known && std::ranges::find(*known, name) == known->end())
            refuse("is '" + name + "'; there are: " + joined(*known));
    }

    template <typename Enum>
        requires std::is_enum_v<Enum>
    void read(const JsonValue& json, Enum& value, const Domain&) {
        expect(json.type == Type::text, "must be text");
        std::vector<std::string> known;
        for (const Choice& choice : choices_of<Enum>) known.emplace_back(choice.name);
        const auto found = std::ranges::find(known, json.text);
        if (found == known.end()) refuse("is '" + json.text + "'; it can be: " + joined(known));
        value = static_cast<Enum>(found - known.begin());
    }

    /// A position in the image may omit the third number.
    template <int N>
    void read(const JsonValue& json, glm::vec<N, double>& value, const Domain& domain) {
        const bool is_color = domain.unit == Unit::light;
        const bool fits = json.type == Type::list && json.items.size() <= N && json.items.size() >= (is_color ? N : 2);
        expect(fits, std::string("must be a list of ") + (is_color ? "3 numbers"
                                                          : N == 2 ? "2 numbers"
                                                                   : "2 or 3 numbers"));
        value = glm::vec<N, double>(0.0);
        for (std::size_t i = 0; i < json.items.size(); ++i) read(json.items[i], value[int(i)], domain);
    }

    template <typename T>
    void read(const JsonValue& json, std::vector<T>& list, const Domain& domain) {
        expect(json.type == Type::list, "must be a list");
        list.clear();
        for (std::size_t i = 0; i < json.items.size(); ++i)
            in(i, [&] { read(json.items[i], list.emplace_back(), domain); });
    }

    template <typename T>
    void read(const JsonValue& json, std::optional<T>& value, const Domain& domain) {
        if (json.type == Type::null) return value.reset();
        read(json, value ? *value : value.emplace(), domain);
    }

    /// "paper" or null: unset.
    void read(const JsonValue& json, std::optional<dvec3>& color, const Domain& domain) {
        if (json.type == Type::null || json.text == "paper") return color.reset();
        expect(json.type == Type::list && json.items.size() == 3, "must be 'paper' or a list of 3 numbers");
        read(json, color.emplace(), domain);
    }

    template <Record S>
    void read(const JsonValue& json, S& record, const Domain&) {
        read(json, record);
    }

    void read(const JsonValue& json, Definitions& kinds, const Domain&) {
        expect(json.type == Type::object, "must map lines to their parameters");
        kinds.clear();
        read_known(json, line_definitions(), &LineDefinition::name,
                   [&](const JsonValue& value, const LineDefinition* known) {
                       kinds.emplace_back(known->name, parameters(value, *known));
                   });
    }

    double value_of(const JsonValue& json, const Parameter& parameter) {
        if (json.type == Type::boolean && parameter.unit == line::Unit::boolean) return json.boolean;
        double value = 0.0;
        read(json, value, number(parameter.low, parameter.high, parameter.high));
        return value;
    }

    /// Style files are untrusted, so theirs are beside them, or in folders there.
    std::string path_of(const JsonValue& json, const line::FileParameter& parameter) {
        constexpr std::size_t longest = 1000;
        expect(json.type == Type::text && !json.text.empty() && is_name(json.text, longest),
               "must be the name of a file, of at most " + std::to_string(longest) + " letters");
        const std::string& path = json.text;
        expect(path.ends_with(parameter.suffix),
               std::string("must be the name of a file that ends in ") + parameter.suffix);
        const bool leaves = path.front() == '/' || path.find_first_of("\\:") != std::string::npos ||
                            ("/" + path + "/").find("/../") != std::string::npos;
        expect(!is_file_ || !leaves,
               "must be the name of a file in the folder of the style, or in a folder there, with / between them");
        return path;
    }

    template <Record S>
    static bool knows(const std::string& key) {
        bool found = std::is_same_v<S, Style> && key == "schema";
        for_each_field<S>([&](const auto& field) { found |= field.is_in_files() && key == field.key(); });
        return found;
    }

    /// Calls take(value, known) for the entries of an object whose key is the name of one of `all`; keeps the others,
    /// but for one that is read elsewhere.
    template <typename All, typename Name, typename Take>
    void read_known(const JsonValue& json, const All& all, Name name, const Take& take,
                    std::string_view elsewhere = {}) {
        const auto find = [&](std::string_view key) { return std::ranges::find(all, key, name); };
        for (std::size_t i = 0; i < json.items.size(); ++i)
            if (const auto known = find(json.keys[i]); known != all.end())
                in(json.keys[i], [&] { take(json.items[i], *known); });
        keep_unknown(json, [&](const std::string& key) {
            return find(key) != all.end() || (!elsewhere.empty() && key == elsewhere);
        });
    }

    template <typename Knows>
    void keep_unknown(const JsonValue& json, const Knows& is_known) {
        std::map<std::string, const JsonValue*> unknown;  // sorted by key
        for (std::size_t i = 0; i < json.items.size(); ++i)
            if (!is_known(json.keys[i])) unknown[json.keys[i]] = &json.items[i];
        for (const auto& [key, value] : unknown) in(key, [&] { unknown_.push_back({path_, value->written(false)}); });
    }

    const Shipped* shipped_;
    std::vector<Unknown>& unknown_;
    bool is_file_;
    Path path_;
};

void check_schema(const JsonValue& json) {
    if (json.type != Type::object) throw std::invalid_argument("the style must be a JSON object");
    const JsonValue* found = json.at("schema");
    const JsonValue given = found ? *found : JsonValue();
    if (given.type != Type::whole || given.number < 1)
        refuse("schema is " + given.written(false) + ", not the number of a schema: 1 to " + std::to_string(schema));
    if (given.number > schema)
        refuse("schema is " + given.text + ": a newer version of Fovea wrote the style, this one reads up to " +
               std::to_string(schema));
}

}  // namespace

Style read_style(std::string_view json, const Shipped* shipped) {
    const JsonValue data = parse_json(json);
    check_schema(data);
    Style style;
    style.line_sets.clear();
    Reader reader(shipped, style.kept, true);
    reader.read(data, style);
    std::ranges::sort(style.kept, {}, &Unknown::path);
    reader.in("line_sets", [&] { reader.expect(!style.line_sets.empty(), "must be a list of at least one line set"); });
    return style;
}

Parameters checked_parameters(const std::string& definition, const Parameters& given, const std::string& where) {
    JsonValue json = JsonValue::object();
    for (const auto& [name, value] : given)
        json.add(name, value.file.empty() ? JsonValue::of(value.number) : JsonValue::of(value.file));
    std::vector<Unknown> unknown;
    Reader reader(nullptr, unknown, false);
    Parameters found;
    reader.in(where,
              [&] { reader.in(definition, [&] { found = reader.parameters(json, definition_called(definition)); }); });
    if (unknown.empty()) return found;
    std::vector<std::string> known;
    for (const Parameter& parameter : definition_called(definition).parameters) known.emplace_back(parameter.name);
    if (const auto& file = definition_called(definition).file) known.emplace_back(file->name);
    std::ranges::sort(known);
    const std::string key = std::get<std::string>(unknown[0].path.back());
    throw std::invalid_argument(where + "." + definition + " has unknown keys: " + key +
                                "; known are: " + (known.empty() ? "none" : joined(known)));
}

}  // namespace fovea::style
