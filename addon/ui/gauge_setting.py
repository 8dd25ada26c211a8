# SPDX-License-Identifier: GPL-3.0-or-later
"""Render > Fovea > Set Gauges of a Study: a person turns gauges on a picture in an image editor until they seem to lie
on what it shows, and they are saved beside the study, as those of its page are."""

import bpy
import numpy as np
from bpy_extras.io_utils import ImportHelper

from .. import files, gauge_practice, gauge_session, gauges
from ..gpu import overlay
from ..render import line_operators
from ..scene.operator import TOLD, Operator
from ..scene.problem import CannotDraw

COLOR, OFF, WIDTH = (0.0, 0.8, 0.0, 1.0), (0.93, 0.4, 0.0, 1.0), 2.5  # as on the page; pixels, of interface scale 1
KEYS = (
    ("MOUSE_LMB_DRAG", "Turn"),
    ("EVENT_SPACEKEY", "Next"),
    ("EVENT_BACKSPACE", "Back"),
    ("EVENT_ESC", "Stop, and Keep What Is Set"),
)
ELSEWHERE = {"MIDDLEMOUSE", "WHEELUPMOUSE", "WHEELDOWNMOUSE", "TRACKPADPAN", "TRACKPADZOOM", "HOME", "TIMER"}

last = {}  # name of a study: the Session that the last person had here


class Shown:
    """The gauge of a Session, or of a Practice, over its picture, in each image editor that shows that."""

    def __init__(self, session, image):
        self.session, self.image = session, image.name  # no reference to it would outlive an undo
        self.hand = gauge_session.Hand(session)
        self._handle = bpy.types.SpaceImageEditor.draw_handler_add(self._draw, (), "WINDOW", "POST_PIXEL")

    @property
    def is_practice(self):
        return isinstance(self.session, gauge_practice.Practice)

    def end(self):
        """Takes the gauge away, and what was practiced on."""
        bpy.types.SpaceImageEditor.draw_handler_remove(self._handle, "WINDOW")
        if self.is_practice and (image := bpy.data.images.get(self.image)):
            bpy.data.images.remove(image)

    def editor(self, window):
        """(area, region) of a window that has the picture; None: there is none."""
        for area in window.screen.areas:
            if area.type == "IMAGE_EDITOR" and self._is_in(area.spaces.active):
                return area, next(region for region in area.regions if region.type == "WINDOW")
        return None

    def _is_in(self, space):
        return space.image is not None and space.image.name == self.image

    def in_picture(self, region, px):
        """Pixels of the picture, from the upper left, of pixels of a region."""
        width, height = self.session.study.size
        x, y = region.view2d.region_to_view(*px)
        return x * width, (1 - y) * height

    def lines(self, region):
        """[disc (k, 2), pin (2, 2)] of the gauge in pixels of a region."""
        width, height = self.session.study.size
        low, high = (np.array(region.view2d.region_to_view(*px)) for px in ((0, 0), (1000, 1000)))
        scale = 1000 / ((high - low) * (width, height))  # pixels of the region per pixel of the picture
        x, y = self.session.place
        middle = (np.array((x, height - y)) - low * (width, height)) * scale
        drawn = gauges.lines(self.session.normal, self.session.study.radius)
        return [middle + line * scale for line in drawn]

    def words(self):
        session = self.session
        if self.is_practice and not session.done:
            return f"Practice {session.at + 1} of {len(session.steps)}: {session.words}"
        return self.hand.told or f"Gauge {session.at + 1} of {len(session.steps)}"

    def _draw(self):
        """Draw handler: called after Blender has drawn an image editor."""
        context = bpy.context
        if self._is_in(context.space_data) and not self.session.done:
            color = OFF if self.is_practice and not self.session.is_good else COLOR
            for line in self.lines(context.region):
                overlay.curve(line, color, WIDTH * context.preferences.system.ui_scale)


def device(context, event):
    """What a Session notes of pointer and window, as the page does."""
    pointer = "pen" if event is not None and event.is_tablet else "mouse"
    window, ratio = context.window, round(context.preferences.system.ui_scale, 3)
    return {"pointer": pointer, "ratio": ratio, "width": window.width, "height": window.height, "program": "Blender"}


def practiced_on():
    """A new image of the shape of a Practice."""
    gray = gauge_practice.picture()
    image = bpy.data.images.new("Gauge Practice", *gray.shape[::-1])
    pixels = np.ones((*gray.shape, 4), np.float32)
    pixels[..., :3] = gray[..., None]
    image.pixels.foreach_set(pixels.ravel())
    image.pack()  # or undo would empty it
    return image


