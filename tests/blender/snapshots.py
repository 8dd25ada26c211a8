# SPDX-License-Identifier: GPL-3.0-or-later
"""Snapshots of the scene for viewports and renders, and a stand-in for native surfaces that stores its input arrays."""

from types import SimpleNamespace

import bpy
import pytest
from the_addon import add_camera, empty_scene, part

scene = part("scene.scene")
surfaces = part("scene.surfaces")
NATIVE = part("native").load()
ARRAYS = "positions edge_verts corner_verts corner_edges polygon_offsets ngon_triangles ngon_polygon material occluding"
ARRAYS = [*ARRAYS.split(), "sharp_edges", "seams", "edge_marks", "smooth_edges", "one_sided"]


class RecordedMesh(NATIVE.Mesh):
    """Keeps what it was made of; None: nothing was given."""

    def __init__(self, **arrays):
        super().__init__(**arrays)
        self.arrays = dict.fromkeys(ARRAYS) | {k: a if a is None else a.copy() for k, a in arrays.items()}


class RecordedSurface(SimpleNamespace):
    """Keeps what a native surface was made of."""

    triangles, fields_reason = (), ""  # by which memory is reckoned
    shape, known_shape = "automatic", ("automatic", "as recorded")

    def __init__(self, name, mesh):
        super().__init__(name=name, **mesh.arrays)

    def set_field_options(self, *options):
        self.field_options = options

    def set_shape(self, shape):
        self.shape = shape

    def set_positions(self, positions, *, refit):
        self.positions = positions.copy()

    def set_rest(self, positions):
        self.rest = None if positions is None else positions.copy()


RECORDING = SimpleNamespace(
    Mesh=RecordedMesh,
    Surface=RecordedSurface,
    RefinedSurface=NATIVE.RefinedSurface,
    content_hash=NATIVE.content_hash,
    all_polygons_have=NATIVE.all_polygons_have,
    release_memory=NATIVE.release_memory,
)


class Capture(bpy.types.RenderEngine):
    """Takes what a final render sees instead of drawing it."""

    bl_idname = "FOVEA_TEST_CAPTURE"
    bl_label = "Capture"
    cache = None
    taken = {}

    def render(self, depsgraph):
        self.taken[depsgraph.view_layer.name] = scene.gather(depsgraph, Capture.cache)


@pytest.fixture(scope="module")
def capture_engine():
    bpy.utils.register_class(Capture)
    yield
    bpy.utils.unregister_class(Capture)


@pytest.fixture
def fresh_scene():
    empty_scene()


def new_cache(core=RECORDING):
    return surfaces.SurfaceCache(core)


def in_viewport(cache=None):
    """The Snapshot of the scene as the viewport would show it."""
    bpy.context.view_layer.update()
    return scene.gather(bpy.context.evaluated_depsgraph_get(), cache or new_cache())


def in_render():
    """{view layer: Snapshot} of the scene as a final render sees it."""
    if bpy.context.scene.camera is None:
        add_camera()
    render = bpy.context.scene.render
    render.engine, render.resolution_x, render.resolution_y = Capture.bl_idname, 16, 16
    Capture.cache, Capture.taken = new_cache(), {}
    taken = Capture.taken
    bpy.ops.render.render()
    return taken


def usage_of(snapshot):
    return dict(zip(snapshot.objects, snapshot.usage.tolist()))
