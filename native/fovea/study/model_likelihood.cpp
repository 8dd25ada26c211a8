// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/study/model_likelihood.h>

#include <algorithm>

#include <fovea/image/local_fit.h>

namespace fovea::study {
namespace {

class ModelLikelihood final : public line::Likelihood {
   public:
    explicit ModelLikelihood(LineModel model) : model_(std::move(model)) {}

    double threshold() const override { return model_.threshold; }

    image::Buffer at(const Tracer& tracer, const image::ShadedBuffer& shaded, const Cancel& cancel) const override {
        constexpr int border = image::fit_reach;
        const LocalProperties properties = local_properties(tracer, shaded, border, cancel);
        const Array<float> inside = probabilities(model_, properties);
        const image::Lattice& lattice = shaded.lattice;
        image::Buffer all(lattice.size(), 0.0f);
        for (int y = border; y < lattice.height - border; ++y) {
            const auto row = inside.begin() + std::ptrdiff_t(y - border) * properties.known.width;
            std::copy_n(row, properties.known.width, all.begin() + std::ptrdiff_t(lattice.at(border, y)));
        }
        return all;
    }

   private:
    LineModel model_;
};

}  // namespace

std::shared_ptr<const line::Likelihood> likelihood_of(LineModel model) {
    return std::make_shared<ModelLikelihood>(std::move(model));
}

}  // namespace fovea::study
