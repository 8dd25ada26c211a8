# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs inside Blender for the pictures of command/pages.py: each line definition over a faint drawing of its example
model, the demo scene at each stage of the method and with several focus models, pens that change along strokes and
by what is painted, scenes of what artists meet, sections, plots of transfer functions."""

import argparse
import subprocess
import sys
import tempfile
from functools import reduce
from pathlib import Path

import bpy
import numpy as np
from bl_ext.user_default.fovea import catalogue, comparison_report, gaze, learned_lines, native, style
from bl_ext.user_default.fovea.render import gaze_check, local_properties, vectors
from bl_ext.user_default.fovea.style import style_data

sys.path.insert(0, str(Path(__file__).parent))

import draw
import drawing_settings
import ending
import over
import picture
import scene_source
import sheet
import study
from bench import coherence
from bench.coherence import drawers, motions, pictures
from command import draw_options, pages, quantities
from command.target import SHARED
from gauges import formulas
from scenes import lessons

FAINT = {"pen.width": 2.8, "pen.color": (0.4, 0.4, 0.4), "pen.taper": 0.0}
CLEAR = {"pen.width": 4.0, "pen.taper": 0.0}
BOLD = {"pen.width": 7.5, "pen.color": (0.0, 0.0, 0.0), "pen.taper": 0.0, "pen.strength_width": 0.5}
GREYS, FEW_GREYS = 16, 6  # gray levels: fewer give smaller files, and the pages are part of the extension
EYE = np.array((0.13, -0.3, 0.09))  # of the monkey, in its widths
WEIGHTS = 64  # steps of a painted vertex group
GAUGE_COLOR = 0.0, 0.6, 0.0


def main(words):
    parser = argparse.ArgumentParser()
    parser.add_argument("folder", type=Path)
    parser.add_argument("names", nargs="+")
    options = parser.parse_args(words)
    with tempfile.TemporaryDirectory() as folder:
        for name in options.names:
            group, _, shown = name.partition("/")
            made = DRAWN_BY[group](shown, Path(folder) / "part.png")
            made = in_grays(made) if made.ndim == 2 else made
            sheet.save(made, options.folder / pages.file_of(name), pages.JPEG_QUALITY)


def in_grays(picture, count=GREYS):
    """The picture in so many grays."""
    return np.round(picture * (count - 1)) / (count - 1)


def line(name, path):
    """(H, W) picture of one line definition."""
    shown = pages.LINES[name]
    given = by_model(name, learned_from(shown.learned, path)[0], path) if shown.learned else {}
    open_model(shown.model)
    faint = draw_lines(shown, shown.beneath, shown.beneath_params, FAINT, path)
    return np.minimum(faint, draw_lines(shown, (name,), shown.params, BOLD | given, path))


def stage(name, path):
    """(H, W, 3) picture of the demo scene at one stage or with one focus, supersampled by 2."""
    return scene_in_colors("demo", (pages.WAY | pages.FOCUS)[name], pages.STAGE_SIZE, path, pages.STAGE_VIEW)


def situation(name, path):
    """(H, W, 3) picture of a scene that shows what artists meet, supersampled by 2."""
    return scene_in_colors(name, pages.SITUATIONS[name], pages.SITUATIONS_SIZE, path)


def over_render(name, path):
    """(H, W, 3) picture of the demo scene by another engine, with lines over it, supersampled by 2."""
    return scene_in_colors("demo", pages.OVER[name], pages.OVER_SIZE, path)


def pencil(name, path):
    """(H, W, 3) picture of the runner: as Fovea draws it, or as Workbench does under the strokes that were baked."""
    change = under_baked_strokes if name == "baked" else None
    return scene_in_colors("runner", pages.GREASE_PENCIL[name], pages.SITUATIONS_SIZE, path, pages.PENCIL_VIEW, change)


def under_baked_strokes(scene):
    """Bakes the strokes of a scene to Grease Pencil, which Workbench then draws over its shaded surfaces."""
    scene.render.engine = "BLENDER_WORKBENCH"
    bpy.ops.fovea.bake_strokes(kind="GREASE_PENCIL")
    scene.render.film_transparent = False
    scene.world = bpy.data.worlds.new("Paper")
    scene.world.color = (1, 1, 1)
    shading = scene.display.shading
    shading.light, shading.color_type, shading.single_color = "STUDIO", "SINGLE", (0.9, 0.85, 0.75)


def scene_in_colors(name, shown, size, path, crop=None, change=None):
    """(H, W, 3) picture of a scene or model, supersampled by 2. `shown`: a pages.Stage; `crop`: arguments of `magnify`;
    `change`: called with the scene before it is rendered."""
    open_model(name)
    scene = set_up(shown, size, path)
    if crop:
        magnify(scene, *crop)
    if change:
        change(scene)
    return in_colors(scene, path)


def set_up(shown, size, path):
    """The scene that is open, to be drawn as a pages.Stage at twice the size."""
    scene = bpy.context.scene
    width, height = quantities.frame_size(size)
    words = [*shown.words, "--size", f"{2 * width}x{2 * height}", "-o", str(path)]
    options = draw_options.parse(words)
    set_drawing(scene, options, shown.settings)
    if options.over:
        over.set_up(scene, options)
    return scene


def in_colors(scene, path):
    """(H, W, 3) render of half the scene's size."""
    picture.render(scene, path)
    return halved(picture.pixels(path)[..., :3])


