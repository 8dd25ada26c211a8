// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/style/json.h>

namespace fovea::style {
namespace {

template <Record S>
JsonValue to_json(const S& record);

template <typename V>
JsonValue to_json(const V& value) {
    if constexpr (std::is_enum_v<V>)
        return JsonValue::of(std::string(choices_of<V>[static_cast<int>(value)].name));
    else if constexpr (std::is_same_v<V, line::ParameterValue>)
        return value.file.empty() ? JsonValue::of(value.number) : JsonValue::of(value.file);
    else
        return JsonValue::of(value);
}

template <int N>
JsonValue to_json(const glm::vec<N, double>& value) {
    JsonValue list = JsonValue::list();
    for (int i = 0; i < N; ++i) list.items.push_back(JsonValue::of(value[i]));
    return list;
}

template <typename T>
JsonValue to_json(const std::vector<T>& values) {
    JsonValue list = JsonValue::list();
    for (const T& value : values) list.items.push_back(to_json(value));
    return list;
}

template <typename T>
JsonValue to_json(const std::optional<T>& value) {
    return value ? to_json(*value) : JsonValue();
}

/// Pairs of name and value become an object.
template <typename T>
JsonValue to_json(const std::vector<std::pair<std::string, T>>& named) {
    JsonValue object = JsonValue::object();
    for (const auto& [name, value] : named) object.add(name, to_json(value));
    return object;
}

template <Record S>
JsonValue to_json(const S& record) {
    JsonValue object = JsonValue::object();
    for_each_field<S>([&]<typename V>(const Field<S, V>& field) {
        if constexpr (!std::is_same_v<V, std::vector<Unknown>>) object.add(field.key(), to_json(record.*field.member));
    });
    return object;
}

/// Writes an unknown value back, if the object that contained it still exists.
void put(JsonValue& root, const Unknown& unknown) {
    JsonValue* place = &root;
    for (std::size_t i = 0; place && i + 1 < unknown.path.size(); ++i) place = place->at(unknown.path[i]);
    const auto* key = std::get_if<std::string>(&unknown.path.back());
    if (place && key && place->type == JsonValue::Type::object) place->add(*key, parse_json(unknown.json));
}

}  // namespace

std::string write_style(const Style& style) {
    JsonValue root = JsonValue::object();
    root.add("schema", JsonValue::of(schema));
    JsonValue known = to_json(style);
    for (std::size_t i = 0; i < known.items.size(); ++i) root.add(known.keys[i], std::move(known.items[i]));
    for (const Unknown& unknown : style.kept) put(root, unknown);
    return root.written(true) + "\n";
}

}  // namespace fovea::style
