# SPDX-License-Identifier: GPL-3.0-or-later
"""`fovea draw` takes every model that Blender imports, with the axes and the scale of Blender's importers."""

import sys
from pathlib import Path

import bpy
import numpy as np
import pytest
from pictures import SIZE, pixels_of
from the_addon import box_mesh, new_object

sys.path.insert(0, str(Path(__file__).parents[2] / "blender_scripts"))

import draw
import framing
import scene_source
from command import model_files

EXPORTERS = {  # suffix -> the operators that write such files, and their options
    ".obj": (("wm.obj_export",), {}),
    ".ply": (("wm.ply_export",), {}),
    ".stl": (("wm.stl_export",), {}),
    ".gltf": (("export_scene.gltf",), {"export_format": "GLTF_SEPARATE"}),
    ".glb": (("export_scene.gltf",), {"export_format": "GLB"}),
    ".fbx": (("export_scene.fbx",), {}),
    ".usd": (("wm.usd_export",), {}),
    ".usda": (("wm.usd_export",), {}),
    ".usdc": (("wm.usd_export",), {}),
    ".usdz": (("wm.usd_export",), {}),
    ".abc": (("wm.alembic_export",), {}),
}
SVG = """<svg xmlns="http://www.w3.org/2000/svg" width="90mm" height="60mm" viewBox="0 0 90 60">
<path d="M 0 0 H 90 V 60 H 0 Z M 30 20 V 40 H 60 V 20 Z" fill="#000000"/></svg>"""


def bounds():
    points = framing.visible_points(bpy.context.evaluated_depsgraph_get())
    return np.array([points.min(axis=0), points.max(axis=0)])


def exported(path):
    """Writes a brick that no axis is like another of, and returns its bounds; skips without an exporter."""
    names, options = EXPORTERS[path.suffix.lower()]
    exporter = next(filter(None, map(scene_source.operator, names)), None)
    if not exporter:
        pytest.skip(f"this Blender exports no {path.suffix} files")
    bpy.ops.wm.read_homefile(use_empty=True)
    brick = new_object(box_mesh(), "Brick")
    brick.location, brick.scale = (1, 2, 3), (0.5, 1.5, 0.25)
    bpy.context.view_layer.update()
    made = bounds()
    assert exporter(filepath=str(path), **options) == {"FINISHED"}
    return made


@pytest.mark.parametrize("suffix", [name for name in model_files.IMPORTERS if name != ".svg"])
def test_a_model_stands_where_its_scene_had_it(tmp_path, suffix):
    path = tmp_path / f"brick{suffix}"
    made = exported(path)
    scene_source.open_scene(str(path))
    assert np.allclose(bounds(), made, atol=1e-4)


def test_texture_seams_of_gltf_are_no_borders(tmp_path):
    path = tmp_path / "ball.glb"
    bpy.ops.wm.read_homefile(use_empty=True)
    bpy.ops.mesh.primitive_uv_sphere_add(segments=16, ring_count=8)
    bpy.ops.object.shade_smooth()
    assert bpy.ops.export_scene.gltf(filepath=str(path)) == {"FINISHED"}
    scene_source.open_scene(str(path))
    (ball,) = bpy.data.meshes
    faces_at = np.bincount([corner.edge_index for corner in ball.loops], minlength=len(ball.edges))
    assert len(ball.edges) and (faces_at == 2).all()


@pytest.mark.parametrize("name", ["brick.glb", "BRICK.STL"])
def test_a_model_is_drawn(tmp_path, name):
    path, picture = tmp_path / name, tmp_path / "brick.png"
    exported(path)
    draw.main([str(path), "--size", f"{SIZE[0]}x{SIZE[1]}", "-o", str(picture)])
    pixels = pixels_of(picture)
    assert pixels.shape[:2] == SIZE[::-1] and pixels[..., :3].min() < 0.9


def test_shapes_of_an_svg_are_surfaces_with_holes(tmp_path):
    if not scene_source.operator("import_curve.svg"):
        pytest.skip("this Blender imports no .svg files")
    path = tmp_path / "frame.svg"
    path.write_text(SVG)
    scene_source.open_scene(str(path))
    low, high = bounds()
    assert np.allclose(high - low, (0.09, 0.06, 0), atol=1e-3)


@pytest.mark.parametrize("suffix", model_files.IMPORTERS)
def test_a_format_that_this_blender_lacks_is_one_sentence(tmp_path, suffix, monkeypatch):
    monkeypatch.setattr(scene_source, "operator", lambda name: None)
    with pytest.raises(ValueError, match=f"model{suffix}: this Blender imports no {suffix} files"):
        scene_source.open_scene(str(tmp_path / f"model{suffix}"))


@pytest.mark.parametrize("suffix", model_files.IMPORTERS)
def test_a_broken_model_is_one_sentence_that_names_it(tmp_path, suffix):
    if not any(map(scene_source.operator, model_files.IMPORTERS[suffix])):
        pytest.skip(f"this Blender imports no {suffix} files")
    path = tmp_path / f"broken{suffix}"
    path.write_bytes(b"\x00\xff no model \x00" * 20)
    with pytest.raises(ValueError, match=f"broken{suffix}: (Blender cannot import|there is nothing in)") as error:
        draw.main([str(path), "-o", str(tmp_path / "none.png")])
    assert "Traceback" not in str(error.value) and "\n" not in str(error.value)
    assert not (tmp_path / "none.png").exists()


def test_an_svg_of_strokes_alone_is_drawn(tmp_path):
    if not scene_source.operator("import_curve.svg"):
        pytest.skip("this Blender imports no .svg files")
    path, picture = tmp_path / "strokes.svg", tmp_path / "strokes.png"
    path.write_text(SVG.replace('fill="#000000"', 'fill="none" stroke="#000000"'))
    draw.main([str(path), "--size", f"{SIZE[0]}x{SIZE[1]}", "-o", str(picture)])
    assert pixels_of(picture)[..., :3].min() < 0.9
