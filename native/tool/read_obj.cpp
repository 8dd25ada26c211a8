// SPDX-License-Identifier: GPL-3.0-or-later
#include <tool/read_obj.h>

#include <map>
#include <optional>
#include <tool/text.h>

namespace fovea::tool {
namespace {

/// The first three numbers of a line; weights or colors may follow.
std::optional<dvec3> coordinates(std::string_view line) {
    dvec3 position;
    for (int axis = 0; axis < 3; ++axis) {
        const std::optional<double> value = to_number(take_word(line));
        if (!value) return {};
        position[axis] = *value;
    }
    return position;
}

/// Vertex number, from 0, of a corner VERTEX, VERTEX/UV, VERTEX//NORMAL or VERTEX/UV/NORMAL. `count`: vertices so far;
/// negative numbers in the file count backwards from there. Negative if there is no such vertex.
std::int64_t corner_vertex(std::string_view word, std::int64_t count) {
    const std::optional<std::int64_t> number = take_integer(word);
    if (!number || !(word.empty() || word.front() == '/')) return -1;
    return *number < 0 ? count + *number : *number - 1;
}

void take_corners(std::string_view line, std::int64_t count, std::vector<std::int64_t>& vertices) {
    vertices.clear();
    for (std::string_view word = take_word(line); !word.empty() && word.front() != '#'; word = take_word(line))
        vertices.push_back(corner_vertex(word, count));
}

}  // namespace

Model read_obj(const std::string& file, std::string_view text) {
    if (const std::size_t zero = text.find('\0'); zero != text.npos)
        refuse(file, "byte", zero, "this is no text, as OBJ files are");
    ModelBuilder builder(file, "line");
    std::vector<std::int64_t> vertices;
    std::map<std::string, int, std::less<>> materials;
    int material = 0;
    Lines lines(text);
    while (std::optional<std::string_view> line = lines.next()) {
        const std::string_view key = take_word(*line);
        if (key == "v") {
            if (const std::optional<dvec3> position = coordinates(*line))
                builder.add_vertex(*position);
            else
                builder.add_broken_vertex(lines.number(), "a vertex has no three numbers");
        } else if (key == "f") {
            take_corners(*line, builder.vertex_count(), vertices);
            builder.add_polygon(vertices, material, lines.number());
        } else if (key == "usemtl") {
            const std::string name(trimmed(*line));
            material = name.empty() ? 0 : materials.try_emplace(name, int(materials.size()) + 1).first->second;
        }
    }
    if (builder.vertex_count() == 0) refuse(file, "line", lines.number(), "the file ends without a vertex (v X Y Z)");
    Model model = builder.finish();
    model.y_up = true;
    return model;
}

}  // namespace fovea::tool
