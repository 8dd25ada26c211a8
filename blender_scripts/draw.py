"""Runs inside Blender for `fovea draw`: opens or builds the scene, frames it, and renders it with Fovea."""

import sys
from functools import partial
from pathlib import Path

import bpy
from bl_ext.user_default.fovea import catalogue, focus, style, style_values
from bl_ext.user_default.fovea.blender import focus_settings, properties
from mathutils import Vector

sys.path.insert(0, str(Path(__file__).parent))

import framing
import scenes
import sheet
from command import draw_options
from command.target import SHARED


def main(words):
    options = draw_options.parse(words)
    open_scene(options.scene)
    scene = bpy.context.scene
    set_size(scene, options)
    set_camera(scene, options)
    set_drawing(scene, options)
    set_output(scene, options)
    if options.sheet:
        sheet.render(scene, catalogue.definitions(), options.output, partial(still, scene))
    else:
        render(scene, options)


def open_scene(spec):
    """A .blend as it is; a model or a scene's name in an empty file. The add-on stays enabled all the while."""
    if spec.endswith(".blend"):
        bpy.ops.wm.open_mainfile(filepath=str(Path(spec).absolute()), load_ui=False)
        return
    bpy.ops.wm.read_homefile(use_empty=True)
    if spec.endswith(".obj"):
        bpy.ops.wm.obj_import(filepath=str(Path(spec).absolute()))
    else:
        scenes.build(spec, SHARED if SHARED.is_dir() else None)


def set_size(scene, options):
    render = scene.render
    if options.size or not keeps_own(options):
        render.resolution_x, render.resolution_y = options.size or (1920, 1080)
        render.resolution_percentage = 100


def set_camera(scene, options):
    """A scene keeps its own camera unless another direction is asked for; a model never has one."""
    turned = options.azimuth is not None or options.elevation is not None
    if scene.camera and not turned:
        if options.lens:
            scene.camera.data.lens = options.lens
        return
    framing.frame(
        scene,
        framing.AZIMUTH if options.azimuth is None else options.azimuth,
        framing.ELEVATION if options.elevation is None else options.elevation,
        options.lens or framing.LENS,
        options.margin / 100,
    )


def keeps_own(options):
    return not options.scene.endswith(draw_options.MODELS)


def set_drawing(scene, options):
    scene.render.engine = "FOVEA"
    fovea = scene.fovea
    if options.backend:
        fovea.backend = options.backend.upper()
    if options.visibility:
        fovea.visibility = options.visibility.upper().replace("-", "_")
    for name in ("probes", "depth_scale", "layers"):
        if getattr(options, name):
            setattr(fovea, name, getattr(options, name))
    if options.style:
        choose_style(fovea, options.style)
    if options.lines:
        choose_lines(fovea, catalogue.named(options.lines))
    set_parameters(fovea, options.param)
    set_hidden(fovea, options)
    set_focus(scene, options)
    if options.elision is not None:
        fovea.elision = options.elision


def choose_style(fovea, name):
    if name not in style.names():
        raise ValueError(f"there is no style '{name}'; there are: {', '.join(style.names())}")
    fovea.style = name


def choose_lines(fovea, names):
    for definition in catalogue.definitions():
        setattr(fovea, definition["name"], definition["name"] in names)


def set_parameters(fovea, given):
    """What `--param DEFINITION.NAME=VALUE` says."""
    for words, value in given:
        name, dot, parameter = words.partition(".")
        if not dot:
            raise ValueError(f"--param {words}: a parameter is named DEFINITION.NAME")
        checked = style.parameters(name, {parameter: value}, "definition", catalogue.definitions())
        if not getattr(fovea, name):
            raise ValueError(f"--param {words}: {name} is not drawn; name it in --lines")
        properties.set_parameters(fovea, name, checked)


def set_hidden(fovea, options):
    fovea.hidden = fovea.hidden or options.hidden or options.hidden_by is not None
    if options.hidden_by:
        fovea.hidden_from, fovea.hidden_to = options.hidden_by[0], options.hidden_by[1] or 0
    for name in ("halo", "overshoot"):
        given = getattr(options, name)
        if given is not None:
            setattr(fovea, name, style_values.check_range(given, style_values.RANGES[name], f"--{name}"))


def set_focus(scene, options):
    fovea = scene.fovea
    if options.focus:
        focus_settings.set_focus(fovea, focus_of(scene, options.focus, options.focus_radii))
    if options.focus_painted:
        focus_settings.set_focus(fovea, focus.Focus("painted", attribute=options.focus_painted))
    if options.effects:
        focus_settings.keep_effects(fovea, options.effects)
    for what in ("lines", "colors"):
        if options.uniform in (what, "both"):
            setattr(fovea, f"effect_{what}", "UNIFORM")
        if options.without == what:
            setattr(fovea, f"effect_{what}", "NONE")


def focus_of(scene, where, radii):
    """The Focus that `--focus` means: a place in the image or in space, or an object's surface."""
    if isinstance(where, str):
        if where not in scene.objects:
            raise ValueError(f"--focus {where}: there is no such object in the scene")
        at = tuple(scene.objects[where].matrix_world.translation)
        return focus.Focus("object", (focus.Point(at, *(radii or focus_radii(scene, at)), where),))
    if len(where) == 2:
        return focus.Focus("image", (focus.Point((*where, 0.0), *(radii or (0.1, 0.6))),))
    return focus.Focus("scene", (focus.Point(where, *(radii or focus_radii(scene, where))),))


def focus_radii(scene, place):
    """Radii around a place in space that look alike from wherever the camera is."""
    distance = (scene.camera.matrix_world.translation - Vector(place)).length
    return 0.1 * distance, 0.6 * distance


def set_output(scene, options):
    """Paper stays white and ink as it was mixed: neither a film look nor dither."""
    scene.view_settings.view_transform = "Standard"
    scene.view_settings.look = "None"
    scene.render.dither_intensity = 0
    scene.render.film_transparent = options.transparent or scene.render.film_transparent
    image = scene.render.image_settings
    image.file_format = "PNG" if options.output.suffix == ".png" else "OPEN_EXR"
    image.color_mode = "RGBA" if scene.render.film_transparent else "RGB"
    scene.render.use_file_extension = False


def render(scene, options):
    frames = options.frames or (scene.frame_current, scene.frame_current)
    for frame, picture in zip(range(frames[0], frames[1] + 1), draw_options.pictures(options), strict=True):
        scene.frame_set(frame)
        still(scene, picture)


def still(scene, picture):
    scene.render.filepath = str(picture)
    bpy.ops.render.render(write_still=True)


if __name__ == "__main__":
    try:
        main(sys.argv[sys.argv.index("--") + 1 :])
    except (ValueError, RuntimeError) as error:  # what the user can mend; anything else keeps its traceback
        sys.exit(f"Error: {str(error).removeprefix('Error: ').strip()}")
