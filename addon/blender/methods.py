"""Which backend draws, and how it is decided what is hidden."""

import os

from .. import pipeline
from ..backend import cpu, gpu_viewport
from . import preferences


def choose(settings, *, in_viewport):
    """(backend, visibility) of a scene's settings. Call it where a picture is drawn: only there is a GPU context.

    The environment's FOVEA_BACKEND goes before the scene's choice. Renders are exact unless they are told otherwise, so
    that frames drawn on different machines do not differ; viewports are quick where the GPU is.
    """
    wanted = os.environ.get("FOVEA_BACKEND", settings.backend).upper()
    usable = wanted != "CPU" and preferences.gl_renderer() is not None
    hardware = usable and not gpu_viewport.is_software()
    with_gpu = usable and (wanted == "GPU" or hardware)
    sampled = settings.visibility == "ATLAS" or (settings.visibility == "AUTO" and in_viewport and hardware)
    return _backend(with_gpu), pipeline.SAMPLED if sampled else pipeline.EXACT


def _backend(with_gpu):
    if not with_gpu:
        return cpu.Backend()
    from ..backend import gpu  # loaded only where there is a GPU

    return gpu.Backend()
