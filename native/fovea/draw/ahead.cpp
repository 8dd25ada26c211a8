// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/draw/ahead.h>

#include <algorithm>
#include <exception>

#include <fovea/base/parallel.h>
#include <fovea/base/threads.h>
#include <fovea/draw/along_lines.h>
#include <fovea/field/shape.h>
#include <fovea/line/registry.h>
#include <fovea/scene/tracer.h>

namespace fovea::draw {
namespace {

/// Triangles of a surface that takes some milliseconds, so that little is left to wait for at the end.
constexpr std::size_t most_triangles = 1 << 14;

}  // namespace

Ahead::Ahead(const style::Style& style, std::shared_ptr<const Cancel> cancel) : sets_(line_sets_of(style, {})) {
    ending_.caller = std::move(cancel);
}

void Ahead::add(std::shared_ptr<const Surface> surface) {
    if (base::threads_at_hand() < 2) return;
    if (surface->triangles.size() > most_triangles) return;
    const auto& call = *calls_.emplace_back(std::make_unique<const base::ForkJoin>());
    arena_.enqueue(group_.defer([this, surface = std::move(surface), &call]() FOVEA_TBB_HANDS_OVER {
        const base::ForkJoin::Body here(call);
        const Cancelling scope(&ending_);
        try {
            ending_.poll();
            compute(*surface);
        } catch (const std::exception&) {
            // Whoever needs it computes it again, and tells why it cannot.
        }
    }));
}

void Ahead::compute(const Surface& surface) const {
    if (surface.occluding_triangles > 0) scene::prepare_rays(surface);
    if (std::ranges::any_of(sets_, [](const LineSet& set) { return set.surfaces != Surfaces::all; }))
        field::shape_of(surface);
    for (const LineSet& set : sets_)
        for (const LineKind& kind : set.kinds)
            if (const auto* rule = std::get_if<SceneRule>(&line_definitions()[kind.definition]->rule))
                rule->find_ahead(surface, kind.values, ending_);
}

void Ahead::finish() {
    ending_.requested = true;
    arena_.execute([&] { group_.wait(); });
    calls_.clear();
}

}  // namespace fovea::draw
