// SPDX-License-Identifier: GPL-3.0-or-later
// Sheets of paper to draw on after a picture, and finding the picture's frame on scans of them.
#pragma once

#include <optional>

#include <fovea/study/homography.h>
#include <fovea/vector/document.h>
#include <fovea/vector/options.h>

namespace fovea::study {

/// A sheet with the picture in its upper half, and in its lower half the same, faint, in a frame with discs at its
/// corners by which a scan is registered; `title` below them. Throws std::invalid_argument for sheets without a size of
/// their own.
vector::Document prompt_sheet(const color::GrayImage& picture, vector::Sheet sheet, const std::string& title);

/// The map from pixels of a picture of width x height to those of a scan of its sheet, by the discs; none if they are
/// not found.
std::optional<Homography> found_by_marks(const color::GrayImage& scan, int width, int height);

}  // namespace fovea::study
