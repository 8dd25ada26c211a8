# SPDX-License-Identifier: GPL-3.0-or-later
"""Report: objects that a final render leaves out and why, times of the last picture, and memory."""

import sys
from pathlib import Path

import bpy

from .. import native
from ..scene import surfaces
from ..scene.operator import Operator
from ..scene.shapes import LABELS
from ..style import freestyle
from . import as_rendered, gpu_check, properties, reading, session, stage_labels

TEXT = "Fovea Report"  # name of the text datablock
NO_CAMERA = "The scene has no camera, so it cannot be rendered: this is what viewports show of it"
USAGES = {  # usages of objects that have no lines, explained
    "IGNORE": "is excluded, as its line drawing setting says",
    "OCCLUDE": "only hides what lies behind it, as its line drawing setting says",
}
EMPTY = {  # types of objects that have lines -> why one has none
    **dict.fromkeys(("MESH", "SURFACE", "META"), "has no faces and no edges"),
    **dict.fromkeys(("CURVE", "FONT"), "has no points that are joined"),
    "CURVES": "has no strands of two points or more with a radius",
    "POINTCLOUD": "has no points with a radius",
}
IMAGE = "an Empty that shows an image"
OVER_PICTURE = "is Grease Pencil, which Blender draws over the picture: nothing in the drawing hides it"
NEVER = {  # types of objects that never have lines, explained
    **dict.fromkeys(("GPENCIL", "GREASEPENCIL"), OVER_PICTURE),
    "VOLUME": "is a volume, which has no surface: the modifier Volume to Mesh of a mesh object makes one of it",
    "LATTICE": "is a lattice, which deforms other objects and is not rendered",
    IMAGE: "shows its image in viewports alone: imported as a mesh plane, it is rendered",
}
_IN_POPUP = 24  # most lines in the popup
_NAMED = 3  # most objects listed by name for the same reason


def skipped(read, depsgraph):
    """Sentences about objects and mesh elements that are left out or altered."""
    objects = depsgraph.scene.objects
    absent = [f"'{obj.name}': {why}" for obj in objects if (why := _why_not(obj, read, depsgraph))]
    return [*read.remarks, *surfaces.remarks(read.snapshot.surfaces), *absent]


def _why_not(obj, read, depsgraph):
    """Why an object, or some of it, has no lines; None if it has, or is of a type that has none (lights, say)."""
    kind = IMAGE if obj.type == "EMPTY" and obj.empty_display_type == "IMAGE" else obj.type
    if kind not in EMPTY and kind not in NEVER:
        return None
    if kind in NEVER:
        return _hidden(obj, depsgraph) or NEVER[kind]
    if obj.fovea.usage in USAGES:
        return USAGES[obj.fovea.usage]
    if not obj.visible_camera:
        return "is invisible to cameras, as its visibility settings say"
    if obj.name in read.snapshot.left_out:
        return read.snapshot.left_out[obj.name]
    if obj.name in read.snapshot.drawn:
        return None
    return _hidden(obj, depsgraph) or _why_empty(obj, read)


def _why_empty(obj, read):
    """Why an object that is shown has no lines."""
    family = obj.name.partition(".")[0]
    if obj.type == "META" and family in read.snapshot.drawn:
        return f"is drawn as one with the metaball '{family}'"
    if obj.type == "CURVES" and obj.fovea.hair == "OFF":
        return "has hair that is off, as its line drawing setting says"
    if any(modifier.show_render for modifier in obj.modifiers):
        return f"{EMPTY[obj.type]}, or its modifiers leave none, or it only makes instances of others"
    return EMPTY[obj.type]


def _hidden(obj, depsgraph):
    """Why an object is hidden in renders, or in viewports for a viewport depsgraph; None if it is not."""
    layer = depsgraph.view_layer
    if obj.name not in layer.objects:
        return f"is not in the view layer '{layer.name}'"
    if depsgraph.mode != "RENDER":
        return None if obj.visible_get() else "is hidden in viewports"
    if obj.hide_render:
        return "is disabled in renders"
    if obj.users_collection and all(collection.hide_render for collection in obj.users_collection):
        return "is in a collection that is disabled in renders"
    return None


def drawn(read):
    """Text lines on what is drawn: counts of placements, meshes and triangles."""
    found = read.snapshot
    if not found.surfaces:
        yield "Nothing: there is nothing in the scene that has lines"
        return
    counts = len(found.usage), len(found.surfaces), found.triangle_count
    yield "objects and instances: {}, meshes: {}, triangles: {}".format(*counts)