def halved(pixels):
    """(H, W, ...) means of the four pixels of each of (2 H, 2 W, ...)."""
    height, width = np.array(pixels.shape[:2]) // 2
    whole = pixels[: 2 * height, : 2 * width]
    return whole.reshape(height, 2, width, 2, *pixels.shape[2:]).mean(axis=(1, 3))


def of_file(name, path):
    return titled(name, path) if name in pages.TITLED else page(name, path)


def titled(name, path):
    """(H, W) sheet of paper with a title block, as librsvg draws it, supersampled by 2."""
    scene_name, words = pages.TITLED[name]
    open_model(scene_name)
    svg, scene = path.with_suffix(".svg"), bpy.context.scene
    options = draw_options.parse([scene_name, *words, "-o", str(svg)])
    set_drawing(scene, options, {})
    asked = vectors.options_of(scene, draw_options.titles(options, ""), **draw_options.vector_options(options))
    vectors.write(vectors.drawing(bpy.context, "svg", asked), svg)
    subprocess.run(["rsvg-convert", "-w", str(2 * pages.TITLED_WIDTH), svg, "-o", path], check=True)
    return in_grays(halved(sheet.gray(path)), FEW_GREYS)


def page(name, path):
    """(H, W) part of a page in black and white of the demo scene, at half of its resolution."""
    open_model("demo")
    options = draw_options.parse([*pages.VECTORS[name].words, "-o", str(path)])
    set_drawing(bpy.context.scene, options, pages.VECTORS[name].settings)
    asked = vectors.screen(**draw_options.screen_options(options))
    vectors.write(vectors.drawing(bpy.context, "png", asked), path)
    gray, (width, height) = sheet.gray(path), quantities.frame_size(pages.PAGE_SIZE)
    top, left = (
        int(share * (whole - 2 * part)) for share, whole, part in zip(pages.PAGE_PLACE, gray.shape, (height, width))
    )
    return halved(gray[top : top + 2 * height, left : left + 2 * width])


def frames(name, path):
    """(H, W, 3) frames of a walk beside each other."""
    motions.build("walk", pages.FRAMES[-1], SHARED)
    scene, shown = set_up(pages.FARM[name], pages.FRAME_SIZE, path), []
    for number in pages.FRAMES:
        scene.frame_set(number)
        shown.append(in_colors(scene, path))
    return np.hstack(shown)


def section(name, path):
    """(H, W, 3) picture of a scene or model that a plane cuts open, supersampled by 2."""
    model, shown = pages.SECTIONS[name]
    return scene_in_colors(model, shown, pages.SECTIONS_SIZE, path)


def stroke(name, path):
    """(H, W) picture of a monkey by a pen that changes along its strokes, supersampled by 2."""
    open_model(pages.MONKEY[0])
    return monkey(pages.STROKES_PEN | pages.STROKES[name], path)


