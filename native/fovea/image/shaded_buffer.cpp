// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/image/shaded_buffer.h>

#include <cmath>
#include <limits>

#include <fovea/base/elementary.h>
#include <fovea/field/corner_normals.h>

namespace fovea::image {
namespace {

constexpr float nowhere = std::numeric_limits<float>::infinity();
/// Difference in tone between neighbors above which a node is resampled.
constexpr float fine_tone = 1.0f / 32.0f;
constexpr int ray_bits = 5, fine_rays = 1 << ray_bits;

/// Result of one ray.
struct Sample {
    float tone = 0.0f, distance = nowhere;
    Index placement = none;
};

class Shader {
   public:
    Shader(const Tracer& tracer, const Lamp& lamp)
        : tracer_(tracer), clip_to_view_(glm::inverse(tracer.view().view_to_clip)) {
        const double right = glm::radians(lamp.right), up = glm::radians(lamp.up);
        const dmat3 raise(dvec3(1, 0, 0), dvec3(0, cosine(up), -sine(up)), dvec3(0, sine(up), cosine(up)));
        const dmat3 turn(dvec3(cosine(right), 0, -sine(right)), dvec3(0, 1, 0), dvec3(sine(right), 0, cosine(right)));
        to_lamp_ = glm::mat3(turn * raise);
        const auto& placements = tracer.scene().placements;
        placed_.resize(placements.size());
        parallel_for(placed_.size(), 1, [&](std::size_t i) {
            const Placement& placement = placements[i];
            if (!(placement.usage & usage_draw) || !in_frame(placement, tracer.view(), lattice_margin)) return;
            placed_[i].normals = corner_normals(*placement.surface);
            const dmat3 to_view(tracer.view().world_to_view * placement.object_to_world);
            placed_[i].normal_to_view = glm::mat3(glm::transpose(glm::inverse(to_view)));
        });
    }

    bool drawn(Index placement) const { return placement != none && placed_[placement].normals != nullptr; }

    Sample at(const dvec2& px) const {
        const auto hit = tracer_.seen(px);
        if (!hit) return {};
        Sample sample{0.0f, static_cast<float>(hit->t), hit->placement};
        if (drawn(hit->placement)) sample.tone = tone(*hit, px);
        return sample;
    }

   private:
    struct Placed {
        std::shared_ptr<const CornerNormals> normals;
        glm::mat3 normal_to_view;
    };

    float tone(const Hit& hit, const dvec2& px) const {
        const View& view = tracer_.view();
        const Surface& surface = *tracer_.scene().placements[hit.placement].surface;
        const Placed& placed = placed_[hit.placement];
        const Triangle& triangle = surface.triangles[hit.triangle];
        const auto normal_at = [&](int k) { return placed.normals->at(triangle, hit.triangle, k); };
        const vec3 mixed = (1.0f - hit.u - hit.v) * normal_at(0) + hit.u * normal_at(1) + hit.v * normal_at(2);
        const vec3 normal = placed.normal_to_view * mixed;
        const vec3 facet = placed.normal_to_view * vec3(surface.facet_plane[surface.triangle_facet[hit.triangle]]);
        const vec3 to_eye =
            view.orthographic ? vec3(0, 0, 1) : vec3(glm::normalize(-from_pixels(view, clip_to_view_, px, 1.0)));
        const float side = glm::dot(facet, to_eye) < 0.0f ? -1.0f : 1.0f;
        const float value = side * glm::dot(normal, to_lamp_ * to_eye) / glm::length(normal);
        return value > 0.0f ? std::min(value, 1.0f) : 0.0f;  // NaN gives 0
    }

    const Tracer& tracer_;
    dmat4 clip_to_view_;
    glm::mat3 to_lamp_;
    std::vector<Placed> placed_;
};

/// Calls body(node, x, y) for all nodes.
template <typename Body>
void each_node(const Lattice& lattice, const Cancel& cancel, const Body& body) {
    parallel_blocks(lattice.height, 1, [&](std::size_t y, std::size_t, std::size_t) {
        cancel.poll();
        for (int x = 0; x < lattice.width; ++x) body(lattice.at(x, int(y)), x, int(y));
    });
}

bool differ(const Sample& a, const Sample& b) {
    return a.placement != b.placement || std::abs(a.tone - b.tone) > fine_tone;
}

/// Resamples a node's square with `fine_rays` rays.
void sample_finely(const Shader& shader, std::size_t node, int x, int y, ShadedBuffer& buffer) {
    float tone = 0.0f, nearest = nowhere;
    int covered = 0;
    for (int i = 0; i < fine_rays; ++i) {
        const Sample sample = shader.at(buffer.lattice.px(dvec2(x, y) + place_in_square(i, ray_bits)));
        const bool drawn = shader.drawn(sample.placement);
        tone += sample.tone;
        covered += drawn;
        if (sample.distance >= nearest) continue;
        nearest = sample.distance;
        buffer.drawn[node] = drawn;
    }
    buffer.tone[node] = tone / float(fine_rays);
    buffer.coverage[node] = float(covered) / float(fine_rays);
    buffer.distance[node] = nearest;
}

}  // namespace

ShadedBuffer shade(const Tracer& tracer, const Lattice& lattice, const Lamp& lamp, const Cancel& cancel) {
    const Shader shader(tracer, lamp);
    Array<Sample> samples(lattice.size());
    each_node(lattice, cancel,
              [&](std::size_t node, int x, int y) { samples[node] = shader.at(lattice.px(dvec2(x, y))); });
    ShadedBuffer buffer{lattice, Buffer(lattice.size()), Buffer(lattice.size()), Buffer(lattice.size()),
                        Array<std::uint8_t>(lattice.size())};
    each_node(lattice, cancel, [&](std::size_t node, int x, int y) {
        const Sample& here = samples[node];
        buffer.tone[node] = here.tone;
        buffer.drawn[node] = shader.drawn(here.placement);
        buffer.coverage[node] = buffer.drawn[node];
        buffer.distance[node] = here.distance;
        if ((x > 0 && differ(here, samples[node - 1])) || (x + 1 < lattice.width && differ(here, samples[node + 1])) ||
            (y > 0 && differ(here, samples[node - lattice.width])) ||
            (y + 1 < lattice.height && differ(here, samples[node + lattice.width])))
            sample_finely(shader, node, x, y, buffer);
    });
    return buffer;
}

}  // namespace fovea::image
