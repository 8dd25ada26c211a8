// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/style/json.h>

#include <nlohmann/json.hpp>

#include <fovea/base/check.h>

namespace fovea::style {
namespace {

using Json = nlohmann::ordered_json;

void read(const Json& json, bool& value, const std::string& where) {
    check(json.is_boolean(), where + " must be true or false");
    value = json.get<bool>();
}

void read(const Json& json, double& value, const std::string& where) {
    check(json.is_number(), where + " must be a number");
    value = json.get<double>();
}

void read(const Json& json, int& value, const std::string& where) {
    check(json.is_number_integer(), where + " must be a whole number");
    value = json.get<int>();
}

void read(const Json& json, std::string& value, const std::string& where) {
    check(json.is_string(), where + " must be text");
    value = json.get<std::string>();
}

template <typename Enum>
    requires std::is_enum_v<Enum>
void read(const Json& json, Enum& value, const std::string& where) {
    std::string name, known;
    read(json, name, where);
    for (int i = 0; names_of<Enum>[i]; ++i) {
        known += (i ? ", " : "") + std::string(names_of<Enum>[i]);
        if (name != names_of<Enum>[i]) continue;
        value = static_cast<Enum>(i);
        return;
    }
    check(false, where + " is '" + name + "'; it can be: " + known);
}

/// Missing coordinates are 0.
template <int N>
void read(const Json& json, glm::vec<N, double>& value, const std::string& where) {
    check(json.is_array() && json.size() >= 2 && json.size() <= N, where + " must be a list of numbers");
    value = glm::vec<N, double>(0.0);
    for (std::size_t i = 0; i < json.size(); ++i) read(json[i], value[int(i)], where);
}

void read(const Json& json, std::vector<std::pair<std::string, Parameters>>& kinds, const std::string& where) {
    check(json.is_object(), where + " must map lines to their parameters");
    kinds.clear();
    for (const auto& [name, values] : json.items()) {
        const std::string here = where + "." + name;
        check(values.is_object(), here + " must map parameters to numbers");
        Parameters parameters;
        for (const auto& [parameter, value] : values.items())
            if (value.is_boolean())
                parameters[parameter] = value.get<bool>();
            else
                read(value, parameters[parameter], here + "." + parameter);
        kinds.emplace_back(name, std::move(parameters));
    }
}

template <Record S>
void read(const Json& json, S& record, const std::string& where);

template <typename T>
void read(const Json& json, std::vector<T>& list, const std::string& where) {
    check(json.is_array(), where + " must be a list");
    list.clear();
    for (const Json& entry : json) {
        const std::string here = where + "[" + std::to_string(list.size()) + "]";
        read(entry, list.emplace_back(), here);
    }
}

/// A text stands for none, as "paper" does for a background.
template <typename T>
void read(const Json& json, std::optional<T>& value, const std::string& where) {
    value.reset();
    if (!json.is_null() && !json.is_string()) read(json, value.emplace(), where);
}

/// Asked for by a function: compilers may look for the member in every record otherwise.
template <Record S>
const Pen& pen_in_focus(const S& record) {
    return record.pen;
}

template <Record S>
void read(const Json& json, S& record, const std::string& where) {
    check(json.is_object(), where + " must be a JSON object");
    for_each_field<S>([&]<typename V>(const Field<S, V>& field) {
        const auto found = json.find(field.name);
        if (found == json.end()) return;
        // What is not given of a pen out of focus is as in focus.
        if constexpr (std::is_same_v<V, std::optional<Pen>>)
            if (found->is_object()) {
                (record.*field.member).emplace(pen_in_focus(record));
                return read(*found, *(record.*field.member), where + "." + field.name);
            }
        read(*found, record.*field.member, where + "." + field.name);
    });
}

}  // namespace

Style read_style(std::string_view json) {
    const Json data = Json::parse(json, nullptr, false);
    check(!data.is_discarded(), "the style is not JSON");
    Style style;
    read(data, style, "style");
    check(!style.line_sets.empty(), "style.line_sets must hold at least one line set");
    return style;
}

}  // namespace fovea::style
