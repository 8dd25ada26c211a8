// SPDX-License-Identifier: GPL-3.0-or-later
// Models of lines that are a rule.
#pragma once

#include <fovea/study/model_likelihood.h>

namespace fovea {

/// Lines are where a property is below a number, and nowhere else.
inline study::LineModel lines_below(study::Property property, double number) {
    study::LineModel model{.kind = study::LineModel::Kind::tree};
    model.trees.push_back({.nodes = {{int(property), 1, number}, {-1, 0, 1.0}, {-1, 0, 0.0}}});
    return model;
}

}  // namespace fovea
