# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces, fields and lines as NumPy arrays, for Blender's console and scripts.

    from bl_ext.user_default.fovea.scene import api as fovea

    surface = fovea.surface(bpy.context.object)
    fovea.fields(surface)["k1"]                                     # curvature at every vertex
    fovea.lines("suggestive_contour")["points"]                     # as the scene's camera sees it
    fovea.lines("crease", [bpy.context.object], visible=True, angle=30)["px"]

Everything is read from the evaluated scene with modifiers: as in viewports, unless a depsgraph is given (that of a
final render comes from as_rendered.look). Arrays may be views of native memory: copy them before writing. Errors are
ValueError, CannotDraw or native.Unavailable, with a one-sentence message.
"""

import bpy
import numpy as np

from .. import catalogue, line_arrays, native, pipeline, style
from . import camera as cameras
from . import color_images
from . import scene as scenes
from . import surfaces as kept
from .problem import CannotDraw


def definitions():
    """The line definitions: tuples of dicts; see catalogue.py for their keys."""
    return catalogue.definitions()


def surfaces(depsgraph=None):
    """{object name: native Surface} of all objects that are drawn, in object space.

    A Surface has positions (V, 3) float32, triangles (T, 3) uint32, edges (E, 2), and report: counts of elements that
    were left out or look wrong.
    """
    snapshot = _snapshot(depsgraph or bpy.context.evaluated_depsgraph_get())
    found = {}  # of an object that has hair, too, its mesh: the first
    for origin in snapshot.origins:
        found.setdefault(origin.object, snapshot.surfaces[origin.surface])
    return found


def surface(obj, depsgraph=None):
    """The native Surface of an object, refined and repaired according to its settings. ValueError if it has none."""
    found = surfaces(depsgraph).get(obj.name)
    if found is None:
        raise ValueError(f"'{obj.name}' has no surface in this scene: it is no mesh, hidden, or set to be ignored")
    return found


def fields(of, estimator="automatic", degree=0, rings=0):
    """Curvature at the vertices of a native Surface or an object: a dict of normal (V, 3), k1, k2 (V,) float32 with
    |k1| >= |k2|, in 1 / object units and positive where the surface curves away from the normal; feature_size, the
    length that thresholds are relative to; reason: which estimator was used, and why.

    estimator: automatic, jets (Cazals & Pouget 2003; degree 2 to 4 over that many rings; 0: chosen from the mesh's
    noise) or one_ring (Rusinkiewicz 2004).
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
    """Lines of one definition as polylines in world space: the dict of line_arrays.whole (all paths) or, with
    `visible`, of line_arrays.seen (visible runs; with `hidden`, hidden ones as well), plus object: (R,) name of each
    polyline's object, "" for image-space lines.

    definition: a name in `definitions()`; its parameters by name, in the registry's units (angles in degrees).
    objects: the objects whose lines are returned, None: all; the others still occlude. camera: an object, None: the
    scene's. Paths are split at corners sharper than corner_angle (degrees).
    """
    core = native.load()
    kinds = {definition: style.parameters(definition, parameters, "lines")}
    depsgraph = depsgraph or bpy.context.evaluated_depsgraph_get()
    snapshot, view = _snapshot(depsgraph), cameras.of_scene(depsgraph, camera)
    if objects is not None:
        wanted = {obj.name for obj in objects}
        others = np.array([origin.object not in wanted for origin in snapshot.origins], bool)
        snapshot.usage[others[snapshot.origin_of_placement]] &= ~np.uint8(scenes.DRAW)
    chosen, placed = pipeline.style_of_lines(kinds, corner_angle, hidden), scenes.placed(core, snapshot)
    frame = pipeline.frame(placed, scenes.seen(core, view), chosen, core.CpuBackend(), pipeline.options(all_paths=True))
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
    """Transforms whole paths in place from object to world space, except image-space lines, which are there already."""
    of_point = np.repeat(placement.astype(np.int64), np.diff(found["offsets"]))
    placed = of_point != native.UNSET
    found["points"][placed] = line_arrays.placed(found["points"][placed], object_to_world[of_point[placed]])


def _snapshot(depsgraph):
    snapshot = scenes.gather(depsgraph, kept.SurfaceCache(native.load()), images=color_images.ImageCache(native.load()))
    if not snapshot.surfaces:
        raise CannotDraw("The scene is empty: there is nothing that has lines")
    return snapshot
