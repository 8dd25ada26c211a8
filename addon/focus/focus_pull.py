# SPDX-License-Identifier: GPL-3.0-or-later
"""Focus Pull: keyframes that move the focus from one place to another."""

import bpy
from mathutils import Vector

from ..scene import animation, camera
from ..scene.operator import Operator
from ..scene.problem import CannotDraw
from . import focus_kinds, focus_places

SECONDS = 2  # default duration of a pull if the scene has a single frame
EASINGS = [  # interpolation of the keyframes
    ("LINEAR", "Linear", "At one speed"),
    ("SINE", "Gentle", "Slowly off and slowly there"),
    ("CUBIC", "Strong", "More slowly off and there, faster between"),
    ("EXPO", "Sudden", "Still for long, then fast"),
]
TARGETS = [
    ("OBJECT", "Object", "To an object's origin"),
    ("CURSOR", "3D Cursor", "To the 3D cursor"),
    ("LOCATION", "Location", "To world coordinates"),
]


RADIUS = {"default": -1.0, "soft_min": 0.0}
IN_SCENE = {"description": "Radius in the end; less than 0: as it is", "subtype": "DISTANCE", **RADIUS}
IN_FRAME = {"description": "Radius in the end, in heights of the frame", "options": {"SKIP_SAVE"}, **RADIUS}


def same_in_frame(name):
    """The keywords of a property that shows the number of another one without its unit."""
    return {"get": lambda self: getattr(self, name), "set": lambda self, radius: setattr(self, name, radius)}


class Track:
    """A property that a pull animates, from its current value to `end`. `owner`: the ID or group that has it."""

    def __init__(self, owner, name, end):
        self.owner, self.name, self.end = owner, name, end

    def key(self, first, last, easing):
        self.owner.keyframe_insert(self.name, frame=first)
        setattr(self.owner, self.name, self.end)
        self.owner.keyframe_insert(self.name, frame=last)
        for curve in animation.channels(self.owner, self.name):
            self._ease(curve, first, last, easing)

    def _ease(self, curve, first, last, easing):
        for point in curve.keyframe_points:
            if first <= point.co.x < last:
                point.interpolation = easing
                point.easing = "EASE_IN_OUT"
        curve.update()


def pull(scene, at, near, far, first, last, easing):
    """Keyframes the first focus point: its current state at frame `first`, location `at` and radii `near` and `far` at
    frame `last`; then evaluates the current frame again. `at`: world coordinates or, for points in the camera's frame,
    (x, y) from its left and top."""
    settings, kind = scene.fovea, focus_kinds.of(scene.fovea)
    tracks = [Track(settings, name, radius) for name, radius in zip(kind.radii, (near, far))]
    if kind.in_frame:
        tracks.append(Track(settings, "focus_place", at))
    elif settings.focus_object:
        tracks.append(_track_of(scene, at))
    else:
        tracks.append(Track(settings, "focus_location", at))
    for track in tracks:
        track.key(first, last, easing)
    scene.frame_set(scene.frame_current)


def _track_of(scene, at):
    """The Track for the location of the Empty that marks the first focus point. A marker of another type is not
    animated: a new Empty at its location replaces it."""
    mark = scene.fovea.focus_object
    if mark.type != "EMPTY":
        scene.fovea.focus_object = None
        mark = focus_places.put(scene, mark.matrix_world.translation).focus_object
    end = Vector(at)
    if mark.parent:
        end = (mark.parent.matrix_world @ mark.matrix_parent_inverse).inverted() @ end
    return Track(mark, "location", end)


def frames_of(scene):
    """(first, last) frame proposed for a pull."""
    first, last = scene.frame_start, scene.frame_end
    return first, last if last > first else first + SECONDS * scene.render.fps


def hold(scene, first, last):
    """Extends the scene's frame range to contain a pull; returns whether it changed."""
    before = scene.frame_start, scene.frame_end
    scene.frame_start, scene.frame_end = min(scene.frame_start, first), max(scene.frame_end, last)
    return (scene.frame_start, scene.frame_end) != before


