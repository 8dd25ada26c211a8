// SPDX-License-Identifier: GPL-3.0-or-later
// Conversion between numpy and native arrays: views without copies, checked shapes; and release of the GIL.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <string>

#include <fovea/base/check.h>
#include <fovea/base/columns.h>
#include <fovea/base/types.h>

/// GLM vectors: from any sequence of N numbers, to a tuple.
template <int N, typename T, glm::qualifier Q>
struct pybind11::detail::type_caster<glm::vec<N, T, Q>> {
    using Vector = glm::vec<N, T, Q>;
    using Numbers = std::array<T, N>;
    PYBIND11_TYPE_CASTER(Vector, make_caster<Numbers>::name);

    bool load(handle given, bool convert) {
        make_caster<Numbers> numbers;
        if (!numbers.load(given, convert)) return false;
        for (int i = 0; i < N; ++i) value[i] = cast_op<Numbers&>(numbers)[i];
        return true;
    }
    static handle cast(const Vector& vector, return_value_policy, handle) {
        tuple numbers(N);
        for (int i = 0; i < N; ++i) numbers[i] = vector[i];
        return numbers.release();
    }
};

namespace fovea::bindings {

using namespace draw;

namespace py = pybind11;

/// Scalar type and number of columns of an element: float and 3 for vec3; a plain number has 0 columns.
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

/// Of a bound function that runs without the GIL: it must not use Python objects.
using NoGil = py::call_guard<py::gil_scoped_release>;

/// Returns body(), called without the GIL, as NoGil.
template <typename Body>
auto without_gil(const Body& body) {
    py::gil_scoped_release release;
    return body();
}

template <typename T>
using Numpy = py::array_t<typename Element<T>::Scalar>;

/// Numpy array over memory that `owner` keeps alive; no copy.
template <typename T>
Numpy<T> view_numpy(const Array<T>& array, py::handle owner, bool writeable = false) {
    using Scalar = typename Element<T>::Scalar;
    static const Scalar nothing{};
    const auto* data = array.empty() ? &nothing : reinterpret_cast<const Scalar*>(array.data());
    Numpy<T> result(shape_of<T>(array.size()), data, owner);
    if (!writeable) result.attr("flags").attr("writeable") = false;
    return result;
}

/// Getter of an array member: a view that keeps its owner alive.
template <typename Owner, typename Structure, typename T>
auto viewing(Array<T> Structure::* array) {
    return [array](py::object self) { return view_numpy(self.cast<const Owner&>().*array, self); };
}

/// Getter of row offsets into an owner's flat arrays.
template <typename Owner, typename Structure>
auto viewing_rows(Rows Structure::* rows) {
    return [rows](py::object self) { return view_numpy((self.cast<const Owner&>().*rows).offsets, self); };
}

/// Binds the columns (base/columns.h) of a structure, or of a part of it, as read-only properties.
template <typename Class, typename Columns>
void bind_columns(Class& bound, const Columns& columns) {
    for_each_column(columns, [&](const auto& column) {
        bound.def_property_readonly(column.name, viewing<typename Class::type>(column.array), column.doc);
    });
}

/// Numpy array that takes ownership of the memory; no copy.
template <typename T>
Numpy<T> to_numpy(Array<T>&& array) {
    auto* owned = new Array<T>(std::move(array));
    const py::capsule owner(owned, [](void* p) { delete static_cast<Array<T>*>(p); });
    return view_numpy(*owned, owner, true);
}

/// The same for pixels, bottom row first: shape (height, width) or (height, width, columns).
template <typename T>
Numpy<T> to_image(Array<T>&& pixels, int width, int height) {
    std::vector<py::ssize_t> shape{height, width};
    if constexpr (Element<T>::columns > 0) shape.push_back(Element<T>::columns);
    return to_numpy(std::move(pixels)).reshape(shape);
}

/// An argument: contiguous array of the right type (converted, with a copy, only if it is not).
template <typename T>
using Arg = py::array_t<typename Element<T>::Scalar, py::array::c_style | py::array::forcecast>;

/// The same, or None.
template <typename T>
using Optional = std::optional<Arg<T>>;

/// An argument of any shape: an image or a texture, say.
using Pixels = py::array_t<float, py::array::c_style | py::array::forcecast>;

/// Borrows an argument as a span of T; `name` appears in the error if the shape is not (n,) or (n, columns).
template <typename T>
In<T> borrow(const Arg<T>& array, const char* name) {
    constexpr int columns = Element<T>::columns;
    const bool fits = columns == 0 ? array.ndim() == 1 : array.ndim() == 2 && array.shape(1) == columns;
    check(fits, std::string(name) + ": expected shape (n" + (columns ? ", " + std::to_string(columns) : ",") + ")");
    return {reinterpret_cast<const T*>(array.data()), static_cast<std::size_t>(array.shape(0))};
}

/// The same for an optional argument: None is an empty span.
template <typename T>
In<T> borrow(const Optional<T>& array, const char* name) {
    return array ? borrow<T>(*array, name) : In<T>{};
}

/// The same, with the argument appended to the `owners` of what is borrowed.
template <typename T>
In<T> kept(const Optional<T>& array, const char* name, std::vector<py::object>& owners) {
    if (array) owners.push_back(*array);
    return borrow<T>(array, name);
}

/// Copies an argument into an array.
template <typename T>
Array<T> copy(const Arg<T>& array, const char* name) {
    const In<T> in = borrow<T>(array, name);
    return Array<T>(in.begin(), in.end());
}

}  // namespace fovea::bindings

/// Arrays of numbers and vectors that a bound function returns: to numpy arrays that take ownership of the memory.
template <typename T>
    requires std::is_arithmetic_v<typename fovea::bindings::Element<T>::Scalar>
struct pybind11::detail::type_caster<fovea::base::Array<T>> {
    static constexpr auto name = make_caster<fovea::bindings::Numpy<T>>::name;
    static handle cast(fovea::base::Array<T>&& array, return_value_policy, handle) {
        return fovea::bindings::to_numpy(std::move(array)).release();
    }
};
