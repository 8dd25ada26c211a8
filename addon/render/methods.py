# SPDX-License-Identifier: GPL-3.0-or-later
"""The scene's settings for the backend and the visibility method, and how they are resolved."""

import os

from .. import native
from ..gpu import viewport as gpu_viewport
from ..scene.property_kinds import choice, whole_number
from . import gpu_check, gpu_context

AUTOMATIC = ("AUTO", "Automatic", "Exact in renders and on software OpenGL, Fast (Sampled) in other viewports", 0)
LOOKS = ("probes", "depth_scale")
ADVANCED = {"spine", "item_buffer"}  # methods of the core for special cases, listed below the others
QUALITY = {
    "AUTO": LOOKS,
    "ATLAS": LOOKS,
    "SPINE": LOOKS,
    "ITEM_BUFFER": ("layers", "depth_scale"),
}  # visibility method -> settings of quality that it uses
PROBES = [(str(n), str(n), "", n) for n in (1, 4, 9, 16)]


def properties():
    """Property annotations for the scene's settings."""
    probes = "How often the depth buffer is looked into for every sample: more is smoother and slower"
    scale = "Texels of the depth buffer to a pixel, along each axis: more is more precise and slower"
    layers = "Lines that are told apart at a texel"
    return {
        "visibility": choice("Method", "How it is decided what is hidden", items=[AUTOMATIC, *_known()]),
        "probes": choice("Samples", probes, items=PROBES, default="9"),
        "depth_scale": whole_number("Depth Scale", scale, default=2, min=1, max=3),
        "layers": whole_number("Layers", layers, default=3, min=1, max=3),
    }


def _known():
    """Items of an enumeration: the core's methods, numbered in its order, the advanced ones under a heading; none
    without the core."""
    known = () if native.problem() else native.load().VISIBILITY
    items = {name: (name.upper(), *words, number) for number, (name, *words) in enumerate(known, start=1)}
    usual = [item for name, item in items.items() if name not in ADVANCED]
    return [*usual, ("", "Advanced", ""), *(items[name] for name in items if name in ADVANCED)]


def quality(settings):
    """The native Options that set the quality of sampled visibility, as a dict."""
    return {"probes": int(settings.probes), "depth_scale": settings.depth_scale, "layers": settings.layers}


def choose(engine, settings, *, in_viewport):
    """(backend, name of the visibility method) for a scene's settings. Call it only while drawing, when Blender's GPU
    context is bound.

    The environment variable FOVEA_BACKEND overrides the scene's setting. AUTO visibility is exact in renders, so that
    frames from different machines agree, and sampled in viewports with a hardware GPU. The backend is stored
    in the engine, which lives as long as the context: through an animation, or while a viewport is open; and so is the
    `note` of gpu_check on a GPU that does not draw as it should, where the CPU draws.
    """
    wanted = os.environ.get("FOVEA_BACKEND", settings.backend).upper()
    usable = wanted != "CPU" and gpu_context.available()
    hardware = usable and not gpu_viewport.is_software()
    name = "gpu" if usable and (wanted == "GPU" or hardware) else "cpu"
    if wanted == "GPU" and name == "cpu":
        engine.report({"INFO"}, "OpenGL cannot be used here: drawn by the CPU")
    method = _method(settings, in_viewport and hardware)
    engine.note = gpu_check.note(lambda: _kept(engine, "gpu"), method) if name == "gpu" else ""
    if engine.note:
        name, method = "cpu", _method(settings, False)
    return _kept(engine, name), method


def _method(settings, is_fast):
    """Name of the visibility method. `is_fast`: AUTO is the fast one."""
    automatic = "ATLAS" if is_fast else "EXACT"
    return (automatic if settings.visibility == "AUTO" else settings.visibility).lower()


def _kept(engine, name):
    """The engine's backend, another one if it has not that name."""
    if engine.backend is None or engine.backend.name != name:
        engine.backend = _backend(name)
    return engine.backend


def _backend(name):
    if name == "cpu":
        return native.load().CpuBackend()
    from ..gpu.backend import Backend  # imported only if a GPU is used

    return Backend()
