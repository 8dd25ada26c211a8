// SPDX-License-Identifier: GPL-3.0-or-later
// Documents as PDF files.
#pragma once

#include <string>

#include <fovea/vector/document.h>

namespace fovea::vector {

/// The bytes of a PDF file (1.5) of one page, with layers as optional content. Where the document's unit is the pixel,
/// there are 96 to an inch. Streams are compressed by zlib: another version of it may make other bytes of them.
std::string pdf_bytes(const Document& document);

}  // namespace fovea::vector
