// SPDX-License-Identifier: GPL-3.0-or-later
// Basic types: GLM vectors, indices, borrowed and owned arrays.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include <fovea/base/large_memory.h>
#include <fovea/base/namespaces.h>

namespace fovea::base {

using glm::dmat3;
using glm::dmat4;
using glm::dvec2;
using glm::dvec3;
using glm::dvec4;
using glm::mat4;
using glm::vec2;
using glm::vec3;
using glm::vec4;

/// Twice the signed area of the triangle (0, a, b): positive where b is counterclockwise of a.
inline double cross(const dvec2& a, const dvec2& b) { return a.x * b.y - a.y * b.x; }

/// Zero where a vector has no length, or no finite one.
inline dvec3 unit_or_zero(const dvec3& v) {
    const double length = glm::length(v);
    return length > 0.0 && std::isfinite(length) ? v / length : dvec3(0.0);
}

/// Index of a vertex, edge, polygon, facet, path or sample; `none` means no such element.
using Index = std::uint32_t;
inline constexpr Index none = 0xffffffffu;

inline constexpr float infinity = std::numeric_limits<float>::infinity();  ///< as a double, too

/// Borrowed, read-only array; valid for the duration of a call.
template <typename T>
using In = std::span<const T>;

/// Allocator that leaves trivial values uninitialized: arrays of millions are filled in parallel right afterwards.
/// Large arrays have memory of their own (base/large_memory.h).
template <typename T>
struct UninitializedAllocator : std::allocator<T> {
    template <typename U>
    struct rebind {
        using other = UninitializedAllocator<U>;
    };
    T* allocate(std::size_t count) {
        if (count > SIZE_MAX / sizeof(T)) throw std::bad_array_new_length();
        const std::size_t bytes = count * sizeof(T);
        return is_large(bytes) ? static_cast<T*>(allocate_large(bytes)) : std::allocator<T>::allocate(count);
    }
    void deallocate(T* memory, std::size_t count) noexcept {
        if (is_large(count * sizeof(T)))
            free_large(memory, count * sizeof(T));
        else
            std::allocator<T>::deallocate(memory, count);
    }
    template <typename U>
    void construct(U* p) noexcept {
        ::new (static_cast<void*>(p)) U;
    }
    template <typename U, typename... Args>
    void construct(U* p, Args&&... args) {
        ::new (static_cast<void*>(p)) U(std::forward<Args>(args)...);
    }
};

/// Owned array.
template <typename T>
using Array = std::vector<T, UninitializedAllocator<T>>;

/// Row offsets of a flat array (as in CSR): row i is [offsets[i], offsets[i + 1]).
struct Rows {
    Array<Index> offsets{0};
    Index count() const { return static_cast<Index>(offsets.size()) - 1; }
    Index begin(Index i) const { return offsets[i]; }
    Index end(Index i) const { return offsets[i + 1]; }
    Index size(Index i) const { return offsets[i + 1] - offsets[i]; }
};

/// Rows together with their flat array of values.
template <typename T>
struct Lists : Rows {
    Array<T> values;
    In<T> operator[](Index i) const { return {values.data() + begin(i), size(i)}; }
    std::span<T> operator[](Index i) { return {values.data() + begin(i), size(i)}; }
};

}  // namespace fovea::base
