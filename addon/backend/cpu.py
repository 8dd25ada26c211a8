# SPDX-License-Identifier: GPL-3.0-or-later
"""The native stages, and the reference backend made of them. Each function is one call."""

import math

import numpy as np

from .. import native
from ..stages import Emphasis, LineFilters

_HANDS_OVER = 12.0  # reference pixels before its end that a line begins to hand over to one that goes on


def trace(scene, view):
    """Rays through a native Scene as a native View sees it."""
    return native.load().Tracer(scene, view)


def extract(tracer, style, cancel, filters=LineFilters()):
    """Paths of everything the style's line sets find, if LineFilters let it through; none where it draws no lines."""
    drawn, all_of_them = style.effects.lines != "none", (None,) * len(style.line_sets)
    of_sets = zip(style.line_sets, filters.placements or all_of_them, filters.materials or all_of_them, strict=True)
    sets = [(s.kinds if drawn else {}, s.corner_angle, placements, materials) for s, placements, materials in of_sets]
    own = {"shown": filters.shown, "parameters": filters.parameters, "materials": filters.lined}
    return native.load().extract_paths(tracer, sets, cancel, **own)


def project(paths, tracer, style, sample_step_px, scale, cancel):
    """ClippedPaths, with samples every so many pixels; `scale` pixels are a reference pixel."""
    least = [line_set.least_length * scale for line_set in style.line_sets]
    return native.load().project(paths, tracer, sample_step_px, least, cancel)


def exact(frame, cancel):
    """Visible Runs of a Frame by rays: the canonical answer, on every machine the same."""
    return native.load().exact_visibility(frame.clipped, frame.paths, frame.tracer, cancel)


def runs(clipped, visibility):
    """Visible Runs of atlas samples."""
    return native.load().runs_from_samples(clipped, visibility)


def whole(clipped):
    """Runs over the whole of every piece."""
    return native.load().whole_runs(clipped)


def tidy(frame, visible, gap_px, spur_px, contour_spur_px, fold_px):
    """Runs joined over small gaps, without small spurs; contours also without the folds they end in."""
    core = native.load()
    spur_of_path = np.where(frame.paths.of_view, np.float32(contour_spur_px), np.float32(spur_px))
    joined = core.close_gaps(frame.clipped, visible, gap_px, spur_of_path, spur_px)
    return core.trim_folds(frame.clipped, joined, frame.paths, fold_px)


def parts(frame, visible, levels, beside_px, least_px, fold_px, cancel):
    """Visible Runs and, unless `levels` is 0, the hidden ones between them, told apart by the surfaces that hide them,
    up to so many. Left out are those that go along visible ones nearer than beside_px, then stretches shorter than
    least_px, or fold_px for contours."""
    core, clipped, paths = native.load(), frame.clipped, frame.paths
    if levels == 0:
        return visible
    apart = core.without_beside_visible(clipped, core.with_hidden(clipped, visible, paths), beside_px)
    least = np.where(paths.of_view, np.float32(fold_px), np.float32(least_px))
    both = core.without_short_hidden(clipped, apart, least)
    return both if levels == 1 else core.count_invisibility(clipped, paths, frame.tracer, both, levels, cancel)


def at_ends(frame, runs, style, scale, meet_px, mix=0.0):
    """Runs cut back where they pass behind others, contours drawn on by at most meet_px to where other lines go on, and
    all beyond their ends: the style's haloes and overshoot.
    Short lines overshoot by at most a quarter of their length, as a hand would. `mix` (samples,): how far overshoot is
    on the way to that out of focus; or 0."""
    core, clipped = native.load(), frame.clipped
    shorter = core.halo(clipped, runs, frame.paths, _by_path(frame, [s.halo for s in style.line_sets], scale))
    joined = core.meet_ends(clipped, shorter, frame.paths, meet_px)
    sets, most = style.line_sets, _lengths(frame) / 4
    away = [s.overshoot if s.overshoot_away is None else s.overshoot_away for s in sets]
    reach, other = (
        np.minimum(_by_path(frame, amounts, scale), most).astype(np.float32)
        for amounts in ([s.overshoot for s in sets], away)
    )
    return core.overshoot(clipped, joined, reach, *((other, mix) if np.ndim(mix) else ()))


def _lengths(frame):
    """(P,) pixels of each path inside the frame."""
    clipped = frame.clipped
    first, last = clipped.offsets[:-1], clipped.offsets[1:] - 1
    return np.bincount(clipped.path, clipped.arc_px[last] - clipped.arc_px[first], len(frame.paths))