def following(name, path):
    """(H, W) drawings of a monkey that follow each other in an animation, side by side, supersampled by 2."""
    open_model(pages.MONKEY[0])
    shown = []
    for frame, settings in enumerate(pages.FOLLOWING[name], start=1):
        bpy.context.scene.frame_set(frame)
        shown.append(monkey(pages.FOLLOWING_PEN | settings, path))
    return in_grays(np.hstack(shown), FEW_GREYS)


def monkey(settings, path):
    """(H, W) picture of the monkey that is open, with properties of its style, supersampled by 2."""
    width, height = quantities.frame_size(pages.STROKES_SIZE)
    words = [*pages.STROKES_WORDS, "--size", f"{2 * width}x{2 * height}", "-o", str(path)]
    set_drawing(bpy.context.scene, draw_options.parse(words), settings)
    picture.render(bpy.context.scene, path)
    return halved(sheet.gray(path))


def painted(name, path):
    """(H, W, 3) picture by a pen that takes something from surfaces, supersampled by 2."""
    model, shown = pages.PAINTED[name]
    change = paint_around_an_eye if name == "group" else None
    return scene_in_colors(model, shown, pages.PAINTED_SIZE, path, change=change)


def lit(name, path):
    """(H, W) drawings of a scene in a large sun's light, one over the other, supersampled by 2."""
    model, *stages = pages.LIGHT[name]
    return in_grays(reduce(np.minimum, (in_sun(model, shown, path) for shown in stages)))


def in_sun(model, shown, path):
    """(H, W) picture of a scene as a pages.Stage."""
    open_model(model)
    for light in bpy.data.lights:
        light.angle = 0.12
    picture.render(set_up(shown, pages.LIGHT_SIZE, path), path)
    return halved(sheet.gray(path))


def paint_around_an_eye(scene):
    """A vertex group on the monkey, heavy near its left eye."""
    obj = next(obj for obj in scene.objects if obj.type == "MESH")
    places = np.empty((len(obj.data.vertices), 3), np.float32)
    obj.data.vertices.foreach_get("co", places.ravel())
    size = np.ptp(places[:, 0])
    away = np.linalg.norm(places - EYE * size, axis=1) / size
    levels = np.round(WEIGHTS * np.clip(1.15 - 1.6 * away, 0.08, 1.0)).astype(int)
    group = obj.vertex_groups.new(name="Paint")
    for level in np.unique(levels):
        group.add(np.flatnonzero(levels == level).tolist(), level / WEIGHTS, "REPLACE")


def overlay(name, path):
    """(H, W, 3) overlay of two drawings of a model."""
    shown = pages.COMPARE[name]
    open_model(shown.model)
    pictures = [draw_lines(shown, kinds, (), FAINT, path) for kinds in shown.drawn]
    a, b = (native.load().GrayImage(np.round(255 * gray)).lines() for gray in pictures)
    return comparison_report.overlay(a, b, a.usual_tolerance) / 255


def learned(name, path):
    """(H, W) drawing of a model, how likely its lines are by what is learned from it, and another model as it is drawn
    by that, supersampled by 2."""
    model, gray, likely = learned_from(name, path)
    _, other = pages.LEARN[name]
    open_model(other.model)
    drawn = draw_lines(other, other.drawn[0], (), CLEAR | by_model(*other.drawn[0], model, path), path)
    return in_grays(halved(np.hstack([gray, 1.0 - likely, drawn])))


def learned_from(name, path):
    """(model of lines, (H, W) drawing that it has learned from, (H, W) how likely it finds lines there)."""
    shown, _ = pages.LEARN[name]
    open_model(shown.model)
    gray = draw_lines(shown, shown.drawn[0], (), CLEAR, path)
    judge = native.load().GrayImage(np.round(255 * gray)).lines()
    properties = local_properties.of_render(bpy.context, gray.shape[::-1])
    model = learned_lines.learn(properties, [judge], "forest").model
    return model, gray, learned_lines.drawn(model, properties)[0]


def by_model(definition, model, path):
    """Settings of a style that give a model of lines to a definition. `path`: of a file beside which that of the model
    is written."""
    file = path.with_suffix(".json")
    file.write_text(model.json(), encoding="utf-8")
    return {f"set.kinds.{definition}_{catalogue.by_name()[definition]['file']['name']}": str(file)}