class FOVEA_OT_focus_pull(Operator, bpy.types.Operator):
    """Lead the focus from where it is to another place, over some frames: keys the place and its two radii"""

    bl_idname = "fovea.focus_pull"
    bl_label = "Focus Pull"

    target: bpy.props.EnumProperty(name="To", description="Where the focus is led", items=TARGETS)
    object: bpy.props.StringProperty(name="Object", description="Name of the object to lead the focus to")
    location: bpy.props.FloatVectorProperty(
        name="Location", description="World coordinates to lead the focus to", subtype="XYZ", unit="LENGTH"
    )
    frame_start: bpy.props.IntProperty(name="Start", description="The focus sets out at this frame", default=1)
    frame_end: bpy.props.IntProperty(name="End", description="The focus is there at this frame", default=250)
    near: bpy.props.FloatProperty(name="Inner Radius", **IN_SCENE)
    far: bpy.props.FloatProperty(name="Outer Radius", **IN_SCENE)
    near_heights: bpy.props.FloatProperty(name="Inner Radius (Heights)", **IN_FRAME, **same_in_frame("near"))
    far_heights: bpy.props.FloatProperty(name="Outer Radius (Heights)", **IN_FRAME, **same_in_frame("far"))
    asked: bpy.props.BoolProperty(options={"HIDDEN", "SKIP_SAVE"})  # the object is that of the dialog
    easing: bpy.props.EnumProperty(
        name="Easing", description="How the focus sets out and arrives", items=EASINGS, default="SINE"
    )

    @classmethod
    def hindrance(cls, context):
        return (focus_kinds.of(context.scene.fovea) if context.scene else focus_kinds.KINDS["NONE"]).no_pull

    def invoke(self, context, event):
        scene, active = context.scene, context.object
        if active and active != scene.fovea.focus_object:
            self.object = active.name
        self.asked, scene.fovea.pull_object = True, scene.objects.get(self.object)
        self.target = "OBJECT" if self.object in scene.objects else "CURSOR"
        self.location = scene.cursor.location
        self.frame_start, self.frame_end = frames_of(scene)
        names = focus_kinds.of(scene.fovea).radii
        self.near, self.far = (getattr(scene.fovea, name) for name in names)
        return context.window_manager.invoke_props_dialog(self, confirm_text="Key Focus")

    def cancel(self, context):
        context.scene.fovea.pull_object = None

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        layout.prop(self, "target")
        if self.target == "OBJECT":
            layout.prop(context.scene.fovea, "pull_object", text="Object")
        elif self.target == "LOCATION":
            layout.prop(self, "location")
        in_frame = focus_kinds.of(context.scene.fovea).in_frame
        radii = ("near_heights", "far_heights") if in_frame else ("near", "far")
        for name in ("frame_start", "frame_end", *radii, "easing"):
            layout.prop(self, name)

    def act(self, context):
        scene = context.scene
        if self.asked:
            chosen, scene.fovea.pull_object = scene.fovea.pull_object, None
            self.object = chosen.name if chosen else ""
        if problem := self._problem(scene):
            raise CannotDraw(problem)
        at = self._at(scene)
        kind = focus_kinds.of(scene.fovea)
        if kind.in_frame:
            x, y = camera.in_frame(context.evaluated_depsgraph_get(), at)
            at = x, 1 - y
        names = kind.radii
        near, far = (
            getattr(scene.fovea, name) if radius < 0 else radius for name, radius in zip(names, (self.near, self.far))
        )
        pull(scene, at, near, max(near, far), self.frame_start, self.frame_end, self.easing)
        if hold(scene, self.frame_start, self.frame_end):
            frames = f"{scene.frame_start} to {scene.frame_end}"
            told = f"The scene's frames are {frames} now, so that all of the pull is played"
            self.report({"INFO"}, told)

    def _problem(self, scene):
        """A sentence on why the pull cannot be keyed, or None."""
        if self.frame_end <= self.frame_start:
            return f"The pull ends at frame {self.frame_end}, not after {self.frame_start}, where it starts"
        if self.target == "OBJECT" and self.object not in scene.objects:
            return f"There is no object '{self.object}' in the scene" if self.object else "Choose an object to lead to"
        if self.target == "OBJECT" and scene.objects[self.object] == scene.fovea.focus_object:
            return f"'{self.object}' is where the focus is already"
        if focus_kinds.of(scene.fovea).in_frame and scene.camera is None:
            return "The scene has no camera, in whose frame the place would be"
        return None

    def _at(self, scene):
        if self.target == "OBJECT":
            return scene.objects[self.object].matrix_world.translation.copy()
        return Vector(scene.cursor.location if self.target == "CURSOR" else self.location)
