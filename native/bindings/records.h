// SPDX-License-Identifier: GPL-3.0-or-later
// Records (style/field.h) as Python has them: keyword arguments, attributes, `replace`; enumerations by their names.
#pragma once

#include <pybind11/stl.h>

#include <fovea/base/check.h>
#include <fovea/style/field.h>

#include "bindings/arrays.h"

namespace fovea::bindings {

template <typename V>
V value_from(const py::handle& given, const char* name) {
    if constexpr (std::is_enum_v<V>) {
        const auto word = given.cast<std::string>();
        std::string known;
        for (int i = 0; style::names_of<V>[i]; ++i) {
            if (word == style::names_of<V>[i]) return static_cast<V>(i);
            known += (i ? ", " : "") + std::string(style::names_of<V>[i]);
        }
        throw std::invalid_argument(std::string(name) + " is '" + word + "'; it can be: " + known);
    } else {
        return given.cast<V>();
    }
}

template <typename V>
py::object value_to(const V& value) {
    if constexpr (std::is_enum_v<V>)
        return py::str(style::names_of<V>[static_cast<int>(value)]);
    else
        return py::cast(value);
}

/// A record with some of its members set.
template <style::Record S>
S with(S record, const py::kwargs& given) {
    std::size_t known = 0;
    style::for_each_field<S>([&]<typename V>(const style::Field<S, V>& field) {
        if (!given.contains(field.name)) return;
        record.*field.member = value_from<V>(given[field.name], field.name);
        ++known;
    });
    if (known < given.size())
        for (const auto& [key, value] : given) {
            bool found = false;
            style::for_each_field<S>([&](const auto& field) { found |= key.cast<std::string>() == field.name; });
            if (!found) throw py::type_error("there is no '" + key.cast<std::string>() + "'");
        }
    return record;
}

template <style::Record S>
py::class_<S> bind_record(py::module_& m, const char* name, const char* doc) {
    py::class_<S> bound(m, name, doc);
    bound.def(py::init([](const py::kwargs& given) { return with(S(), given); }));
    bound.def(
        "replace", [](const S& record, const py::kwargs& given) { return with(record, given); },
        "The same with other values.");
    bound.def("__eq__", [](const S& a, const S& b) { return a == b; }, py::is_operator());
    bound.def("__hash__", [](const S& record) {
        py::list values;
        style::for_each_field<S>([&](const auto& field) { values.append(value_to(record.*field.member)); });
        return py::hash(py::repr(values));
    });
    style::for_each_field<S>([&]<typename V>(const style::Field<S, V>& field) {
        bound.def_property_readonly(field.name,
                                    [member = field.member](const S& record) { return value_to(record.*member); });
    });
    return bound;
}

}  // namespace fovea::bindings
