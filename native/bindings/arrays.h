// SPDX-License-Identifier: GPL-3.0-or-later
// The only way between numpy and native arrays: views without copies, checked shapes.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <string>

#include <fovea/base/check.h>
#include <fovea/base/columns.h>
#include <fovea/base/types.h>

namespace fovea::bindings {

namespace py = pybind11;

/// Scalar type and number of columns of an element: float for vec3, 3 columns; a plain number has none.
template <typename T>
struct Element {
    using Scalar = T;
    static constexpr int columns = 0;
};
template <int N, typename S, glm::qualifier Q>
struct Element<glm::vec<N, S, Q>> {
    using Scalar = S;
    static constexpr int columns = N;
};

template <typename T>
std::vector<py::ssize_t> shape_of(std::size_t count) {
    if constexpr (Element<T>::columns > 0) return {py::ssize_t(count), Element<T>::columns};
    return {py::ssize_t(count)};
}

/// Numpy array over memory that `owner` keeps alive; no copy.
template <typename T>
py::array view_numpy(const Array<T>& array, py::handle owner) {
    using Scalar = typename Element<T>::Scalar;
    static const Scalar nothing{};
    const auto* data = array.empty() ? &nothing : reinterpret_cast<const Scalar*>(array.data());
    py::array_t<Scalar> result(shape_of<T>(array.size()), data, owner);
    result.attr("flags").attr("writeable") = false;
    return result;
}

/// The columns of a bound structure (base/columns.h) as read-only properties.
template <typename Class, typename Columns>
void bind_columns(Class& bound, const Columns& columns) {
    for_each_column(columns, [&]<typename S, typename V>(const Column<S, V>& column) {
        const auto view = [array = column.array](py::object self) {
            return view_numpy(self.cast<const S&>().*array, self);
        };
        bound.def_property_readonly(column.name, view, column.doc);
    });
}

/// Numpy array that takes the memory over; no copy.
template <typename T>
py::array to_numpy(Array<T>&& array) {
    using Scalar = typename Element<T>::Scalar;
    auto* owned = new Array<T>(std::move(array));
    py::capsule owner(owned, [](void* p) { delete static_cast<Array<T>*>(p); });
    static const Scalar nothing{};
    const auto* data = owned->empty() ? &nothing : reinterpret_cast<const Scalar*>(owned->data());
    return py::array_t<Scalar>(shape_of<T>(owned->size()), data, owner);
}

/// An argument: contiguous array of the right type (converted, with a copy, only when it is not).
template <typename T>
using Arg = py::array_t<typename Element<T>::Scalar, py::array::c_style | py::array::forcecast>;

/// Borrows an argument as a span of T; `name` appears in the error when the shape is not (n,) or (n, columns).
template <typename T>
In<T> borrow(const Arg<T>& array, const char* name) {
    constexpr int columns = Element<T>::columns;
    const bool fits = columns == 0 ? array.ndim() == 1 : array.ndim() == 2 && array.shape(1) == columns;
    check(fits, std::string(name) + ": expected shape (n" + (columns ? ", " + std::to_string(columns) : ",") + ")");
    return {reinterpret_cast<const T*>(array.data()), static_cast<std::size_t>(array.shape(0))};
}

/// The same for an optional argument: None is an empty span.
template <typename T>
In<T> borrow(const std::optional<Arg<T>>& array, const char* name) {
    return array ? borrow<T>(*array, name) : In<T>{};
}

/// Elements of its own.
template <typename T>
Array<T> copy(const Arg<T>& array, const char* name) {
    const In<T> in = borrow<T>(array, name);
    return Array<T>(in.begin(), in.end());
}

}  // namespace fovea::bindings