def _by_path(frame, by_set, scale):
    """(P,) float32 pixels of each path from reference pixels of its line set."""
    return np.array([pixels * scale for pixels in by_set], np.float32)[frame.paths.line_set]


def path_of_samples(clipped):
    """(samples,) path of Paths that each atlas sample lies on."""
    return np.repeat(np.repeat(clipped.path, np.diff(clipped.offsets)), clipped.sample_count)


def samples_with_runs(clipped, runs):
    """(n,) atlas samples of the pieces that Runs lie on, ascending, and (n,) the path of Paths that each lies on."""
    pieces = np.unique(runs.piece)
    first = clipped.sample_start[clipped.offsets[:-1]].astype(np.intp)
    count = np.diff(first, append=clipped.samples)[pieces]
    start = first[pieces] - (np.cumsum(count) - count)
    return np.arange(count.sum()) + np.repeat(start, count), np.repeat(clipped.path[pieces], count)


def transfer(data):
    """The native Transfer of a style's."""
    return native.load().Transfer(data.start, data.end, data.strength, list(data.curve))


def priorities(frame, weights=None, object=None, painted=None):
    """(P,) float32 in [0, 1]: how important each path is. `weights`: numbers by the name of the term, as in the native
    PriorityWeights; `object`: per placement; `painted`: per point of Paths or per path."""
    core = native.load()
    weights = core.PriorityWeights(**(weights or {}))
    return core.path_priorities(frame.paths, frame.scene, frame.view, weights, object, painted)


def ranks(frame, runs, priority):
    """(R,) uint32: the order in which Runs go before each other, given the priority of each path."""
    return native.load().rank_runs(frame.clipped, runs, priority, frame.paths.ids)


def shown_lines(frame, runs, shown):
    """The native ShownLines of a Frame: `shown` (samples,), what elision leaves of Runs."""
    view = frame.view
    return native.load().ShownLines(frame.clipped, frame.paths, frame.scene, runs, shown, view.width, view.height)


def smoothed_in_time(shown, now, near, frames):
    """(samples,) what elision leaves, smoothed over so many frames to each side; `now`: the frame's ShownLines, `near`:
    pairs of how many frames later another is and its ShownLines."""
    return native.load().smoothed_in_time(shown, now, list(near), frames)


def bands(frame, runs, ranks, half_width_px):
    """The native Elision of Runs: what they want for themselves; see `elide` of the backends."""
    return native.load().Elision(frame.clipped, runs, ranks, half_width_px, _HANDS_OVER * frame.view.reference_scale)


def shape(frame, runs, style, pens, samples=None, emphasis=Emphasis(), pen_of_run=None):
    """Strokes of Runs; pens as of `pens_of`. Partly visible atlas samples, if given, fade one pen into the other;
    Emphasis leads to the pens out of focus. `pen_of_run` (R,): other pens than the style's line sets say."""
    core, paths, effects = native.load(), frame.paths, style.effects
    if pen_of_run is None:
        pen_of_run = core.pens_of_runs(frame.clipped, runs, paths.line_set, np.array(style.pen_ranges(), np.uint32))
    transfers = {name: transfer(getattr(effects, name)) for name in ("color", "texture", "width", "opacity")}
    transfers |= {f"distance_{name}": transfer(getattr(style.distance, name)) for name in ("width", "opacity")}
    felt = emphasis.focus, emphasis.distance, emphasis.shown
    return core.tessellate(frame.clipped, runs, pen_of_run, paths.strength, pens, samples, *felt, transfers, paths.ids)


def pens_of(style, textures, scale):
    """The native pens of a style, in its order, in pixels of the image (`scale` of them are a reference pixel)."""
    core, away, pens = native.load(), style.away(), style.pens()
    widths = [style.width_px(pen, scale) for pen in pens]
    return [
        core.Pen(
            color=pen.color,
            opacity=pen.opacity,
            width_px=width,
            texture_length_px=textures.length(pen) * width,
            texture_anchor=pen.texture_anchor,
            cap=pen.cap,
            taper_px=pen.taper * scale,
            texture=textures.index(pen),
            strength_width=pen.strength_width,
            away=away.get(i),
            wobble_px=pen.wobble * scale,
            wobble_length_px=pen.wobble_length * scale,
            seed=int(pen.seed),
            pressure=pen.pressure,
        )
        for i, (pen, width) in enumerate(zip(pens, widths))
    ]


def read_texture(path):
    """A pen texture from a PNG file."""
    return native.load().read_texture(str(path))


def depth_image(tracer, cancel):
    """(H, W) distance along the view of what each pixel sees."""
    return native.load().depth_image(tracer, cancel)


