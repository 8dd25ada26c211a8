// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/draw/assets.h>

#include <algorithm>
#include <cctype>

#include <fovea/base/check.h>
#include <fovea/base/files.h>
#include <fovea/color/png.h>
#include <fovea/style/json_value.h>

namespace fovea::draw {

/// Path of a file of a kind. Names come from untrusted style files, and folders with links from anywhere, so neither
/// may leave the folder.
std::filesystem::path Assets::file(const char* kind, const std::string& name, const char* suffix) const {
    const auto plain = [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-'; };
    check(!name.empty() && std::ranges::all_of(name, plain), "'" + name + "' is no name of a texture");
    check(!folder_.empty(), "a style with " + std::string(kind) + " needs their folder: name it by --assets");
    const std::filesystem::path path = folder_ / kind / (name + suffix);
    std::error_code problem;  // told where the file is read
    const auto whole = std::filesystem::weakly_canonical(path, problem);
    if (problem) return path;
    const auto inside = whole.lexically_relative(std::filesystem::weakly_canonical(folder_));
    check(!inside.empty() && *inside.begin() != "..", name_of(path) + " leads out of its folder");
    return path;
}

/// The number that KIND/KIND.json has for a file; 1 if it has none.
double Assets::size(const char* kind, const char* key, const std::string& name) const {
    const std::lock_guard lock(mutex_);
    auto& sizes = sizes_[kind];
    if (sizes.empty()) {
        const std::filesystem::path path = file(kind, kind, ".json");
        const style::JsonValue data = style::read_file(path, style::parse_json);
        check(data.type == style::JsonValue::Type::object, name_of(path) + " must be a JSON object");
        for (std::size_t i = 0; i < data.keys.size(); ++i) {
            const style::JsonValue* number = data.items[i].at(key);
            check(!number || number->number > 0.0, name_of(path) + ": " + data.keys[i] + " has no " + key + " above 0");
            sizes[data.keys[i]] = number ? number->number : 1.0;
        }
    }
    const auto found = sizes.find(name);
    return found == sizes.end() ? 1.0 : found->second;
}

double Assets::texture_length(const std::string& name) const {
    return name == "solid" ? 1.0 : size("textures", "length_in_widths", name);
}

std::shared_ptr<const Assets::Texture> Assets::texture(const std::string& name) const {
    if (name == "solid") return nullptr;
    const double length = texture_length(name);
    const std::lock_guard lock(mutex_);
    auto& kept = textures_[name];
    if (!kept) kept = std::make_shared<Texture>(read_texture(file("textures", name)), length);
    return kept;
}

std::shared_ptr<const PaperTexture> Assets::sheet(const char* kind, const std::string& name) const {
    const std::filesystem::path path = file(kind, name);
    const double tile_mm = size(kind, "tile_mm", name);
    const std::lock_guard lock(mutex_);
    auto& kept = sheets_[path];
    if (!kept) {
        const PenTexture read = read_texture(path);
        kept = std::make_shared<PaperTexture>(read.ink, read.width, read.height, tile_mm);
    }
    return kept;
}

std::shared_ptr<const PaperTexture> Assets::paper(const std::string& name) const {
    return name == "none" ? nullptr : sheet("papers", name);
}

std::shared_ptr<const PaperTexture> Assets::wash(const std::string& name) const { return sheet("washes", name); }

}  // namespace fovea::draw
