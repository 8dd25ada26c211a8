#include "field/fields.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <vector>

#include "base/check.h"
#include "base/hash.h"
#include "field/jets.h"
#include "field/normals.h"
#include "field/one_ring.h"

namespace fovea {
namespace {

/// Residuals, in edge lengths, up to which positions count as clean, and as slightly noisy. Under the first a jet of
/// degree 4 over 3 rings has the smaller error in C on a torus of 128 x 64 quads.
constexpr double clean = 0.0007, slightly_noisy = 0.004, noisy = 0.02;

struct Choice {
    JetOptions jets;
    std::string reason;
};

Choice choose_jets(const Surface& surface, const Neighbours& neighbours, const Array<vec3>& normals,
                   const FieldOptions& options) {
    Choice choice;
    choice.jets = {.degree = 4, .rings = 3, .hard_angle = options.hard_angle};
    if (options.degree && options.rings) {
        choice.reason = "jets as asked for";
    } else {
        // Coarse meshes of clean surfaces leave residuals, too, but less of them over fewer rings; noise stays.
        JetOptions near = choice.jets;
        near.rings = 2;
        const double noise = std::min(jet_noise(surface, neighbours, normals, choice.jets),
                                      jet_noise(surface, neighbours, normals, near));
        const char* kind = "clean";
        if (noise > clean) {
            choice.jets.even = true;
            choice.jets.degree = 3;
            choice.jets.rings = noise > noisy ? 6 : noise > slightly_noisy ? 4 : 3;
            kind = noise > noisy ? "very noisy" : noise > slightly_noisy ? "noisy" : "slightly noisy";
        }
        char text[120];
        std::snprintf(text, sizeof text, "positions are %s (%.2g %% of an edge off a smooth surface): jets", kind,
                      100.0 * noise);
        choice.reason = text;
    }
    if (options.degree) choice.jets.degree = options.degree;
    if (options.rings) choice.jets.rings = options.rings;
    choice.reason += " of degree " + std::to_string(choice.jets.degree) + " over " + std::to_string(choice.jets.rings) +
                     (choice.jets.rings == 1 ? " ring" : " rings");
    return choice;
}

float feature_size_of(const Surface& surface, const Neighbours& neighbours, const Array<Curvature>& curvature) {
    const Array<float> areas = vertex_areas(surface, neighbours);
    struct Weighted {
        float k, area;
    };
    std::vector<Weighted> pool;
    pool.reserve(2 * curvature.size());
    double total = 0.0;
    for (std::size_t v = 0; v < curvature.size(); ++v) {
        if (!(areas[v] > 0.0f)) continue;
        pool.push_back({std::abs(curvature[v].k1), areas[v]});
        pool.push_back({std::abs(curvature[v].k2), areas[v]});
        total += 2.0 * areas[v];
    }
    if (pool.empty()) return 0.0f;
    // Quickselect by weight: the half that holds the quantile is halved again. Ties in k may stand in any order.
    auto low = pool.begin(), high = pool.end();
    double below = 0.0;
    const double wanted = 0.1 * total;
    const auto less = [](const Weighted& a, const Weighted& b) { return a.k < b.k; };
    while (high - low > 1) {
        const auto middle = low + (high - low) / 2;
        std::nth_element(low, middle, high, less);
        double sum = below;
        for (auto it = low; it != middle; ++it) sum += it->area;
        if (sum > wanted) {
            high = middle;
        } else {
            below = sum;
            low = middle;
        }
    }
    const double cap = 0.05 * surface.radius, k = low->k;
    return static_cast<float>(0.01 < cap * k ? 0.01 / k : cap);
}

Fields make_fields(const Surface& surface, const FieldOptions& options) {
    const auto around = neighbours_of(surface, options.hard_angle);
    const Neighbours& neighbours = *around;
    Fields fields;
    if (options.estimator == Estimator::one_ring) {
        fields.curvature = one_ring_curvature(surface, neighbours);
        fields.reason = "one-rings as asked for";
    } else {
        const Array<vec3> normals = vertex_normals(surface, neighbours);
        const Choice choice = choose_jets(surface, neighbours, normals, options);
        fields.curvature = jet_curvature(surface, neighbours, normals, choice.jets);
        fields.reason = choice.reason;
    }
    fields.feature_size = feature_size_of(surface, neighbours, fields.curvature);
    return fields;
}

}  // namespace

std::shared_ptr<const Fields> fields_of(const Surface& surface, const FieldOptions& options) {
    check(options.degree == 0 || (options.degree >= 2 && options.degree <= 4), "fields: degree must be 0, 2, 3 or 4");
    check(options.rings >= 0 && options.rings <= 32, "fields: rings must be 0 to 32");
    return surface.cache().get<Fields>(key_of(options), [&] { return make_fields(surface, options); });
}

std::uint64_t key_of(const FieldOptions& options) {
    return hash_numbers(static_cast<int>(options.estimator), options.degree, options.rings,
                        std::bit_cast<std::uint64_t>(options.hard_angle));
}

}  // namespace fovea