class FOVEA_OT_set_gauges(Operator, ImportHelper, bpy.types.Operator):
    """Turn gauges on a picture of a study until they seem to lie on what it shows. Settings are saved in the study's
    folder, for the analysis. Name the study.json that `fovea study make` wrote"""

    bl_idname, bl_label = "fovea.set_gauges", "Set Gauges of a Study"
    errors = (*TOLD, ValueError, OSError)

    filename_ext = ".json"
    filter_glob: bpy.props.StringProperty(default="*.json", options={"HIDDEN"})
    another: bpy.props.BoolProperty(
        name="Another Person",
        description="Someone else than who has set gauges of this study in this Blender, who may see another picture",
        options={"SKIP_SAVE"},
    )
    practice: bpy.props.BoolProperty(
        name="Practice First",
        description="Someone who sets gauges of this study for the first time sets four on a simple shape before, "
        "which tells how far off they are",
        default=True,
    )

    def execute(self, context):
        done = super().execute(context)
        return {"RUNNING_MODAL"} if done == {"FINISHED"} else done

    def act(self, context):
        if bpy.app.background:
            raise CannotDraw("Gauges are set in a window: start Blender without --background")
        study = gauge_session.read(bpy.path.abspath(self.filepath))
        before = None if self.another else last.get(study.name)
        if before is not None and not before.done:
            session = before  # goes on where it was left
        else:
            session = gauge_session.begun(study, before, device(context, None))
        path = study.picture(session.stimulus)
        image = bpy.data.images.load(str(path), check_existing=True)
        if tuple(image.size) != study.size:
            raise ValueError(f"{path} is not as large as its study says: make the study again")
        self._session, self._picture = session, image.name
        if self.practice and before is None:
            shown = Shown(gauge_practice.Practice(), practiced_on())
        else:
            shown = self._studied()
        line_operators.open_image(context, bpy.data.images[shown.image])
        places = ((window, shown.editor(window)) for window in context.window_manager.windows)
        place = next(((window, *found) for window, found in places if found), None)
        if place is None:
            shown.end()
            raise CannotDraw("There is no image editor for the picture: open one, and set the gauges again")
        self._shown = shown
        window, area, region = place
        with context.temp_override(window=window, area=area, region=region):
            bpy.ops.image.view_all(fit_view=True)
            context.window_manager.modal_handler_add(self)
        context.workspace.status_text_set(_draw_keys)
        self._tell(context, area)

    def _studied(self):
        """The Shown of the session, which begins."""
        last[self._session.study.name] = self._session
        self._session.resume()
        return Shown(self._session, bpy.data.images[self._picture])

    def _go_on(self, context, area, region):
        """From the practice to the session."""
        self._shown.end()
        self._shown = self._studied()
        area.spaces.active.image = bpy.data.images[self._picture]
        with context.temp_override(area=area, region=region):
            bpy.ops.image.view_all(fit_view=True)

    def modal(self, context, event):
        if (place := self._shown.editor(context.window)) is None:
            return self._end(context)
        area, region = place
        x, y = event.mouse_x - region.x, event.mouse_y - region.y
        is_inside = 0 <= x < region.width and 0 <= y < region.height
        if event.type in ELSEWHERE or event.type.startswith("NDOF"):
            return {"PASS_THROUGH"}
        hand = self._shown.hand
        if event.type == "LEFTMOUSE" and event.value == "PRESS" and not is_inside:
            return {"PASS_THROUGH"}
        if event.is_tablet:
            self._session.device["pointer"] = "pen"
        done = hand.take(event.type, event.value, self._shown.in_picture(region, (x, y)))
        if done == "end" and self._shown.is_practice and self._shown.session.done:
            self._go_on(context, area, region)
            done = "moved"
        try:
            if done == "moved":
                self._session.save()
        except files.NotWritten as error:
            self.report({"ERROR"}, str(error))
            return self._end(context)
        if done == "end":
            return self._end(context)
        if done:
            self._tell(context, area)
        return {"RUNNING_MODAL"}

    def cancel(self, context):
        self._end(context)

    def _tell(self, context, area):
        area.header_text_set(self._shown.words())
        area.tag_redraw()

    def _end(self, context):
        """Saves what is set, and takes the gauge away."""
        shown, session = self._shown, self._session
        if not session.done:
            session.pause()
        context.workspace.status_text_set(None)
        if place := shown.editor(context.window):
            place[0].header_text_set(None)
            place[0].tag_redraw()
        shown.end()
        try:
            session.save()
        except files.NotWritten as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        if not session.count:
            return {"CANCELLED"}
        self.report({"INFO"}, f"{session.count} of {len(session.steps)} gauges are in '{session.path.name}'")
        return {"FINISHED"}


def _draw_keys(header, _context):
    """Draws the key hints in the status bar."""
    for icon, text in KEYS:
        header.layout.label(text=text, icon=icon)


def unregister():
    last.clear()