def heat(name, path):
    """(H, W, 3) heat map of where the eye goes in a drawing of the office, at twice the size."""
    open_model("office")
    set_up(pages.GAZE[name], pages.GAZE_SIZE, path)
    return gaze.heat(gaze_check.check(bpy.context).gaze) / 255


def gauged(name, path):
    """(H, W, 3) drawing of a model with gauges that lie on its surface, supersampled by 2."""
    model, shown = pages.GAUGE[name]
    open_model(model)
    scene = set_up(shown, pages.GAUGE_SIZE, path)
    found = study.gauges(scene, pages.GAUGES, 0)["gauges"]
    picture.render(scene, path)
    drawn = picture.pixels(path)[..., :3].copy()
    height, width = drawn.shape[:2]
    lines = []
    for gauge in found:
        disc, pin = formulas.lines(np.array(gauge["n"]), formulas.RADIUS * height)
        lines += [(gauge["x"], height - gauge["y"]) + line for line in (disc, pin)]
    offsets = np.cumsum([0, *map(len, lines)])
    gauges = native.load().Bitmap.of_lines(np.concatenate(lines).astype(np.float32), offsets, width, height)
    drawn[gauges.distances() <= 1.5] = GAUGE_COLOR
    return halved(drawn)


def plot(name, path):
    """(N, N) plot of a transfer function over focus: grid lines at quarters in gray, the curve in black."""
    transfer = style.Transfer(**pages.TRANSFERS[name])
    size, margin, fine = pages.PLOT, 0.06, 8
    place = np.arange(size * fine) / (size * fine - 1) * (1 + 2 * margin) - margin  # 0 and 1: the frame
    answer = native.load().Transfer(transfer.start, transfer.end, transfer.strength, list(transfer.curve))
    value = answer(place.clip(0, 1).astype(np.float32))
    steep = np.abs(np.gradient(value, place))
    off = np.abs(place[:, None] - value[None, :]) / np.sqrt(1 + steep**2)  # rows: upwards; columns: focus
    curve = (off < 0.011) & (place >= 0) & (place <= 1)
    lines = np.abs(place[:, None] - np.linspace(0, 1, 5)).min(axis=1) < 0.003
    inside = (place >= -0.003) & (place <= 1.003)
    grid = (lines[:, None] | lines[None, :]) & inside[:, None] & inside[None, :]
    gray = np.where(curve, 0.0, np.where(grid, 0.75, 1.0))
    return gray.reshape(size, fine, size, fine).mean(axis=(1, 3))


def moving(name, path):
    """(H, W) strips of a scene in motion, of dashes fixed to the screen and below of dashes fixed to their paths; and
    beside each other a row of pixels over time of each."""
    strips, rows, place = [], [], None
    for anchor in coherence.ANCHORS:
        motions.build(name, pages.ANIMATION_FRAMES, SHARED)
        scene = bpy.context.scene
        scene.render.resolution_x, scene.render.resolution_y = pages.ANIMATION_SIZE
        marks = pages.MARKS_FRAMES.get(name, 0) if anchor == "path" else 0
        drawer, frames = drawers.Fovea(scene, anchor, marks=marks), []
        drawer.lines(coherence.LINES[pages.ANIMATION[name]])
        for k in range(scene.frame_start, scene.frame_end + 1):
            scene.frame_set(k)
            drawer.frame()
            frames.append(drawer.image[..., :3].mean(axis=2) ** (1 / 2.2))
        place = place or (pictures.pane(frames), pictures.darkest_row(frames))
        strips.append(pictures.strip(frames, place[0]))
        rows.append(pictures.over_time(frames, place[1]))
    between = np.full((len(rows[0]), strips[0].shape[1] - 2 * rows[0].shape[1]), 0.5)
    bands = [*strips, np.hstack([rows[0], between, rows[1]])]
    made = np.vstack([np.pad(band, ((4, 4), (0, 0)), constant_values=1.0) for band in bands[::-1]])
    return in_grays(made, FEW_GREYS)


