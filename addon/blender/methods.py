"""Which backend draws, and how it is decided what is hidden."""

import os

from .. import pipeline
from ..backend import cpu, gpu_viewport
from . import gpu_context


def choose(engine, settings, *, in_viewport):
    """(backend, visibility) of a scene's settings. Call it where a picture is drawn: only there is a GPU context.

    The environment's FOVEA_BACKEND goes before the scene's choice. Renders are exact unless they are told otherwise, so
    that frames drawn on different machines do not differ; viewports are quick where the GPU is. The backend stays with
    the engine, which lives as long as the context: through an animation, or while a viewport is open.
    """
    wanted = os.environ.get("FOVEA_BACKEND", settings.backend).upper()
    usable = wanted != "CPU" and gpu_context.available()
    hardware = usable and not gpu_viewport.is_software()
    name = "gpu" if usable and (wanted == "GPU" or hardware) else "cpu"
    if wanted == "GPU" and name == "cpu":
        engine.report({"INFO"}, "OpenGL cannot be used here: drawn by the CPU")
    if engine.backend is None or engine.backend.name != name:
        engine.backend = _backend(name)
    sampled = settings.visibility == "ATLAS" or (settings.visibility == "AUTO" and in_viewport and hardware)
    return engine.backend, pipeline.SAMPLED if sampled else pipeline.EXACT


def _backend(name):
    if name == "cpu":
        return cpu.Backend()
    from ..backend import gpu  # loaded only where there is a GPU

    return gpu.Backend()
