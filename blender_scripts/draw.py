# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs inside Blender for `fovea draw`: opens or builds the scene, frames it, and renders it with Fovea."""

import sys
from pathlib import Path

import bpy
from bl_ext.user_default.fovea import catalogue, style
from bl_ext.user_default.fovea.focus import focus_settings
from bl_ext.user_default.fovea.render import cameras, drawing_scale, vectors
from bl_ext.user_default.fovea.scene import line_kinds
from bl_ext.user_default.fovea.style import freestyle, style_data, style_groups, style_read, style_write
from mathutils import Vector

sys.path.insert(0, str(Path(__file__).parent))

import blend_file
import ending
import frame_dump
import framing
import over
import picture
import scenes
import sheet
from command import draw_options, model_files
from command.target import SHARED


def main(words):
    options = draw_options.parse(words)
    open_scene(options.scene)
    scene = bpy.context.scene
    set_size(scene, options)
    set_camera(scene, options)
    set_drawing(scene, options)
    set_output(scene, options)
    if options.over:
        over.set_up(scene, options)
    if freestyle.is_on(scene):
        ending.note(freestyle.OVER)
    if options.sheet:
        sheet.render(scene, catalogue.definitions(), options.output)
    else:
        render(scene, options)


def open_scene(spec):
    """Opens a .blend, or imports a model or builds a named scene in an empty file. The add-on stays enabled."""
    if model_files.is_blend(spec):
        blend_file.open_file(Path(spec).absolute())
        return
    bpy.ops.wm.read_homefile(use_empty=True)
    if model_files.is_model(spec):
        import_model(Path(spec).absolute())
    else:
        scenes.build(spec, SHARED if SHARED.is_dir() else None)


def import_model(path):
    """Imports a model with Blender's own importer, up axis and scale as it sets them. ValueError if this Blender has
    none for such files, or it imports nothing."""
    suffix = model_files.suffix(path)
    importers = filter(None, map(operator, model_files.IMPORTERS[suffix]))
    importer = next(importers, None)
    if not importer:
        raise ValueError(f"{path.name}: this Blender imports no {suffix} files")
    refused = f"{path.name}: Blender cannot import this file"
    try:
        done = importer(filepath=str(path)) == {"FINISHED"}
    except RuntimeError as error:  # with a traceback where the importer is written in Python
        raise ValueError(f"{refused}: {ending.sentence(str(error)).rpartition('; ')[2]}") from error
    if not done:
        raise ValueError(refused)
    if not len(framing.visible_points(bpy.context.evaluated_depsgraph_get())):
        raise ValueError(f"{path.name}: there is nothing in this file to draw")


def operator(name):
    """The operator "module.name"; None if this Blender has none of the name."""
    module, _, function = name.partition(".")
    found = getattr(getattr(bpy.ops, module), function)
    try:
        found.get_rna_type()
    except KeyError:
        return None
    return found


def set_size(scene, options):
    render = scene.render
    if options.size or not keeps_own(options):
        render.resolution_x, render.resolution_y = options.size or (1920, 1080)
        render.resolution_percentage = 100


def set_camera(scene, options):
    """Keeps the scene's camera unless --azimuth or --elevation is given; without one, as for models, adds a camera,
    but none with --cameras."""
    if options.cameras:
        scene.camera = scene.camera or next(iter(cameras.of(scene)), None)
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
    held = style_data.use(scene, options.style) if options.style else style_data.own(scene)
    if options.lines:
        style_data.choose_lines(held, catalogue.named(options.lines))
    set_parameters(held, options.param)
    set_hidden(held, options)
    set_section(scene, options.section)
    if options.scale and not options.cameras:
        set_scale(scene, options.scale)
    set_focus(scene, options)
    set_effects(held.effects, options)
    if options.elision is not None:
        held.elision.enabled = options.elision


def set_parameters(held, given):
    """Applies `--param DEFINITION.NAME=VALUE`."""
    for words, value in given:
        name, dot, parameter = words.partition(".")
        if not dot:
            raise ValueError(f"--param {words}: a parameter is named DEFINITION.NAME")
        checked = style.parameters(name, {parameter: value}, "definition")
        if name not in style_data.drawn_kinds(held):
            raise ValueError(f"--param {words}: {name} is not drawn; name it in --lines")
        for line_set in held.line_sets:
            line_kinds.set_parameters(line_set.kinds, name, checked)