def color_layer(tracer, sources, chosen, cancel):
    """(H, W, 4) premultiplied: the surfaces that each pixel sees, in the colours of a color.Sources, as a color.Color
    wants them."""
    layer = native.load().color_layer(
        tracer, sources.surfaces, sources.lights, sources.world, chosen.shading, chosen.bands, cancel
    )
    return color_effects(layer, desaturate=chosen.desaturation) if chosen.desaturation else layer


def color_effects(layer, desaturate=None, fade=None, blur_px=None, background=None):
    """The colour layer desaturated, then faded towards a background (None: until the paper shows), then blurred.
    Amounts are numbers or (H, W) float32: of the first two in [0, 1], of the last the radius in pixels of the image."""

    def everywhere(amount):
        return None if amount is None else np.broadcast_to(np.asarray(amount, np.float32), layer.shape[:2])

    return native.load().color_effects(layer, everywhere(desaturate), everywhere(fade), background, everywhere(blur_px))


def read_paper(path):
    """A paper's native heights from a PNG file."""
    return native.load().read_paper(str(path))


def on_paper(lines, layer, style, texture, tracer, cancel):
    """Strokes over the colour layer (None: there is none) over the paper, holdouts cut out: (H, W, 4), premultiplied.
    `texture`: the paper's heights; None: it is smooth."""
    core, paper = native.load(), style.paper
    holdout = core.holdout_image(tracer, cancel)
    holdout = holdout if holdout.size else None
    if layer is None and texture is None:
        return core.compose(lines, paper.color, paper.transparent, holdout)
    return core.on_paper(
        lines,
        layer,
        holdout,
        tracer.view,
        texture,
        color=paper.color,
        transparent=paper.transparent,
        background=style.color.background if layer is not None else None,
        layer_opacity=style.color.opacity,
        texel_px=paper.scale * tracer.view.reference_scale,
        tooth=paper.tooth,
        granulation=paper.granulation,
        tint=paper.tint,
    )


class Backend:
    """The reference: depth buffer and strokes drawn natively, the same picture on every machine."""

    name = "cpu"
    most_side = 6144  # texels of a tile of the depth buffer: 0.9 GB

    def visibility(self, frame):
        look = native.load().sampled_visibility
        return self._over_tiles(frame, lambda depth: look(frame.clipped, depth, frame.probes))

    def item_visibility(self, frame):
        look = native.load().item_visibility
        return self._over_tiles(frame, lambda depth: look(frame.clipped, depth, frame.layers))

    def layouts(self, frame, overlap_px=0):
        """DepthLayouts of a Frame: one, or tiles where it is too large. Cores are looked out of by so many pixels."""
        return depth_layouts(frame, self.most_side, overlap_px)

    def _over_tiles(self, frame, look, overlap_px=0):
        """Sum of what `look` tells of each tile's depth buffer; no two of them are there at once."""
        core = native.load()
        layouts = self.layouts(frame, overlap_px)
        return sum(look(core.draw_depth(frame.scene, frame.view, layout)) for layout in layouts)

    def elide(self, frame, runs, ranks, half_width_px, cancel=None, **options):
        """(samples,) float32 in [0, 1]: what elision leaves of the opacity of Runs, given their `ranks` and half the
        distance in pixels that they want to keep from others at each sample; options of native Elision.opacities."""
        elision = bands(frame, runs, ranks, half_width_px)
        crowding = elision.crowding(frame.view.width, frame.view.height, cancel)
        return elision.opacities(frame.clipped, crowding, **options)

    def draw(self, strokes, pens, textures, view):
        return native.load().raster(strokes, pens, textures.native, view.width, view.height)

    def draw_seen(self, frame, strokes, pens, textures):
        look = native.load().raster_seen
        return self._over_tiles(
            frame,
            lambda depth: look(strokes, pens, textures.native, frame.clipped, depth, frame.probes),
            strokes_reach(strokes),
        )


def depth_layouts(frame, side, overlap_px):
    """DepthLayouts of a Frame in at most `side` texels along each axis: one, or tiles. Cores are looked out of by so
    many pixels, besides what a sample's own probes are apart."""
    probes_px = math.ceil(8 * max(1.0, frame.view.reference_scale))
    return native.load().depth_tiles(frame.view, frame.depth_scale, side, probes_px + overlap_px)


def strokes_reach(strokes):
    """Pixels between a stroke's spine and its farthest fragment, and no less."""
    return math.ceil(2 * strokes.half_width.max()) if len(strokes.half_width) else 0
