// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/draw/assets.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <nlohmann/json.hpp>

#include <fovea/base/check.h>
#include <fovea/color/png.h>

namespace fovea::draw {

/// Path of a shipped file. Names come from untrusted style files, so they must not leave the folder.
std::filesystem::path Assets::file(const char* kind, const std::string& name) const {
    const auto plain = [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-'; };
    check(!name.empty() && std::ranges::all_of(name, plain), "'" + name + "' is no name of a texture");
    return folder_ / kind / (name + ".png");
}

/// The number that KIND/KIND.json has for a file; 1 if it has none.
double Assets::size(const char* kind, const char* key, const std::string& name) const {
    const std::lock_guard lock(mutex_);
    auto& sizes = sizes_[kind];
    if (sizes.empty()) {
        const std::filesystem::path path = folder_ / kind / (std::string(kind) + ".json");
        std::ifstream file(path);
        const auto data = nlohmann::json::parse(file, nullptr, false);
        check(data.is_object(), path.string() + " cannot be read");
        for (const auto& [entry, values] : data.items()) sizes[entry] = values.value(key, 1.0);
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
    if (!kept) kept = std::make_shared<Texture>(read_texture(file("textures", name).string()), length);
    return kept;
}

std::shared_ptr<const PaperTexture> Assets::sheet(const char* kind, const std::string& name) const {
    const std::string path = file(kind, name).string();
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
