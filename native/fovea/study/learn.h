// SPDX-License-Identifier: GPL-3.0-or-later
// Models of lines, learned from samples.
#pragma once

#include <fovea/study/grow_tree.h>

namespace fovea::study {

struct ForestOptions {
    std::size_t trees = most_trees;
    bool random_samples = true;  ///< as many as there are, drawn with replacement; else all
    TreeOptions tree{.properties = 5, .slopes = false};
};

/// Least squares, with so little of a ridge that only terms that others give are decided by it.
LineModel learned_regression(const Samples& samples);
LineModel learned_tree(const Samples& samples, const TreeOptions& options = {});
/// Breiman, "Random Forests", 2001.
LineModel learned_forest(const Samples& samples, const ForestOptions& options = {});

LineModel learned(LineModel::Kind kind, const Samples& samples);

}  // namespace fovea::study
