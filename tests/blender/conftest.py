# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests marked `gpu` run inside a render, because in `blender -b` the gpu module works only there."""

import bpy
import pytest
from the_addon import part


class InsideRender(bpy.types.RenderEngine):
    """Runs the body of one test where a picture would be made."""

    bl_idname = "FOVEA_TEST_GPU"
    bl_label = "Test inside a render"
    bl_use_gpu_context = True
    body = None
    error = None

    def render(self, depsgraph):
        try:
            type(self).body()
        except BaseException as error:  # a test's outcome, skips included, is raised again outside
            type(self).error = error


@pytest.fixture(scope="session")
def gpu_engine():
    """Registered only where Blender can make a context: it aborts where it cannot."""
    if part("render.gpu_context").gl_renderer() is None:
        pytest.skip("OpenGL is unusable here")
    bpy.utils.register_class(InsideRender)
    yield InsideRender
    bpy.utils.unregister_class(InsideRender)


def pytest_addoption(parser):
    parser.addoption("--update-references", action="store_true", help="renew the golden images that do not pass")


def pytest_collection_modifyitems(items):
    for item in items:
        if item.get_closest_marker("gpu"):
            item.fixturenames.insert(0, "gpu_engine")


@pytest.hookimpl(tryfirst=True)
def pytest_pyfunc_call(pyfuncitem):
    if not pyfuncitem.get_closest_marker("gpu"):
        return None
    engine = pyfuncitem.funcargs["gpu_engine"]
    wanted = pyfuncitem._fixtureinfo.argnames
    arguments = {name: pyfuncitem.funcargs[name] for name in wanted}
    engine.body = lambda: pyfuncitem.obj(**arguments)
    engine.error = None
    _render_one_pixel(engine.bl_idname)
    engine.body = None
    if engine.error:
        raise engine.error
    return True


def _render_one_pixel(engine):
    """In a scene of its own, so that the test's scene stays as it is."""
    scene = bpy.data.scenes.new("inside a render")
    camera = bpy.data.objects.new("inside a render", bpy.data.cameras.new("inside a render"))
    scene.collection.objects.link(camera)
    scene.camera = camera
    scene.render.engine = engine
    scene.render.resolution_x = scene.render.resolution_y = 4
    try:
        bpy.ops.render.render(scene=scene.name)
    finally:
        bpy.data.cameras.remove(camera.data)
        bpy.data.scenes.remove(scene)
