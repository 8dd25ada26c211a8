# SPDX-License-Identifier: GPL-3.0-or-later
"""Decides whether renders get a GPU context. Blender reads `bl_use_gpu_context` when the engine class is registered, so
requesting a context later registers the class again.

A context costs memory and time. With software OpenGL (on the CPU) that does not pay off; there only a scene with the
device GPU, or FOVEA_BACKEND=gpu, requests one.
"""

import functools
import os
import subprocess
import sys
from pathlib import Path

import bpy
from bpy.app.handlers import persistent

from ..scene.own_preferences import own
from .gl_probe import is_software

SEEN = "FOVEA_GL_RENDERER"  # environment variable that passes the probe's result to child processes; empty: unusable

_engine = None  # the registered engine class


def available():
    """Whether renders of this process get a GPU context."""
    return bool(_engine and _engine.bl_use_gpu_context)


def demand():
    """Requests a GPU context for all further renders, if one can be created."""
    if _engine and not available() and gl_renderer() is not None:
        bpy.utils.unregister_class(_engine)
        _engine.bl_use_gpu_context = True
        bpy.utils.register_class(_engine)


@functools.cache
def gl_renderer():
    """Name of the OpenGL renderer that renders of this process would get ("window" with a window); None if no context
    may be requested.

    In background mode Blender aborts if a requested context cannot be created, so a child process tries first.
    """
    if os.environ.get("FOVEA_BACKEND", "").lower() == "cpu":
        return None
    if not bpy.app.background:
        return "window"
    # The probe works on Linux only.
    if not sys.platform.startswith("linux") or (own() and not own().background_gpu):
        return None
    if SEEN not in os.environ:
        os.environ[SEEN] = _probe()
    return os.environ[SEEN] or None


def _probe():
    script = Path(__file__).with_name("gl_probe.py")
    try:
        found = subprocess.run([sys.executable, "-I", str(script)], capture_output=True, text=True, timeout=20)
    except (OSError, subprocess.TimeoutExpired) as error:
        print(f"Fovea: no GPU context for renders: {error}")
        return ""
    return found.stdout.strip() if found.returncode == 0 else ""


@persistent
def _file_loaded(*_arguments):
    if any(scene.fovea.backend == "GPU" for scene in bpy.data.scenes):
        demand()


def register(engine):
    """Registers the engine class, with a GPU context on hardware OpenGL or if FOVEA_BACKEND=gpu."""
    global _engine
    _engine = engine
    renderer = gl_renderer()
    wanted = os.environ.get("FOVEA_BACKEND", "").lower() == "gpu"
    hardware = renderer is not None and not is_software(renderer)
    engine.bl_use_gpu_context = renderer is not None and (wanted or hardware)
    bpy.utils.register_class(engine)
    bpy.app.handlers.load_post.append(_file_loaded)


def unregister():
    global _engine
    bpy.app.handlers.load_post.remove(_file_loaded)
    bpy.utils.unregister_class(_engine)
    _engine = None
