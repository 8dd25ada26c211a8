// SPDX-License-Identifier: GPL-3.0-or-later
// Bindings of records (style/field.h): keyword arguments, attributes, `replace`; enumerations by their names.
#pragma once

#include <optional>
#include <pybind11/typing.h>

#include <fovea/style/field.h>
#include <fovea/style/transfer.h>

#include "bindings/arrays.h"

namespace fovea::bindings {

// Conversion of a member to and from Python: enumerations by their names, lists and vectors as tuples, named values as
// dicts, so that members of a record are immutable and compare by value. `Python` is what signatures tell of them.
template <typename T>
struct Member {
    using Python = T;
    static T from(const py::handle& given) { return given.cast<T>(); }
    static Python to(const T& value) { return value; }
};

template <int N, typename T, glm::qualifier Q>
struct Member<glm::vec<N, T, Q>> {
    using Vector = glm::vec<N, T, Q>;
    using Python = py::typing::Tuple<T, py::ellipsis>;
    static Vector from(const py::handle& given) { return given.cast<Vector>(); }
    static Python to(const Vector& value) { return py::reinterpret_steal<Python>(py::cast(value).release()); }
};

template <typename Enum>
    requires std::is_enum_v<Enum>
struct Member<Enum> {
    using Python = py::str;
    static Enum from(const py::handle& given) {
        const auto word = given.cast<std::string>();
        std::string known;
        int i = 0;
        for (const style::Choice& choice : style::choices_of<Enum>) {
            if (word == choice.name) return static_cast<Enum>(i);
            known += (i++ ? ", " : "") + std::string(choice.name);
        }
        throw std::invalid_argument("is '" + word + "'; it can be: " + known);
    }
    static Python to(Enum value) { return py::str(style::choices_of<Enum>[static_cast<int>(value)].name); }
};

template <typename T>
struct Member<std::optional<T>> {
    using Python = py::typing::Optional<typename Member<T>::Python>;
    static std::optional<T> from(const py::handle& given) {
        return given.is_none() ? std::nullopt : std::optional(Member<T>::from(given));
    }
    static Python to(const std::optional<T>& value) {
        py::object given = py::none();
        if (value) given = py::detail::object_or_cast(Member<T>::to(*value));
        return py::reinterpret_steal<Python>(given.release());
    }
};

template <typename T>
struct Member<std::vector<T>> {
    using Python = py::typing::Tuple<typename Member<T>::Python, py::ellipsis>;
    static std::vector<T> from(const py::handle& given) {
        std::vector<T> values;
        for (const py::handle& each : given) values.push_back(Member<T>::from(each));
        return values;
    }
    static Python to(const std::vector<T>& values) {
        py::tuple all(values.size());
        for (std::size_t i = 0; i < values.size(); ++i) all[i] = Member<T>::to(values[i]);
        return py::reinterpret_steal<Python>(all.release());
    }
};

template <typename T>
struct Member<std::vector<std::pair<std::string, T>>> {
    using Named = std::vector<std::pair<std::string, T>>;
    using Python = py::typing::Dict<py::str, typename Member<T>::Python>;
    static Named from(const py::handle& given) {
        Named values;
        for (const auto& [name, value] : given.cast<py::dict>())
            values.emplace_back(name.cast<std::string>(), Member<T>::from(value));
        return values;
    }
    static Python to(const Named& values) {
        Python named;
        for (const auto& [name, value] : values) named[py::str(name)] = Member<T>::to(value);
        return named;
    }
};

/// Converts a Python value to a member; `name` appears in the error if it cannot be converted.
template <typename V>
V value_from(const py::handle& given, const std::string& name) {
    try {
        return Member<V>::from(given);
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(name + " " + error.what());
    } catch (const py::cast_error&) {
        throw py::type_error(name + " cannot be " + std::string(py::str(py::repr(given))));
    }
}

template <typename V>
auto value_to(const V& value) {
    return Member<V>::to(value);
}

/// Copy of a record with the given members set.
template <style::Record S>
S with(S record, const py::kwargs& given) {
    for (const auto& [key, value] : given) {
        const auto name = key.cast<std::string>();
        bool found = false;
        style::for_each_field<S>([&]<typename V>(const style::Field<S, V>& field) {
            if (name != field.name) return;
            record.*field.member = value_from<V>(value, name);
            found = true;
        });
        if (!found) throw py::type_error("there is no '" + name + "'");
    }
    return record;
}

/// (name, label, description) of each value of an enumeration.
template <typename Enum>
py::list choices() {
    py::list all;
    for (const style::Choice& choice : style::choices_of<Enum>)
        all.append(py::make_tuple(choice.name, choice.label, choice.description));
    return all;
}

template <style::Record S>
py::class_<S> bind_record(py::module_& m, const char* name, const char* doc) {
    py::class_<S> bound(m, name, doc);
    bound.def(py::init([](const py::kwargs& given) { return with(S(), given); }));
    bound.def(
        "replace", [](const S& record, const py::kwargs& given) { return with(record, given); },
        "The same with other values.");
    bound.def("__eq__", [](const S& a, const S& b) { return a == b; }, py::is_operator());
    bound.def("__repr__", [name](const S& record) {
        std::string text;
        style::for_each_field<S>([&]<typename V>(const style::Field<S, V>& field) {
            const py::object value = py::detail::object_or_cast(value_to(record.*field.member));
            text += (text.empty() ? "" : ", ") + std::string(field.name) + "=" + std::string(py::str(py::repr(value)));
        });
        return std::string(name) + "(" + text + ")";
    });
    bound.def("__hash__", [](const py::object& record) { return py::hash(py::repr(record)); });
    style::for_each_field<S>([&]<typename V>(const style::Field<S, V>& field) {
        bound.def_property_readonly(field.name,
                                    [member = field.member](const S& record) { return value_to(record.*member); });
    });
    return bound;
}

/// Name of a member's type; records use their own names.
template <typename T>
const char* type_name(const T&) {
    if constexpr (std::is_same_v<T, bool>)
        return "switch";
    else if constexpr (std::is_same_v<T, double>)
        return "number";
    else if constexpr (std::is_same_v<T, int>)
        return "whole number";
    else if constexpr (std::is_enum_v<T>)
        return "choice";
    else if constexpr (std::is_same_v<T, std::string>)
        return "text";
    else if constexpr (std::is_same_v<T, dvec3>)
        return "color";
    else if constexpr (std::is_same_v<T, style::Transfer>)
        return "transfer";
    else
        return "";
}
template <typename T>
const char* type_name(const std::optional<T>&) {
    return type_name(T());
}

/// What is told of a member, but for the choices that it has. Not a template: there are hundreds of members.
inline py::dict told(const char* name, const char* key, const char* label, const char* description, const char* group,
                     const style::Domain& domain, const char* type, const py::object& value) {
    return py::dict(
        py::arg("name") = name, py::arg("key") = key, py::arg("label") = label, py::arg("description") = description,
        py::arg("type") = type, py::arg("group") = group, py::arg("default") = value, py::arg("min") = domain.least,
        py::arg("max") = domain.most, py::arg("soft_max") = domain.soft_most, py::arg("unit") = value_to(domain.unit),
        py::arg("names") = value_to(domain.names), py::arg("most_letters") = style::most_letters(domain.names));
}

template <typename S, typename V>
py::dict told(const style::Field<S, V>& field) {
    const V value = S().*field.member;
    py::dict found = told(field.name, field.key(), field.label, field.description, field.group, field.domain,
                          type_name(value), py::detail::object_or_cast(value_to(value)));
    if constexpr (std::is_enum_v<V>) found["choices"] = choices<V>();
    return found;
}

/// Binds a record, with the declarations of its members as the class attribute `fields`.
template <style::Record S>
py::class_<S> bind_part(py::module_& m, const char* name, const char* doc) {
    auto bound = bind_record<S>(m, name, doc);
    py::list fields;
    style::for_each_field<S>([&](const auto& field) { fields.append(told(field)); });
    bound.attr("fields") = py::tuple(fields);
    return bound;
}

}  // namespace fovea::bindings
