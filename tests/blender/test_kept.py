# SPDX-License-Identifier: GPL-3.0-or-later
"""The memory limit: caches between pictures are bounded, least recently used items are evicted first, pictures do not
change."""

import gc
import json
import re
import subprocess
from pathlib import Path

import bpy
import numpy as np
import pytest
from measure_kept import ball, megabytes
from pictures import box_scene, drawn
from the_addon import part, use_style

kept, mesh_arrays = part("scene.kept"), part("scene.mesh_arrays")
preferences, session = part("ui.preferences"), part("render.session")


@pytest.fixture
def scene():
    """Four meshes, with lines that need curvature."""
    made = box_scene()
    for i in range(3):
        ball(f"Ball {i}", (2.0 * i - 2, 0, 0))
    use_style(made, "study")
    session.forget()
    gc.collect()
    yield made
    kept.set_limit(0)


def surfaces_kept():
    return sorted(
        entry.surface.name for reader in session.readers.values() for entry in reader.surfaces.entries.values()
    )


def test_within_the_limit_all_is_kept_and_beyond_it_nothing_more_than_it(scene, tmp_path):
    first = drawn(scene, tmp_path / "a.png")
    whole = megabytes()
    assert whole > 10 and len(surfaces_kept()) == 4
    kept.set_limit(int(whole) + 1)
    again = drawn(scene, tmp_path / "b.png")
    assert len(surfaces_kept()) == 4 and session.readers["RENDER"].surfaces.rebuilt == []
    kept.set_limit(int(0.5 * whole))
    assert 0 < megabytes() <= 0.5 * whole, "at once"
    bounded = drawn(scene, tmp_path / "c.png")
    assert 0 < megabytes() <= 0.5 * whole, "and after each picture"
    kept.set_limit(1)
    alone = drawn(scene, tmp_path / "d.png")
    assert megabytes() <= 1
    assert all(np.array_equal(first, other) for other in (again, bounded, alone))


def test_what_large_meshes_are_read_into_makes_room_for_what_is_computed_of_them(scene, tmp_path, monkeypatch):
    monkeypatch.setattr(mesh_arrays.Buffers, "MOST_BESIDE_SURFACES", 0)
    drawn(scene, tmp_path / "a.png")
    surfaces = session.readers["RENDER"].surfaces
    assert len(surfaces.rebuilt) == 4 and surfaces.buffers.nbytes == 0
    drawn(scene, tmp_path / "b.png")
    assert surfaces.rebuilt == [] and surfaces.buffers.nbytes > 0, "the next frame reads into them, too"


def test_the_longest_unused_goes_first(scene, tmp_path):
    drawn(scene, tmp_path / "a.png")
    entries = session.readers["RENDER"].surfaces.entries
    order = [entry.surface.name for entry in sorted(entries.values(), key=lambda entry: entry.used)]
    kept.set_limit(int(0.75 * megabytes()))
    assert 1 < len(surfaces_kept()) < 4 and surfaces_kept() == sorted(order[-len(surfaces_kept()) :])


@pytest.mark.parametrize("name", ["plain", "study"])
def test_what_is_reckoned_is_what_is_given_back(name):
    script = Path(__file__).with_name("measure_kept.py")
    command = [bpy.app.binary_path, "-b", "--python-exit-code", "1", "-P", str(script), "--", name]
    ran = subprocess.run(command, capture_output=True, text=True, timeout=300)
    told = re.search(r"MEASURED (\{.*\})", ran.stdout)
    assert told, ran.stdout + ran.stderr
    found = json.loads(told[1])
    # Allocators hold on to some of it for what comes next, and free pages that what was kept shared with it.
    assert 0.25 * found["reckoned"] < found["back"] < 1.5 * found["reckoned"], found


def test_images_of_materials_count_and_go(scene, tmp_path):
    held = use_style(scene, "watercolor")
    image = bpy.data.images.new("Large", 1024, 1024)
    material = bpy.data.materials.new("Painted")
    material.use_nodes = True
    node = material.node_tree.nodes.new("ShaderNodeTexImage")
    node.image = image
    shader = next(n for n in material.node_tree.nodes if n.type == "BSDF_PRINCIPLED")
    material.node_tree.links.new(node.outputs["Color"], shader.inputs["Base Color"])
    mesh = bpy.data.objects["Box"].data
    mesh.uv_layers.new()
    mesh.materials.append(material)
    assert held.color.shading != "PLAIN"
    first = drawn(scene, tmp_path / "a.png")
    colors = session.readers["RENDER"].colors
    assert colors.items(set())[0].size == 4 * 1024 * 1024 * 4 // 3
    kept.set_limit(1)
    gc.collect()
    kept.trim()
    assert colors.items(set())[0].size == 0
    assert np.array_equal(first, drawn(scene, tmp_path / "b.png"))


def test_what_a_snapshot_needs_stays(scene, tmp_path):
    read = part("render.reading").Reader()
    depsgraph = bpy.context.evaluated_depsgraph_get()
    found = read.read(depsgraph, part("render.properties").style_of(scene))
    kept.set_limit(1)
    assert len(read.surfaces.entries) == 4, "somebody still looks at it"
    del found
    gc.collect()
    kept.trim()
    assert len(read.surfaces.entries) == 0


def test_the_preference_sets_the_limit(scene):
    told = preferences.FoveaPreferences.bl_rna.properties["memory_limit"]
    assert told.default == 0 and "0: no limit" in told.description

    class Wanted:
        log_level, threads, memory_limit = "WARNING", 0, 7

    preferences.apply(Wanted)
    assert kept.limit == 7 * kept.MEGABYTE