def transparency(read):
    """Text lines on materials that do not occlude, or occlude although they are partly transparent."""
    remarks = {slot.name: slot.remark for slots in read.snapshot.slots for slot in slots if slot.remark}
    yield from (f"'{name}' {remark}" for name, remark in sorted(remarks.items()))


def times(statistics):
    """Text lines on the last picture's stages; `statistics` as of session.last_statistics."""
    if not statistics:
        yield "No picture has been drawn yet"
        return
    stages = statistics["stages"]
    how = f"{statistics['visibility']} visibility, by the {statistics['backend']}"
    yield f"{sum(stages.values()):.0f} ms, {statistics['strokes']} strokes, {how}"
    for name, duration in stages.items():
        yield f"    {stage_labels.label(name):24} {duration:8.1f} ms"


def memory():
    """Text lines on this process's memory: current and peak resident MB, as far as the system reports them."""
    status = Path("/proc/self/status")
    if status.exists():
        found = dict(line.split(":", 1) for line in status.read_text().splitlines() if ":" in line)
        yield f"Blender uses {_megabytes(found['VmRSS'])} MB, and has used {_megabytes(found['VmHWM'])} MB at most"
    elif sys.platform == "darwin":
        import resource  # not available on Windows

        yield f"Blender has used {resource.getrusage(resource.RUSAGE_SELF).ru_maxrss >> 20} MB at most"
    else:
        yield "This system does not tell"


def _megabytes(text):
    return int(text.split()[0]) // 1024


def report(read, depsgraph, note=""):
    """The whole report as text lines, preceded by `note`."""
    curvature = session.last_statistics().get("curvature", {})
    shapes = session.last_statistics().get("shape", {})
    parts = {
        "Drawn": list(drawn(read)),
        "Left out, or looks wrong": skipped(read, depsgraph) or ["Nothing was left out"],
        "Transparency": list(transparency(read)),
        "Last picture": list(times(session.last_statistics())),
        "GPU": list(gpu_check.lines()),
        "Shapes": list(grouped({name: f"drawn as {LABELS[shape]}: {why}" for name, (shape, why) in shapes.items()})),
        "Curvature": list(grouped(curvature)),
        "Memory": list(memory()),
    }
    if note:
        yield note
    for title, lines in parts.items():
        if lines:
            yield title
            yield from (f"  {line}" for line in lines)


def grouped(reasons):
    """Text lines for {name: reason}, with one line per reason and the names that share it."""
    names = {}
    for name, reason in reasons.items():
        names.setdefault(reason, []).append(f"'{name}'")
    for reason, found in names.items():
        more = f" and {len(found) - _NAMED} more" if len(found) > _NAMED else ""
        yield f"{', '.join(found[:_NAMED])}{more}: {reason}"


def _lines(_engine, depsgraph, note=""):
    """The report on a depsgraph's scene, as a list of text lines."""
    return list(report(reading.Reader().read(depsgraph, properties.style_of(depsgraph.scene_eval)), depsgraph, note))


class FOVEA_OT_report(Operator, bpy.types.Operator):
    """What of the scene a final render leaves out of the drawing and why, how long the last picture took, and memory:
    shown, and written to a text"""

    bl_idname = "fovea.report"
    bl_label = "Report"

    @classmethod
    def hindrance(cls, context):
        return native.problem()

    def invoke(self, context, event):
        result = self.execute(context)
        if result == {"FINISHED"}:
            context.window_manager.popup_menu(_shown, title=f"{TEXT} (all of it is in the text of that name)")
        return result

    def act(self, context):
        if context.scene.camera:
            lines = as_rendered.look(context, _lines)
        else:
            lines = _lines(None, context.evaluated_depsgraph_get(), NO_CAMERA)
        if freestyle.is_on(context.scene):
            lines = [freestyle.OVER, *lines]
        text = bpy.data.texts.get(TEXT) or bpy.data.texts.new(TEXT)
        text.from_string("\n".join(lines) + "\n")


def _shown(menu, _context):
    lines = bpy.data.texts[TEXT].as_string().splitlines()
    for line in lines[:_IN_POPUP]:
        menu.layout.label(text=line)
    if len(lines) > _IN_POPUP:
        menu.layout.label(text=f"and {len(lines) - _IN_POPUP} lines more")
