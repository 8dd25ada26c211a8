# SPDX-License-Identifier: GPL-3.0-or-later
"""Applies the options of `fovea draw` that say what is drawn, and how, to a scene. Runs inside Blender."""

import bpy
from bl_ext.user_default.fovea import catalogue, style
from bl_ext.user_default.fovea.focus import focus_settings
from bl_ext.user_default.fovea.render import drawing_scale
from bl_ext.user_default.fovea.scene import line_kinds
from bl_ext.user_default.fovea.style import style_data, style_groups, style_read, style_write
from mathutils import Vector


def set_drawing(scene, options):
    """Applies all of them. Raises ValueError, which names the option, where one does not fit the scene."""
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


def set_scale(scene, scale):
    """Applies --scale for the scene's camera."""
    try:
        drawing_scale.fit_page(scene, scale)
    except ValueError as error:
        raise ValueError(f"--scale: {error}") from error
