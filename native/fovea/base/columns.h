// SPDX-License-Identifier: GPL-3.0-or-later
// Structures of arrays: each lists its columns (member arrays) once, and generic code loops over that list.
#pragma once

#include <algorithm>

#include <fovea/base/check.h>
#include <fovea/base/each_of.h>
#include <fovea/base/parallel.h>

namespace fovea::base {

/// One array of a structure. Columns of equal length (one entry per path, say, or per point) form a group: each_of
/// some Columns, a static member of the structure.
template <typename Structure, typename Value>
struct Column {
    const char* name;  ///< its name in scripts
    Array<Value> Structure::* array;
    const char* doc;  ///< shape, type, meaning, unit
};

/// Calls visit(column) for each column of a group, in order.
template <typename Columns, typename Visit>
void for_each_column(const Columns& columns, const Visit& visit) {
    columns(visit);
}

template <typename Structure, typename Columns>
void reserve_columns(Structure& structure, const Columns& columns, std::size_t count) {
    for_each_column(columns, [&](const auto& column) { (structure.*column.array).reserve(count); });
}

/// New entries of plain numbers and vectors are uninitialized.
template <typename Structure, typename Columns>
void resize_columns(Structure& structure, const Columns& columns, std::size_t count) {
    for_each_column(columns, [&](const auto& column) { (structure.*column.array).resize(count); });
}

/// Appends one entry to each column, value-initialized (zero).
template <typename Structure, typename Columns>
void append_zeros(Structure& structure, const Columns& columns) {
    for_each_column(columns, [&](const auto& column) { (structure.*column.array).push_back({}); });
}

/// Copies the columns of `from` over entries `at` and following of those of `to`, which must be long enough.
template <typename Structure, typename Columns>
void copy_columns(const Structure& from, const Columns& columns, Structure& to, std::size_t at) {
    for_each_column(columns, [&](const auto& column) {
        std::copy((from.*column.array).begin(), (from.*column.array).end(), (to.*column.array).begin() + at);
    });
}

/// Concatenates triangle strips in order and offsets their vertex indices; each part is freed once it is copied.
/// `Strips` has `vertex_columns` (the first of which is px) and `triangles`, which index its vertices. Throws
/// std::invalid_argument, naming `name`, if the vertices exceed 32-bit indices.
template <typename Strips>
Strips join_strips(std::vector<Strips>& parts, const char* name) {
    std::vector<std::size_t> vertices, triangles;
    for (const Strips& part : parts) {
        vertices.push_back(part.px.size());
        triangles.push_back(part.triangles.size());
    }
    counts_to_offsets(vertices);
    counts_to_offsets(triangles);
    check(vertices.back() < none, std::string(name) + ": too many vertices for 32-bit indices");
    Strips all;
    resize_columns(all, Strips::vertex_columns, vertices.back());
    all.triangles.resize(triangles.back());
    parallel_for(parts.size(), 1, [&](std::size_t i) {
        const Strips part = std::move(parts[i]);
        copy_columns(part, Strips::vertex_columns, all, vertices[i]);
        std::ranges::transform(part.triangles, all.triangles.begin() + triangles[i],
                               [&](glm::uvec3 t) { return t + Index(vertices[i]); });
    });
    return all;
}

}  // namespace fovea::base