def compared(name, path):
    """(H, W) frames of a scene in motion, in a row for each of several settings, supersampled by 2."""
    width, height = pages.ANIMATION_SIZE
    in_motion, lines, each_row = pages.COMPARED[name]
    words = ["--style", "plain", "--lines", lines, "--size", f"{2 * width}x{2 * height}", "-o", str(path)]
    rows = []
    for settings in each_row:
        motions.build(in_motion, pages.ANIMATION_FRAMES, SHARED)
        scene, shown = bpy.context.scene, []
        scene.render.use_motion_blur = True
        set_drawing(scene, draw_options.parse(words), pages.COMPARED_PEN | settings)
        for k in range(pictures.FRAMES):
            scene.frame_set(pages.ANIMATION_FRAMES // 2 - 1 + k)
            picture.render(scene, path)
            shown.append(halved(sheet.gray(path)))
        everything = slice(None), slice(width // 5, width - width // 5)
        rows.append(pictures.strip(shown, everything))
    made = np.vstack([np.pad(row, ((4, 4), (0, 0)), constant_values=1.0) for row in rows[::-1]])
    return in_grays(made)


def animation(name, path):
    drawn_by = {**dict.fromkeys(pages.FOLLOWING, following), **dict.fromkeys(pages.COMPARED, compared)}
    return drawn_by.get(name, moving)(name, path)


DRAWN_BY = {
    "lines": line, "sections": section, "way": stage, "focus": stage, "strokes": stroke, "painted": painted,
    "light": lit, "situations": situation, "over": over_render, "transfers": plot, "grease_pencil": pencil,
    "animation": animation, "compare": overlay, "learn": learned, "gaze": heat, "gauge": gauged, "vectors": of_file,
    "farm": frames,
}  # fmt: skip


def magnify(scene, u, v, times):
    """Zooms the camera by a factor `times` to the point (u, v) of its frame, 0 to 1 from the left and the top."""
    camera, render = scene.camera.data, scene.render
    camera.lens *= times
    camera.shift_x = (camera.shift_x + u - 0.5) * times
    camera.shift_y = (camera.shift_y + (0.5 - v) * render.resolution_y / render.resolution_x) * times


def open_model(model):
    if model.startswith(pages.LESSON):
        bpy.ops.wm.read_homefile(use_empty=True)
        lessons.build(model.removeprefix(pages.LESSON))
    else:
        scene_source.open_scene(str(SHARED / "models" / model) if model.endswith(".obj") else model)


def draw_lines(shown, lines, params, pen, path):
    """(H, W) picture of some line definitions on the model, drawn with one pen."""
    scene = bpy.context.scene
    chosen = ["--size", pages.SIZE, "--style", "plain", "--lines", ",".join(lines), *params, "-o", str(path)]
    set_drawing(scene, draw_options.parse([*shown.camera, *chosen]), pen)
    picture.render(scene, path)
    return sheet.gray(path)


def set_drawing(scene, options, settings):
    """Applies all settings of `fovea draw`, then properties of the style, named as in pages.Stage.settings. Where every
    edge shall be a crease, faces are flat and surfaces hard: others have only folds."""
    if ("crease.angle", 0.0) in options.param:
        for obj in scene.objects:
            obj.fovea.shape = "HARD"
            if obj.type == "MESH":
                obj.data.shade_flat()
    draw.set_size(scene, options)
    draw.set_camera(scene, options)
    drawing_settings.set_drawing(scene, options)
    draw.set_output(scene, options)
    held = style_data.own(scene)
    for words, value in settings.items():
        part, *within, name = words.split(".")
        for owner in parts(held, part):
            owner = reduce(getattr, within, owner)
            if name not in owner.bl_rna.properties:
                raise ValueError(f"a style has no {words}")
            setattr(owner, name, value)


def parts(held, part):
    """The property groups of a style that the first part of a setting's name refers to."""
    if part == "pen":
        return [line_set.pen for line_set in held.line_sets]
    if part == "set":
        return held.line_sets
    if part == "hidden":
        return [hidden.pen for line_set in held.line_sets for hidden in line_set.hidden]
    return [getattr(held, part)]


if __name__ == "__main__":
    ending.run(main)