def set_hidden(held, options):
    """Applies --hidden, --hidden-by, --halo and --overshoot. Styles with hidden pens keep them; others get dashes."""
    dashes = style.dashed(style_read.pen(held.line_sets[-1].pen))
    if (options.hidden or options.hidden_by) and not any(line_set.hidden for line_set in held.line_sets):
        for line_set in held.line_sets:
            style_write.write_hidden(line_set.hidden.add(), style.Hidden(pen=dashes))
    for line_set in held.line_sets:
        if options.hidden_by and line_set.hidden:
            for number in options.hidden_by:
                style.check(style.Hidden, "first", number or 1, "--hidden-by")
            line_set.hidden[0].first, line_set.hidden[0].last = options.hidden_by[0], options.hidden_by[1] or 0
        for name in ("halo", "overshoot"):
            given = getattr(options, name)
            if given is not None:
                style.check(style.LineSet, name, given, f"--{name}")
                setattr(line_set, name, given)


def set_section(scene, plane):
    """Applies --section: the name of an object, or a point and a normal, for which an Empty is added."""
    if isinstance(plane, str):
        if plane not in scene.objects:
            raise ValueError(f"--section {plane}: there is no such object in the scene")
        scene.fovea.section = scene.objects[plane]
    elif plane:
        empty = bpy.data.objects.new("Section Plane", None)
        empty.location = plane[:3]
        empty.rotation_euler = Vector(plane[3:]).to_track_quat("Z", "Y").to_euler()
        scene.collection.objects.link(empty)
        scene.fovea.section = empty


def set_focus(scene, options):
    fovea = scene.fovea
    if options.focus:
        focus_settings.set_focus(fovea, focus_of(scene, options.focus, options.focus_radii))
    if options.focus_painted:
        focus_settings.set_focus(fovea, style.Focus(model="painted", attribute=options.focus_painted))


def set_effects(effects, options):
    """Applies --effects, --uniform and --without; effects not named in --effects get strength 0."""
    known = style_groups.transfers(style.Effects)
    unknown = sorted(set(options.effects or ()) - set(known))
    if unknown:
        raise ValueError(f"there is no effect '{unknown[0]}'; there are: {', '.join(known)}")
    for name in set(known) - set(options.effects or known):
        getattr(effects, name).strength = 0.0
    for what in ("lines", "colors"):
        if options.uniform in (what, "both"):
            setattr(effects, what, "UNIFORM")
        if options.without == what:
            setattr(effects, what, "NONE")


def focus_of(scene, where, radii):
    """The Focus for `--focus`: (u, v) in the image, (x, y, z) in world space, or the name of an object for its
    surface."""
    if isinstance(where, str):
        if where not in scene.objects:
            raise ValueError(f"--focus {where}: there is no such object in the scene")
        at = tuple(scene.objects[where].matrix_world.translation)
        return place("object", at, radii or focus_radii(scene, at), where)
    if len(where) == 2:
        return place("image", (*where, 0.0), radii or (0.1, 0.6))
    return place("scene", where, radii or focus_radii(scene, where))


def place(model, at, radii, name=""):
    """A Focus with one point."""
    near, far = radii
    return style.Focus(model=model, points=(style.FocusPlace(at=at, near=near, far=far, object=name),))


def focus_radii(scene, place):
    """(near, far) around a point in space, proportional to its distance from the camera."""
    distance = (scene.camera.matrix_world.translation - Vector(place)).length
    return 0.1 * distance, 0.6 * distance


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
    wanted = [camera.name for camera in known] if options.cameras == "all" else options.cameras.split(",")
    names = {camera.name: name for camera, name in zip(known, cameras.file_names(known))}
    if missing := [name for name in wanted if name not in names]:
        there = f"there are: {', '.join(names)}" if names else "there are none"
        raise ValueError(f"--cameras {options.cameras}: the scene has no camera '{missing[0]}'; {there}")
    with cameras.unbound(scene):
        for camera in (camera for camera in known if camera.name in wanted):
            scene.camera = camera
            if options.lens:
                set_lens(camera, options.lens)
            if options.scale:
                set_scale(scene, options.scale)
            render_frames(scene, options, names[camera.name])


def render_frames(scene, options, camera=None):
    """Renders every frame. `camera`: what the names of the files have of it."""
    frames = options.frames or (scene.frame_current, scene.frame_current)
    dumps = draw_options.dumps(options, camera) or [None] * (frames[1] + 1 - frames[0])
    pictures = draw_options.pictures(options, camera)
    for frame, path, dump in zip(range(frames[0], frames[1] + 1), pictures, dumps, strict=True):
        scene.frame_set(frame)
        if dump:  # first, because rendering may fail
            frame_dump.write(bpy.context, dump)
            ending.announce(dump)
        if kind := draw_options.kind(options, path):
            write_drawing(options, path, kind)
        else:
            picture.render(scene, path)
            ending.announce(path)


def set_scale(scene, scale):
    """Applies --scale for the scene's camera."""
    try:
        drawing_scale.fit_page(scene, scale)
    except ValueError as error:
        raise ValueError(f"--scale: {error}") from error


def write_drawing(options, path, kind):
    if kind == "png":
        asked = vectors.screen(**draw_options.screen_options(options))
    else:
        asked = vectors.options(**draw_options.vector_options(options))
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
