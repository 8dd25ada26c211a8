// SPDX-License-Identifier: GPL-3.0-or-later
// The fuzz target: an input becomes a picture, or is refused.
#pragma once

#include <cstdint>
#include <string>

namespace fovea::fuzz {

/// An input, and its text: "meshes 17".
struct Input {
    enum Kind : std::uint8_t { meshes, styles };
    Kind kind = meshes;
    std::uint64_t seed = 0;

    std::string text() const;
    /// Throws std::invalid_argument for a text that is no input.
    static Input read(const std::string& text);
};

/// What an input consists of, as JSON, for people: surfaces, placements, view, options and style. Throws what making
/// them throws.
std::string description(const Input& input);

/// Draws the picture of an input. Returns what it was refused with; empty: it was drawn. Throws Broken (rules.h) where
/// a rule does not hold, and what must not be thrown.
std::string run(const Input& input);

}  // namespace fovea::fuzz
