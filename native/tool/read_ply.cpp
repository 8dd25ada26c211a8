// SPDX-License-Identifier: GPL-3.0-or-later
#include <tool/read_ply.h>

#include <array>
#include <cmath>
#include <tool/ply_values.h>

namespace fovea::tool {
namespace {

/// Use of a property.
enum Role { other, x, y, z, corners };

Role role_of(const PlyElement& element, const PlyProperty& property) {
    if (element.name == "vertex" && !property.is_list && property.name.size() == 1)
        return property.name == "x" ? x : property.name == "y" ? y : property.name == "z" ? z : other;
    const bool indices = property.name == "vertex_indices" || property.name == "vertex_index";
    return element.name == "face" && property.is_list && indices ? corners : other;
}

/// Converts a value to a vertex number; -1 if it is none.
std::int64_t index_of(double value) {
    return value >= 0.0 && value < double(none) && value == std::floor(value) ? std::int64_t(value) : -1;
}

/// Whether one of an element's properties has a role.
bool has(const PlyElement& element, Role role) {
    for (const PlyProperty& property : element.properties)
        if (role_of(element, property) == role) return true;
    return false;
}

class PlyReader {
   public:
    PlyReader(const std::string& file, std::string_view bytes, const PlyHeader& header)
        : values_(file, bytes, header), builder_(file, values_.unit()) {}

    void read(const PlyElement& element) {
        values_.check_room(element);
        if (element.properties.empty()) return;
        const bool is_vertex = has(element, x) && has(element, y) && has(element, z), is_face = has(element, corners);
        std::vector<Role> roles;
        for (const PlyProperty& property : element.properties) roles.push_back(role_of(element, property));
        for (std::uint64_t i = 0; i < element.count; ++i) {
            const std::size_t place = values_.place();
            for (std::size_t p = 0; p < roles.size(); ++p) read(element.properties[p], roles[p]);
            if (is_vertex) builder_.add_vertex(position_);
            if (is_face) builder_.add_polygon(vertices_, 0, place);
        }
    }

    Model finish() { return builder_.finish(); }

   private:
    void read(const PlyProperty& property, Role role) {
        if (!property.is_list) {
            const double value = values_.next(property.type);
            if (role != other) position_[role - x] = value;
            return;
        }
        std::size_t count = values_.next_count(property);
        if (role == corners) vertices_.clear();
        for (; count > 0; --count) {
            const double value = values_.next(property.type);
            if (role == corners) vertices_.push_back(index_of(value));
        }
    }

    PlyValues values_;
    ModelBuilder builder_;
    dvec3 position_{0.0};
    std::vector<std::int64_t> vertices_;
};

}  // namespace

Model read_ply(const std::string& file, std::string_view bytes) {
    const PlyHeader header = ply_header(file, bytes);
    bool has_vertices = false;
    for (const PlyElement& element : header.elements)
        has_vertices |= has(element, x) && has(element, y) && has(element, z) && element.count > 0;
    if (!has_vertices)
        refuse(file, "line", header.lines, "the header ends without an element 'vertex' with x, y and z");
    PlyReader reader(file, bytes, header);
    for (const PlyElement& element : header.elements) reader.read(element);
    return reader.finish();
}

}  // namespace fovea::tool
