// SPDX-License-Identifier: GPL-3.0-or-later
// Models of lines, as line definitions are given them.
#pragma once

#include <fovea/line/likelihood.h>
#include <fovea/study/line_model.h>

namespace fovea::study {

std::shared_ptr<const line::Likelihood> likelihood_of(LineModel model);

}  // namespace fovea::study
