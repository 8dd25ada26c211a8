// SPDX-License-Identifier: GPL-3.0-or-later
// Shipped pen textures, papers and washes: gray PNG files by name.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include <fovea/color/paper.h>
#include <fovea/stroke/pen.h>

namespace fovea::draw {

/// Reads and caches each file once; thread-safe.
class Assets {
   public:
    struct Texture {
        PenTexture ink;
        double length_in_widths;  ///< of one repetition, in widths of the pen
    };

    /// A folder with the folders `textures` (with textures.json: {name: {"length_in_widths": number}}), `papers` and
    /// `washes` (with papers.json and washes.json: {name: {"tile_mm": number}}).
    explicit Assets(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// Null: solid. White is full ink. Throws std::invalid_argument, naming the file, if it cannot be read.
    std::shared_ptr<const Texture> texture(const std::string& name) const;
    /// Length of one repetition in widths of the pen; 1 if not specified.
    double texture_length(const std::string& name) const;
    /// Null: smooth. White is high. Throws as `texture`.
    std::shared_ptr<const PaperTexture> paper(const std::string& name) const;
    /// How water spreads in washes; white is where it leaves least pigment. Throws as `texture`.
    std::shared_ptr<const PaperTexture> wash(const std::string& name) const;

   private:
    std::filesystem::path file(const char* kind, const std::string& name, const char* suffix = ".png") const;
    double size(const char* kind, const char* key, const std::string& name) const;
    std::shared_ptr<const PaperTexture> sheet(const char* kind, const std::string& name) const;

    std::filesystem::path folder_;
    mutable std::mutex mutex_;
    mutable std::map<std::string, std::map<std::string, double>> sizes_;  ///< by kind
    mutable std::map<std::string, std::shared_ptr<const Texture>> textures_;
    mutable std::map<std::filesystem::path, std::shared_ptr<const PaperTexture>> sheets_;  ///< by file
};

}  // namespace fovea::draw
