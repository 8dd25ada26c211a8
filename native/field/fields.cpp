#include "field/fields.h"

#include <algorithm>
#include <cmath>

#include "base/hash.h"
#include "base/parallel.h"
#include "field/jets.h"
#include "field/normals.h"

namespace fovea {
namespace {

Fields find_fields(const Surface& surface, const FieldOptions& options) {
    Fields fields;
    JetOptions jets;
    if (options.degree) jets.degree = options.degree;
    if (options.rings) jets.rings = options.rings;
    fields.curvature = jet_curvature(surface, jets);
    fields.feature_size = feature_size(surface, fields.curvature);
    fields.reason = "jets of degree " + std::to_string(jets.degree) + " over " + std::to_string(jets.rings) + " rings";
    return fields;
}

}  // namespace

std::shared_ptr<const Fields> fields_of(const Surface& surface, const FieldOptions& options) {
    const std::uint64_t key = hash_numbers(options.degree, options.rings);
    return surface.cache().get<Fields>(key, [&] { return find_fields(surface, options); });
}

float feature_size(const Surface& surface, const Array<Curvature>& curvature) {
    struct Sample {
        float k, area;
    };
    const Array<float> areas = vertex_areas(surface, *neighbours_of(surface, no_hard_edges));
    std::vector<Sample> samples(2 * curvature.size());
    parallel_for(curvature.size(), [&](std::size_t v) {
        samples[2 * v] = {std::abs(curvature[v].k1), areas[v]};
        samples[2 * v + 1] = {std::abs(curvature[v].k2), areas[v]};
    });
    std::sort(samples.begin(), samples.end(), [](const Sample& a, const Sample& b) { return a.k < b.k; });
    double total = 0.0, sum = 0.0;
    for (const Sample& s : samples) total += s.area;
    float quantile = 0.0f;
    for (const Sample& s : samples) {
        sum += s.area;
        quantile = s.k;
        if (sum >= 0.1 * total) break;
    }
    const float most = 0.05f * surface.radius;
    return quantile > 0.0f ? std::min(0.01f / quantile, most) : most;
}

}  // namespace fovea
