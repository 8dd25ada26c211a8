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

const std::map<std::string, double>& Assets::lengths() const {
    if (lengths_.empty()) {
        std::ifstream file(folder_ / "textures" / "textures.json");
        const auto data = nlohmann::json::parse(file, nullptr, false);
        check(data.is_object(), (folder_ / "textures" / "textures.json").string() + " cannot be read");
        for (const auto& [name, entry] : data.items()) lengths_[name] = entry.value("length_in_widths", 1.0);
    }
    return lengths_;
}

double Assets::texture_length(const std::string& name) const {
    if (name == "solid") return 1.0;
    const std::lock_guard lock(mutex_);
    const auto found = lengths().find(name);
    return found == lengths().end() ? 1.0 : found->second;
}

std::shared_ptr<const Assets::Texture> Assets::texture(const std::string& name) const {
    if (name == "solid") return nullptr;
    const double length = texture_length(name);
    const std::lock_guard lock(mutex_);
    auto& kept = textures_[name];
    if (!kept) kept = std::make_shared<Texture>(read_texture(file("textures", name).string()), length);
    return kept;
}

std::shared_ptr<const PaperTexture> Assets::paper(const std::string& name) const {
    if (name == "none") return nullptr;
    const std::lock_guard lock(mutex_);
    auto& kept = papers_[name];
    if (!kept) {
        const PenTexture read = read_texture(file("papers", name).string());
        kept = std::make_shared<PaperTexture>(read.ink, read.width, read.height);
    }
    return kept;
}

}  // namespace fovea::draw
