// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/vector/file.h>

#include <fovea/vector/dxf.h>
#include <fovea/vector/pdf.h>
#include <fovea/vector/svg.h>

namespace fovea::vector {

std::optional<Kind> kind_of(std::string_view suffix) {
    int number = 0;
    for (const style::Choice& choice : style::choices_of<Kind>) {
        if (suffix == choice.name) return Kind(number);
        ++number;
    }
    return std::nullopt;
}

Options fitting(Kind kind, Options options) {
    if (kind != Kind::dxf) return options;
    options.widths = Widths::center;
    options.dashes_apart = true;
    options.ground = false;
    return options;
}

std::string bytes_of(const Document& document, Kind kind) {
    switch (kind) {
        case Kind::pdf:
            return pdf_bytes(document);
        case Kind::dxf:
            return dxf_bytes(document);
        default:
            return svg_bytes(document);
    }
}

}  // namespace fovea::vector
