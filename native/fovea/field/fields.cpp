// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/field/fields.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <format>
#include <functional>
#include <numeric>
#include <optional>

#include <fovea/base/hash.h>
#include <fovea/base/parallel.h>
#include <fovea/field/exact_curvature.h>
#include <fovea/field/jets.h>
#include <fovea/field/normals.h>
#include <fovea/field/one_ring.h>
#include <fovea/field/smooth.h>

namespace fovea::field {
namespace {

/// RMS residuals of fits, in edge lengths, up to which positions count as clean and as slightly noisy. Up to the first,
/// jets of degree 4 over 3 rings have the smaller error in C on a torus of 128 x 64 quads.
constexpr double clean = 0.0007, slightly_noisy = 0.004;

/// Standard deviation, in edge lengths, that fields of noisy positions are smoothed with; with less, lines on scans are
/// jagged.
constexpr double smoothing_of_noise = 1.2;

constexpr double most_of_radius = 0.05;  // of feature sizes

struct Choice {
    JetOptions jets;
    double smoothing = 0.0;
    std::string reason;
};

double square(double x) { return x * x; }

/// Number of rings for which a cubic has the least error in C. Noise gives the same residuals for any number of rings
/// and averages out over more points; the error of the cubic model, on coarse meshes, increases with the number of
/// rings.
int rings_for(double noise, const std::function<double(int)>& residual) {
    constexpr double share = 0.3;  // share of the model's part of the residuals that reaches C
    int best = 0;
    double least = HUGE_VAL;
    for (const int rings : {2, 3, 4, 6}) {
        const double of_shape = share * std::sqrt(std::max(0.0, square(residual(rings)) - square(noise)));
        const double of_noise = noise / std::sqrt(3.0 * rings * (rings + 1) + 1);
        const double error = std::sqrt(square(of_shape) + square(of_noise)) / (rings * rings * rings);
        if (error >= least) break;
        least = error;
        best = rings;
    }
    return best;
}

Choice choose_jets(const Surface& surface, const Neighbors& neighbors, const FieldOptions& options) {
    Choice choice;
    choice.jets = {.degree = 4, .rings = 3};
    choice.smoothing = options.smoothing;
    if (options.degree && options.rings) {
        choice.reason = "accurate (jets) as asked for";
    } else {
        const auto residual = [&](int degree, int rings) {
            return jet_noise(surface, neighbors, {.degree = degree, .rings = rings, .even = degree == 3});
        };
        // On coarse but clean meshes, too, fits leave residuals, but smaller ones over fewer rings; those of noise do
        // not shrink.
        const double noise = std::min(residual(4, 3), residual(4, 2));
        const char* kind = "clean";
        if (noise > clean) {
            choice.jets.even = true;
            choice.jets.degree = 3;
            choice.jets.rings = rings_for(noise, [&](int rings) { return residual(3, rings); });
            const bool noisy = noise > slightly_noisy;
            if (noisy && options.smoothing == 0.0 && options.estimator == Estimator::automatic)
                choice.smoothing = smoothing_of_noise;
            kind = noisy ? "noisy" : "slightly noisy";
        }
        choice.reason = std::format("positions are {} ({:.2g} % of an edge off a smooth surface): accurate (jets)",
                                    kind, 100.0 * noise);
    }
    if (options.degree) choice.jets.degree = options.degree;
    if (options.rings) choice.jets.rings = options.rings;
    choice.reason += std::format(", degree {}, radius {}", choice.jets.degree, choice.jets.rings);
    return choice;
}

std::shared_ptr<const Choice> choice_of(const Surface& surface, const Neighbors& neighbors,
                                        const FieldOptions& options) {
    return surface.cache().get<Choice>(hash_of(options), [&] { return choose_jets(surface, neighbors, options); });
}

/// The least curvature, without its sign, up to which there is more than `share` of all curvatures, each weighted with
/// the area around its vertex; nothing where there is no area. Found byte by byte: without their sign, the bits of
/// numbers are in the order of the numbers.
std::optional<float> quantile_of(const Array<Curvature>& curvature, const Array<float>& areas, double share) {
    using Sums = std::array<double, 256>;
    std::uint32_t found = 0, known = 0;  // the bytes found so far, and a mask of them
    double below = 0.0, wanted = 0.0;
    for (int shift = 24; shift >= 0; shift -= 8) {
        const auto add_up = [&](Sums& sums, std::size_t begin, std::size_t end) {
            for (std::size_t v = begin; v < end; ++v) {
                if (!(areas[v] > 0.0f)) continue;
                for (const float k : {curvature[v].k1, curvature[v].k2})
                    if (const auto bits = std::bit_cast<std::uint32_t>(std::abs(k)); (bits & known) == found)
                        sums[bits >> shift & 255] += areas[v];
            }
        };
        Sums sums{};
        for (const Sums& part : parallel_parts<Sums>(curvature.size(), 1 << 14, add_up))
            for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += part[i];
        if (known == 0) wanted = share * std::accumulate(sums.begin(), sums.end(), 0.0);
        std::optional<std::uint32_t> byte;
        for (std::uint32_t next = 0; next < sums.size(); ++next) {
            if (!(sums[next] > 0.0)) continue;
            if (byte) below += sums[*byte];
            byte = next;
            if (below + sums[next] > wanted) break;
        }
        if (!byte) return {};
        found |= *byte << shift;
        known |= 255u << shift;
    }
    return std::bit_cast<float>(found);
}

float feature_size_of(const Surface& surface, const Neighbors& neighbors, const Array<Curvature>& curvature) {
    const auto found = quantile_of(curvature, vertex_areas(surface, neighbors), 0.1);
    if (!found) return 0.0f;
    const double cap = most_of_radius * surface.radius, k = *found;
    return static_cast<float>(0.01 < cap * k ? 0.01 / k : cap);
}

/// Fields of a stretched surface.
Fields map_fields(const Surface& surface, const Fields& source, const FieldOptions& options) {
    const dmat3 inverse = glm::inverse(surface.stretch());
    const auto of_vertex = [&](std::size_t v) { return rounded(mapped(source.curvature[v], inverse)); };
    auto curvature = parallel_map<Curvature>(source.curvature.size(), of_vertex);
    const auto neighbors = neighbors_of(*surface.source(), options.hard_angle);
    const float feature_size = feature_size_of(surface, *neighbors, curvature);
    return {std::move(curvature), feature_size, source.reason};
}

Fields make_fields(const Surface& surface, const FieldOptions& options) {
    const auto around = neighbors_of(surface, options.hard_angle);
    const Neighbors& neighbors = *around;
    Fields fields;
    double smoothing = options.smoothing;
    if (options.estimator == Estimator::automatic && !surface.jets.empty()) {
        fields.curvature = curvature_of(surface.jets);
        fields.reason = "exact: derivatives of the subdivision's limit surface";
    } else if (options.estimator == Estimator::one_ring) {
        fields.curvature = one_ring_curvature(surface, neighbors);
        fields.reason = "fast (one-rings) as asked for";
    } else {
        const auto choice = choice_of(surface, neighbors, options);
        fields.curvature = jet_curvature(surface, neighbors, choice->jets);
        fields.reason = choice->reason;
        smoothing = choice->smoothing;
    }
    if (smoothing > 0.0) {
        fields.curvature = smooth(surface, neighbors, fields.curvature, smoothing);
        fields.reason += std::format(", smoothed over {:.3g} edges", smoothing);
    }
    fields.feature_size = feature_size_of(surface, neighbors, fields.curvature);
    return fields;
}

}  // namespace

std::uint64_t hash_of(const FieldOptions& options) {
    const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
    return hash_numbers(static_cast<int>(options.estimator), options.degree, options.rings, bits(options.smoothing),
                        bits(options.hard_angle));
}

std::shared_ptr<const Fields> fields_of(const Surface& surface) { return fields_of(surface, surface.field_options()); }

std::shared_ptr<const Fields> fields_of(const Surface& surface, const FieldOptions& options) {
    check_options(options, surface.name());
    return surface.cache().get<Fields>(hash_of(options), [&] {
        return surface.source() ? map_fields(surface, *fields_of(*surface.source(), options), options)
                                : make_fields(surface, options);
    });
}

float greatest_feature_size(const Surface& surface) { return static_cast<float>(most_of_radius * surface.radius); }

Array<vec3> fitted_normals(const Surface& surface, In<Index> vertices) {
    const FieldOptions options = surface.field_options();
    check_options(options, surface.name());
    if (!surface.source() && options.estimator != Estimator::one_ring && surface.jets.empty()) {
        const auto neighbors = neighbors_of(surface, options.hard_angle);
        const auto choice = choice_of(surface, *neighbors, options);
        const auto fitted = jet_curvature(surface, *neighbors, choice->jets, vertices);
        return parallel_map<vec3>(vertices.size(), [&](std::size_t i) { return vec3(fitted[i].normal); });
    }
    const auto fields = fields_of(surface);
    return parallel_map<vec3>(vertices.size(),
                              [&](std::size_t i) { return vec3(fields->curvature[vertices[i]].normal); });
}

std::string fields_reason(const Surface& surface) {
    const auto kept = surface.cache().find<Fields>(hash_of(surface.field_options()));
    return kept ? kept->reason : "";
}

}  // namespace fovea::field
