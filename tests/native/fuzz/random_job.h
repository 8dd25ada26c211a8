// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that a picture is drawn from.
#pragma once

#include <fovea/draw/frame.h>

#include "choices.h"

namespace fovea::fuzz {

/// A job with the arrays that its overrides borrow.
struct OwningJob {
    draw::Job job;
    std::vector<std::vector<float>> borrowed;
};

/// Up to a few surfaces, placed anyhow, seen anyhow, on the backend `cpu`. Throws what surfaces, and reading the
/// style's file, throw.
OwningJob random_job(Choices& choices);

/// A few boxes and a sphere seen as cameras see them, drawn in a style.
draw::Job plain_job(const style::Style& style);

}  // namespace fovea::fuzz
