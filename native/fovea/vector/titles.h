// SPDX-License-Identifier: GPL-3.0-or-later
// What a title block says.
#pragma once

#include <string>

#include <fovea/style/field.h>

namespace fovea::vector {

/// Data fields of ISO 7200:2004, "Technical product documentation - Data fields in title blocks and document headers";
/// each may be empty. The scale and the size of the sheet are not among them: they are what they are.
struct Titles {
    std::string title = {}, document = {}, number = {}, revision = {}, sheet = {}, date = {}, creator = {};
    std::string approver = {}, owner = {};

    bool operator==(const Titles&) const = default;

    static constexpr auto fields = each_of(
        style::Field{"title", &Titles::title, "Title", "What is drawn"},
        style::Field{"document", &Titles::document, "Document Type", "As floor plan, section, assembly drawing"},
        style::Field{"number", &Titles::number, "Drawing Number", "By which the owner finds the drawing"},
        style::Field{"revision", &Titles::revision, "Revision", "Letter or number of this state of the drawing"},
        style::Field{"sheet", &Titles::sheet, "Sheet", "Number of the sheet and of all sheets, as 1/3"},
        style::Field{"date", &Titles::date, "Date of Issue", "When it was released, as 2026-05-31"},
        style::Field{"creator", &Titles::creator, "Created By", "Who made the drawing"},
        style::Field{"approver", &Titles::approver, "Approved By", "Who released it"},
        style::Field{"owner", &Titles::owner, "Legal Owner", "The office or company whose drawing it is"});
};

}  // namespace fovea::vector
