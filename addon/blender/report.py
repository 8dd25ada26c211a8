"""Report: what of the scene was left out of the drawing and why, how long the last picture took, and memory."""

import sys
from collections import Counter
from pathlib import Path

import bpy

from . import line_operators, properties, session

TEXT = "Fovea Report"  # name of the text datablock
_IN_POPUP = 24  # lines that a popup shows


def skipped(read, depsgraph):
    """Sentences about what is not drawn, or not as it is."""
    told = list(read.remarks)
    for surface in read.snapshot.surfaces:
        found = [f"{surface.report[key]} {words}" for key, words in session.REMARKS.items() if surface.report.get(key)]
        if found:
            told.append(f"'{surface.name}': {'; '.join(found)}")
    return told + [f"'{obj.name}': {why}" for obj in depsgraph.scene.objects if (why := _why_not(obj, read))]


def _why_not(obj, read):
    """Why an object has no lines; None where it has some, or where nobody would expect any."""
    if obj.type not in {"MESH", "CURVE", "SURFACE", "FONT", "META", "CURVES", "POINTCLOUD", "VOLUME"}:
        return None
    if obj.fovea.usage in {"IGNORE", "OCCLUDE"}:
        return {"IGNORE": "is ignored, as its line drawing setting says", "OCCLUDE": "only hides what lies behind it"}[
            obj.fovea.usage
        ]
    if not obj.visible_camera:
        return "is invisible to cameras, as its visibility settings say"
    if obj.name in read.snapshot.objects:
        return None
    if not obj.original.visible_get():
        return "is hidden in viewports"
    if obj.type in {"CURVES", "POINTCLOUD", "VOLUME"}:
        return "has no surface whose lines could be drawn"
    return "has no faces and no edges"


def drawn(read):
    """Lines about what is drawn."""
    surfaces, placed = read.snapshot.surfaces, Counter(read.snapshot.surface_of_placement.tolist())
    triangles = sum(len(surfaces[i].triangles) * count for i, count in placed.items())
    yield f"{len(read.snapshot.objects)} objects and instances of {len(surfaces)} meshes, {triangles} triangles"


def times(statistics):
    """Lines about the last picture's stages; `statistics` as of session.last_statistics."""
    if not statistics:
        yield "No picture has been drawn yet"
        return
    stages = statistics["stages"]
    how = f"{statistics['visibility']} visibility, by the {statistics['backend']}"
    yield f"{sum(stages.values()):.0f} ms, {statistics['strokes']} strokes, {how}"
    for name, duration in stages.items():
        yield f"    {name:12} {duration:8.1f} ms"


def memory():
    """Lines about this process: MB that it has, and has had at most, as far as the system tells."""
    status = Path("/proc/self/status")
    if status.exists():
        found = dict(line.split(":", 1) for line in status.read_text().splitlines() if ":" in line)
        yield f"Blender has {_megabytes(found['VmRSS'])} MB, and has had {_megabytes(found['VmHWM'])} MB at most"
    elif sys.platform == "darwin":
        import resource  # not there on Windows

        yield f"Blender has had {resource.getrusage(resource.RUSAGE_SELF).ru_maxrss >> 20} MB at most"
    else:
        yield "This system does not tell"


def _megabytes(text):
    return int(text.split()[0]) // 1024


def report(read, depsgraph):
    """The whole report, in lines."""
    left_out = skipped(read, depsgraph) or ["Nothing was left out"]
    curvature = session.last_statistics().get("curvature", {})
    parts = {
        "Drawn": list(drawn(read)),
        "Left out, or looks wrong": left_out,
        "Last picture": list(times(session.last_statistics())),
        "Curvature": [f"'{name}': {reason}" for name, reason in curvature.items()],
        "Memory": list(memory()),
    }
    for title, lines in parts.items():
        if lines:
            yield title
            yield from (f"  {line}" for line in lines)


class FOVEA_OT_report(bpy.types.Operator):
    """What of the scene is left out of the drawing and why, how long the last picture took, and memory: shown, and
    written to a text"""

    bl_idname = "fovea.report"
    bl_label = "Report"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        if not properties.definitions():
            cls.poll_message_set("Fovea's native module cannot be used in this Blender")
            return False
        return True

    def invoke(self, context, event):
        result = self.execute(context)
        if result == {"FINISHED"}:
            context.window_manager.popup_menu(_shown, title=f"{TEXT} (all of it is in the text of that name)")
        return result

    def execute(self, context):
        with line_operators.reported(self):
            depsgraph = context.evaluated_depsgraph_get()
            read = line_operators.read(depsgraph, properties.style_of(depsgraph.scene_eval))
            text = bpy.data.texts.get(TEXT) or bpy.data.texts.new(TEXT)
            text.from_string("\n".join(report(read, depsgraph)) + "\n")
            return {"FINISHED"}
        return {"CANCELLED"}


def _shown(menu, _context):
    lines = bpy.data.texts[TEXT].as_string().splitlines()
    for line in lines[:_IN_POPUP]:
        menu.layout.label(text=line)
    if len(lines) > _IN_POPUP:
        menu.layout.label(text=f"and {len(lines) - _IN_POPUP} lines more")


def register():
    bpy.utils.register_class(FOVEA_OT_report)


def unregister():
    bpy.utils.unregister_class(FOVEA_OT_report)
