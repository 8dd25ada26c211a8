// SPDX-License-Identifier: GPL-3.0-or-later
// What holds of every input: the arrays of a picture are numbers that fit together, and what is refused is told.
#pragma once

#include <stdexcept>
#include <string>

#include <fovea/draw/frame.h>

namespace fovea::fuzz {

/// A rule is broken.
struct Broken : std::logic_error {
    using std::logic_error::logic_error;
};

/// Throws Broken, naming the array, where one of a finished frame holds NaN or infinity, a run is empty or of no piece,
/// or a picture has not its size.
void check_arrays(draw::Frame& frame);

/// Throws Broken unless the message is one clear sentence that names one of the objects, a member of a style or of the
/// options, or the camera: one line of printable text, without words of the implementation.
void check_sentence(const std::string& message);

/// The message without its numbers and quoted words, which stand for all that are alike.
std::string kind_of_sentence(const std::string& message);

}  // namespace fovea::fuzz
