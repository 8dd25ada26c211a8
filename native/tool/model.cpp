// SPDX-License-Identifier: GPL-3.0-or-later
#include <tool/model.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include <fovea/base/check.h>
#include <fovea/base/files.h>
#include <fovea/mesh/polygon_surface.h>

namespace fovea::tool {
namespace {

constexpr std::size_t most_elements = std::size_t(none / 4);  // limit of a surface

}  // namespace

std::shared_ptr<Surface> Model::surface() const {
    return polygon_surface(name, positions, corner_verts, polygon_offsets, material);
}

std::vector<vec3> Model::drawn_positions() const {
    const auto is_finite = [&](int v) { return std::isfinite(positions[v].x + positions[v].y + positions[v].z); };
    std::vector<bool> drawn(positions.size());
    for (Index f = 0; f < polygon_count(); ++f) {
        const auto begin = corner_verts.begin() + polygon_offsets[f],
                   end = corner_verts.begin() + polygon_offsets[f + 1];
        if (std::all_of(begin, end, is_finite))
            for (auto corner = begin; corner != end; ++corner) drawn[*corner] = true;
    }
    std::vector<vec3> found;
    for (std::size_t v = 0; v < positions.size(); ++v)
        if (drawn[v]) found.push_back(positions[v]);
    return found;
}

void refuse(const std::string& file, const char* unit, std::size_t place, const std::string& what) {
    throw std::invalid_argument(file + ", " + unit + " " + std::to_string(place) + ": " + what);
}

ModelBuilder::ModelBuilder(const std::string& file, const char* unit) : file_(file), unit_(unit) {
    model_.name = name_of(file_of(file).stem());
}

void ModelBuilder::note(Broken& broken, std::size_t place, const std::string& what) const {
    if (broken.count++ == 0) broken.first = unit_ + (" " + std::to_string(place)) + ": " + what;
}

void ModelBuilder::add_broken_vertex(std::size_t place, const std::string& what) {
    note(model_.vertices, place, what);
    add_vertex(dvec3(std::numeric_limits<double>::quiet_NaN()));
}

void ModelBuilder::add_polygon(In<std::int64_t> vertices, int material, std::size_t place) {
    if (vertices.size() < 3) {
        note(model_.polygons, place, "a polygon has fewer than three corners");
        return;
    }
    if (model_.corner_verts.size() + vertices.size() > most_elements)
        refuse(file_, unit_, place, "there are more than a billion corners of polygons");
    for (const std::int64_t v : vertices)
        model_.corner_verts.push_back(v >= 0 && v < std::int64_t(most_elements) ? int(v) : -1);
    model_.polygon_offsets.push_back(int(model_.corner_verts.size()));
    model_.material.push_back(material);
    places_.push_back(place);
}

Model ModelBuilder::finish() {
    check(model_.positions.size() < most_elements, file_ + " has more than a billion vertices");
    std::vector<int>&verts = model_.corner_verts, &offsets = model_.polygon_offsets;
    int kept = 0, corners = 0;
    for (std::size_t f = 0, begin = 0; f < places_.size(); ++f) {
        const std::size_t end = offsets[f + 1];
        const bool exist = std::all_of(verts.begin() + begin, verts.begin() + end,
                                       [&](int v) { return v >= 0 && v < vertex_count(); });
        if (exist) {
            std::copy(verts.begin() + begin, verts.begin() + end, verts.begin() + corners);
            corners += int(end - begin);
            model_.material[kept] = model_.material[f];
            offsets[++kept] = corners;
        } else {
            note(model_.polygons, places_[f], "a polygon names a vertex that is not there");
        }
        begin = end;
    }
    verts.resize(corners);
    offsets.resize(kept + 1);
    model_.material.resize(kept);
    return std::move(model_);
}

}  // namespace fovea::tool
