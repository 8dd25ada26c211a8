# SPDX-License-Identifier: GPL-3.0-or-later
"""A scene to render, and access to the picture files that renders of it write."""

import resource
import signal
import subprocess
import sys
from pathlib import Path

import bpy
import the_addon
from the_addon import add_camera, box_mesh, empty_scene, fovea, lines_of, new_object, use_style

sys.path.insert(0, str(Path(__file__).parents[2] / "blender_scripts"))

from picture import pixels as pixels_of

SIZE = (160, 90)
session = the_addon.part("render.session")


def box_scene():
    """A box before a camera, drawn with a plain pen."""
    scene = empty_scene()
    new_object(box_mesh(), "Box")
    add_camera()
    render = scene.render
    render.engine, render.resolution_x, render.resolution_y = "FOVEA", *SIZE
    render.dither_intensity = 0.0
    scene.view_settings.view_transform = "Standard"
    style = use_style(scene, "technical")
    scene.fovea.backend, lines_of(scene).pen.width, style.elision.enabled = "CPU", 30.0, False
    return scene


def box_scene_of_one_set():
    """The same with one line set."""
    scene = box_scene()
    style = use_style(scene, "plain")
    style.line_sets[-1].pen.width, style.elision.enabled = 30.0, False
    return scene


def drawn(scene, path):
    """(H, W, 4) of a PNG still, top row last."""
    scene.render.image_settings.file_format = "PNG"
    scene.render.image_settings.color_mode = "RGBA"
    scene.render.filepath = str(path)
    bpy.ops.render.render(write_still=True)
    return pixels_of(path)


def exact_stills(scene, width, height):
    """Has Fovea render PNG files of so many pixels whose values are the picture's, to 16 bits."""
    render = scene.render
    render.engine, render.resolution_x, render.resolution_y, render.dither_intensity = "FOVEA", width, height, 0.0
    render.image_settings.file_format, render.image_settings.color_depth = "PNG", "16"
    scene.view_settings.view_transform = "Standard"


def frames_looked_at(monkeypatch):
    """List to which each frame is appended whose lines a final render finds for those near it."""
    frames, look = [], session._look

    def looking(engine, depsgraph, *arguments):
        frames.append(depsgraph.scene.frame_current)
        return look(engine, depsgraph, *arguments)

    monkeypatch.setattr(session, "_look", looking)
    return frames


def drawn_at(scene, frame, folder):
    """(H, W, 4) of a PNG still of a frame."""
    scene.frame_set(frame)
    return drawn(scene, folder / f"{frame}.png")


def drawn_at_once(scene, frames, folder):
    """{frame: (H, W, 4)} of the frames of the scene's range, by one call of Blender."""
    scene.render.filepath = str(folder / "run_####.png")
    bpy.ops.render.render(animation=True)
    return {frame: pixels_of(folder / f"run_{frame:04}.png") for frame in frames}


def ink(picture):
    """(H, W) how dark each pixel is."""
    return 1 - picture[..., :3].mean(axis=2)


def layered(scene, path):
    """Renders a multilayer EXR; {channel: (H, W)}, top row last."""
    settings = scene.render.image_settings
    if hasattr(settings, "media_type"):
        settings.media_type = "MULTI_LAYER_IMAGE"
    settings.file_format, settings.color_depth = "OPEN_EXR_MULTILAYER", "32"
    scene.render.filepath = str(path)
    bpy.ops.render.render(write_still=True)
    # Blender 5 writes each pass as a part of its own.
    info = subprocess.run(["oiiotool", "--info", "-v", "-a", str(path)], capture_output=True, text=True, check=True)
    lists = [line.split(":", 1)[1] for line in info.stdout.splitlines() if "channel list:" in line]
    names = [(i, name.split("(")[0].strip()) for i, names in enumerate(lists) for name in names.split(",")]
    # One process for all channels, as it takes most of a second to start.
    files = {name: path.with_name(f"channel-{n}.exr") for n, (_, name) in enumerate(names)}
    command = ["oiiotool"]
    for part, name in names:
        command += [str(path), "--subimage", str(part), "--ch", name, "--chnames", "R", "-o", str(files[name])]
    subprocess.run(command, check=True)
    return {name: pixels_of(file)[..., 0] for name, file in files.items()}


def in_blender_without_room(words):
    """Another Blender with the add-on, where no file can have more than 2 kB, as on a full disk; words go to it."""
    command = [bpy.app.binary_path, "-b", "--factory-startup", "--addons", fovea.__name__, "--python-exit-code", "1"]
    streams = {"capture_output": True, "text": True, "errors": "replace"}
    return subprocess.run([*command, *words], **streams, preexec_fn=_take_room, restore_signals=False)


def _take_room():
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (2048, 2048))


def scene_from_above(size, pixels):
    """An empty scene that is drawn from above by rays on the CPU, at a size in pixels with so many to a unit."""
    made = empty_scene()
    made.render.engine, made.render.resolution_x, made.render.resolution_y = "FOVEA", *size
    made.render.dither_intensity = 0.0
    made.view_settings.view_transform = "Standard"
    camera = add_camera((0, 0, 10), (0, 0, 0))
    camera.rotation_euler = (0, 0, 0)
    camera.data.type, camera.data.ortho_scale = "ORTHO", size[0] / pixels
    made.fovea.backend, made.fovea.visibility = "CPU", "EXACT"
    return made
