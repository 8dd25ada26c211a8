# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs inside Blender for `fovea draw`: opens or builds the scene, frames it, and renders it with Fovea."""

import sys
from pathlib import Path

import bpy
from bl_ext.user_default.fovea import catalogue
from bl_ext.user_default.fovea.render import cameras, vectors
from bl_ext.user_default.fovea.style import freestyle

sys.path.insert(0, str(Path(__file__).parent))

import drawing_settings
import ending
import frame_dump
import framing
import over
import picture
import scene_source
import sheet
from command import draw_options, model_files


def main(words):
    options = draw_options.parse(words)
    scene = opened(options)
    drawing_settings.set_drawing(scene, options)
    set_output(scene, options)
    if options.over:
        over.set_up(scene, options)
    if freestyle.is_on(scene):
        ending.note(freestyle.OVER)
    if remark := vectors.remark(vectors.options(**draw_options.vector_options(options))):
        ending.note(remark)
    if options.sheet:
        sheet.render(scene, catalogue.definitions(), options.output)
    else:
        render(scene, options)


def opened(options):
    """The scene of draw's options, opened, with the size and the camera that they ask for."""
    scene_source.open_scene(options.scene)
    scene = bpy.context.scene
    set_size(scene, options)
    set_camera(scene, options)
    return scene


def set_size(scene, options):
    render = scene.render
    if options.size or not keeps_own(options):
        render.resolution_x, render.resolution_y = options.size or (1920, 1080)
        render.resolution_percentage = 100


def set_camera(scene, options):
    """Keeps the scene's camera unless --azimuth or --elevation is given; without one, as for models, adds a camera,
    but none with --cameras."""
    if options.cameras:
        if not (known := cameras.of(scene)):
            raise ValueError("--cameras: the scene has no camera; leave it out, and the scene is framed")
        scene.camera = scene.camera or known[0]
        return
    turned = options.azimuth is not None or options.elevation is not None
    if scene.camera and not turned:
        if options.lens:
            set_lens(scene.camera, options.lens)
        return
    framing.frame(
        scene,
        framing.AZIMUTH if options.azimuth is None else options.azimuth,
        framing.ELEVATION if options.elevation is None else options.elevation,
        options.lens or framing.LENS,
        options.margin / 100,
        orthographic=bool(options.scale),
    )


def set_lens(camera, lens):
    if camera.type != "CAMERA":
        raise ValueError(f"--lens: '{camera.name}', which the scene is seen from, is no camera and has no lens")
    camera.data.lens = lens


def keeps_own(options):
    return not model_files.is_model(options.scene)


def set_output(scene, options):
    """Sets one picture per frame as the output, overriding the file's. Standard view transform without look or dither,
    so that colors are displayed unchanged."""
    scene.render.use_multiview = False
    scene.view_settings.view_transform = "Standard"
    scene.view_settings.look = "None"
    scene.render.dither_intensity = 0
    scene.render.film_transparent = options.transparent or scene.render.film_transparent
    image = scene.render.image_settings
    if "media_type" in image.bl_rna.properties:  # from Blender 5.0 on; it limits the formats that can be set
        image.media_type = "IMAGE"
    image.file_format = "PNG" if options.output.suffix == ".png" else "OPEN_EXR"
    image.color_mode = "RGBA" if scene.render.film_transparent else "RGB"
    scene.render.use_file_extension = False
    scene.fovea.vectors.kind = "NONE"


def render(scene, options):
    """Renders every frame from the scene's camera, or from those of --cameras."""
    if not options.cameras:
        render_frames(scene, options)
        return
    known = cameras.of(scene)
    there = [camera.name for camera in known]
    wanted = there if options.cameras == "all" else options.cameras.split(",")
    if missing := [name for name in wanted if name not in there]:
        known_as = ", ".join(there)
        raise ValueError(f"--cameras {options.cameras}: the scene has no camera '{missing[0]}'; there are: {known_as}")
    named = zip(known, cameras.file_names(known), strict=True)
    chosen = [(camera, name) for camera, name in named if camera.name in wanted]
    with cameras.unbound(scene):
        for number, (camera, name) in enumerate(chosen):
            scene.camera = camera
            if options.lens:
                set_lens(camera, options.lens)
            if options.scale:
                drawing_settings.set_scale(scene, options.scale)
            render_frames(scene, options, name, (number, len(chosen)))


def render_frames(scene, options, camera=None, among=(0, 1)):
    """Renders every frame. `camera`: what the names of the files have of it; `among`: which of how many it is."""
    frames = options.frames or (scene.frame_current, scene.frame_current)
    dumps = draw_options.dumps(options, camera) or [None] * (frames[1] + 1 - frames[0])
    pictures = draw_options.pictures(options, camera)
    numbered, total = zip(range(frames[0], frames[1] + 1), pictures, dumps, strict=True), among[1] * len(pictures)
    for number, (frame, path, dump) in enumerate(numbered, start=among[0] * len(pictures) + 1):
        scene.frame_set(frame)
        if dump:  # first, because rendering may fail
            frame_dump.write(bpy.context, dump)
            ending.announce(dump)
        if kind := draw_options.kind(options, path):
            write_drawing(scene, options, path, kind, f"{number}/{total}" if total > 1 else "")
        else:
            picture.render(scene, path)
            ending.announce(path)


def write_drawing(scene, options, path, kind, sheet):
    if kind == "png":
        asked = vectors.screen(**draw_options.screen_options(options))
    else:
        asked = vectors.options_of(scene, draw_options.titles(options, sheet), **draw_options.vector_options(options))
    drawn = vectors.drawing(bpy.context, kind, asked)
    if drawn is None:
        raise RuntimeError(f"{path}: stopped before the lines were drawn")
    vectors.write(drawn, path)
    if options.json:
        ending.tell({"file": str(path), **drawn.figures})
    else:
        ending.announce(path)


if __name__ == "__main__":
    ending.run(main)
