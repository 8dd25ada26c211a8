# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces, fields and lines as NumPy arrays, for Blender's console and scripts.

    from bl_ext.user_default.fovea.scene import api as fovea

    surface = fovea.surface(bpy.context.object)
    fovea.fields(surface)["k1"]                                     # curvature at every vertex
    fovea.lines("suggestive_contour")["points"]                     # as the scene's camera sees it
    fovea.lines("crease", [bpy.context.object], visible=True, angle=30)["px"]

All is that of the evaluated scene, modifiers included: as viewports show it, unless a depsgraph is given, as
as_rendered.look does with that of a final render. Arrays may be views of native memory: copy before you write.
What cannot be done raises ValueError, CannotDraw, or native.Unavailable with one sentence that says why.
"""

import bpy
import numpy as np

from .. import catalogue, line_arrays, native, pipeline, style
from . import camera as cameras
from . import scene as scenes
from . import surfaces as kept
from .problem import CannotDraw


def definitions():
    """The line definitions: tuples of dicts; see catalogue.py for their keys."""
    return catalogue.definitions()


def surfaces(depsgraph=None):
    """{object name: native Surface} of all that is drawn, in the objects' own space.

    A Surface has positions (V, 3) float32, triangles (T, 3) uint32, edges (E, 2), and report: {what: how many elements
    were left out or look wrong}.
    """
    snapshot = _snapshot(depsgraph or bpy.context.evaluated_depsgraph_get())
    return {name: snapshot.surfaces[i] for name, i in zip(snapshot.objects, snapshot.surface_of_placement)}


def surface(obj, depsgraph=None):
    """The native Surface of an object; refined and repaired as its settings say. ValueError where it has none."""
    found = surfaces(depsgraph).get(obj.name)
    if found is None:
        raise ValueError(f"'{obj.name}' has no surface in this scene: it is no mesh, hidden, or set to be ignored")
    return found


def fields(of, estimator="automatic", degree=0, rings=0):
    """Curvature at the vertices of a native Surface or an object: a dict of normal (V, 3), k1, k2 (V,) float32 with
    |k1| >= |k2|, in 1 / object units and positive where the surface curves away from the normal; feature_size, the
    length that thresholds are relative to; reason: which estimator was taken, and why.

    estimator: automatic, jets (Cazals & Pouget 2003; degree 2 to 4 over so many rings, 0: by how noisy the mesh is) or
    one_ring (Rusinkiewicz 2004).
    """
    of = surface(of) if isinstance(of, bpy.types.Object) else of
    found = of.fields(estimator, degree, rings)
    return {name: getattr(found, name) for name in ("normal", "k1", "k2", "feature_size", "reason")}


def lines(
    definition,
    objects=None,
    *,
    camera=None,
    depsgraph=None,
    visible=False,
    hidden=False,
    corner_angle=60.0,
    **parameters,
):
    """Lines of one definition as polylines in world space: the dict of arrays that line_arrays.whole gives, and with
    `visible` that of line_arrays.seen (with `hidden`, what surfaces hide, too); beside these object: (R,) names of the
    objects that the polylines are of, empty for lines of the image.

    definition: a name of `definitions()`; its parameters by name, in the registry's units (angles in degrees).
    objects: whose lines; None: all. Others still hide lines. camera: an object, None: the scene's. Paths end at corners
    sharper than corner_angle (degrees).
    """
    core = native.load()
    kinds = {definition: style.parameters(definition, parameters, "lines")}
    depsgraph = depsgraph or bpy.context.evaluated_depsgraph_get()
    snapshot, view = _snapshot(depsgraph), cameras.of_scene(depsgraph, camera)
    if objects is not None:
        wanted = {obj.name for obj in objects}
        others = np.array([name not in wanted for name in snapshot.objects], bool)
        snapshot.usage[others] &= ~np.uint8(scenes.DRAW)
    chosen, placed = pipeline.style_of_lines(kinds, corner_angle, hidden), scenes.placed(core, snapshot)
    frame = pipeline.frame(placed, scenes.seen(core, view), chosen, core.CpuBackend(), pipeline.options())
    frame.find()
    view_to_world, paths = np.linalg.inv(view.world_to_view), frame.paths
    if visible or hidden:
        found = line_arrays.seen(frame, view_to_world)
    else:
        found = line_arrays.whole(paths, view_to_world)
        _to_world(found, paths.placement, snapshot.object_to_world)
    names = np.array([*snapshot.objects, ""])
    placement = paths.placement[found.pop("path")].astype(np.int64)
    found["object"] = names[np.where(placement == native.UNSET, len(names) - 1, placement)]
    return found


def _to_world(found, placement, object_to_world):
    """Moves whole paths, but those of the image, from the objects' spaces."""
    of_point = np.repeat(placement.astype(np.int64), np.diff(found["offsets"]))
    placed = of_point != native.UNSET
    found["points"][placed] = line_arrays.placed(found["points"][placed], object_to_world[of_point[placed]])


def _snapshot(depsgraph):
    snapshot = scenes.gather(depsgraph, kept.SurfaceCache(native.load()))
    if not snapshot.surfaces:
        raise CannotDraw("The scene is empty: there is nothing that has lines")
    return snapshot
