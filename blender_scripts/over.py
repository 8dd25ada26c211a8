# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines over the render of another engine, for `fovea draw --over`: the engine, its samples, and light where a scene
has none."""

import addon_utils
import bpy
from bl_ext.user_default.fovea.render import lines_over, lines_over_check
from command import model_files
from scenes import stage

ENGINES = {  # --over -> the engine's name in Blender, the first of them that there is
    "cycles": ("CYCLES",),
    "eevee": ("BLENDER_EEVEE", "BLENDER_EEVEE_NEXT"),  # the latter up to 4.5
    "workbench": ("BLENDER_WORKBENCH",),
}
SAMPLES = {"cycles": 32, "eevee": 16}  # to a pixel, of what is no Blender file
SUN = 0.7  # factor on suns, which scenes have for Fovea's plain shading
SKY = (0.3, 0.33, 0.37)  # of the world of what is no Blender file, scene-linear


def set_up(scene, options):
    """Renders of the scene are the engine's, with lines over them. ValueError if this Blender has no such engine."""
    set_engine(scene, options.over)
    if not model_files.is_blend(options.scene):
        light(scene)
    set_samples(scene, options)
    lines_over.repair(scene)
    for sentence in lines_over_check.problems(scene):
        raise ValueError(f"--over {options.over}: {sentence}")
    for layer in lines_over.places(scene):
        node = lines_over.node(scene, lines_over.OVER, layer)
        if options.blend:
            node.inputs["Multiply"].default_value = float(options.blend == "multiply")
        if options.opacity is not None:
            node.inputs["Opacity"].default_value = options.opacity


def set_engine(scene, name):
    if name == "cycles":
        addon_utils.enable("cycles")
    for engine in ENGINES[name]:
        try:
            scene.render.engine = engine
            return
        except TypeError:  # no such item
            pass
    raise ValueError(f"--over {name}: this Blender has no such engine")


def light(scene):
    """A sky, and suns that are not too bright together with it: one if there is no light."""
    scene.world = scene.world or bpy.data.worlds.new("World")
    scene.world.color = SKY
    if scene.world.node_tree is None:
        scene.world.use_nodes = True
    if background := scene.world.node_tree.nodes.get("Background"):
        background.inputs["Color"].default_value = (*SKY, 1.0)
    if not any(obj.type == "LIGHT" for obj in scene.objects):
        stage.sun(-60, 50)
    for obj in scene.objects:
        if obj.type == "LIGHT" and obj.data.type == "SUN":
            obj.data.energy *= SUN


def can_denoise():
    """Whether this Blender's Cycles has a denoiser; asked to denoise without one, it renders nothing."""
    import _cycles  # of the add-on that is enabled by now

    return _cycles.with_openimagedenoise


def set_samples(scene, options):
    """Those of --samples; else those of a Blender file, or few where it is none."""
    keeps = model_files.is_blend(options.scene)
    if options.over == "cycles" and not (keeps and can_denoise()):
        scene.cycles.use_denoising = False
    samples = int(options.samples) if options.samples else None if keeps else SAMPLES.get(options.over)
    if samples and options.over == "cycles":
        scene.cycles.device, scene.cycles.samples = "CPU", samples
    if samples and options.over == "eevee":
        scene.eevee.taa_render_samples = samples
