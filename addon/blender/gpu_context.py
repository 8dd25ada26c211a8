# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether renders get a GPU context. Blender reads that when it registers the engine: asking for one registers it anew.

A context costs memory and time, in software OpenGL (which runs on the CPU) more than it is worth: there only a scene
that wants the GPU, or FOVEA_BACKEND=gpu, brings one.
"""

import os

import bpy
from bpy.app.handlers import persistent

from . import preferences

SOFTWARE = ("llvmpipe", "softpipe", "swrast", "software")

_engine = None  # the registered class


def available():
    """Whether renders of this process get a context."""
    return bool(_engine and _engine.bl_use_gpu_context)


def demand():
    """A scene wants the GPU: renders get a context from now on, where one can be made."""
    if _engine and not available() and preferences.gl_renderer() is not None:
        bpy.utils.unregister_class(_engine)
        _engine.bl_use_gpu_context = True
        bpy.utils.register_class(_engine)


@persistent
def _file_loaded(*_arguments):
    if any(scene.fovea.backend == "GPU" for scene in bpy.data.scenes):
        demand()


def register(engine):
    """Registers the engine class."""
    global _engine
    _engine = engine
    renderer = preferences.gl_renderer()
    wanted = os.environ.get("FOVEA_BACKEND", "").lower() == "gpu"
    hardware = renderer is not None and not any(name in renderer.lower() for name in SOFTWARE)
    engine.bl_use_gpu_context = renderer is not None and (wanted or hardware)
    bpy.utils.register_class(engine)
    bpy.app.handlers.load_post.append(_file_loaded)


def unregister():
    global _engine
    bpy.app.handlers.load_post.remove(_file_loaded)
    bpy.utils.unregister_class(_engine)
    _engine = None
