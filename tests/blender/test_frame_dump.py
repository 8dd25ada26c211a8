# SPDX-License-Identifier: GPL-3.0-or-later
"""`fovea draw --dump` writes the intermediate arrays of a picture: the members of its Frame, by their names."""

import sys
from pathlib import Path

import bpy
import numpy as np
import pytest
from pictures import box_scene
from the_addon import own_style, part

sys.path.insert(0, str(Path(__file__).parents[2] / "blender_scripts"))

import draw
import frame_dump

as_rendered, session, pipeline, style = (
    part(name) for name in ("render.as_rendered", "render.session", "pipeline", "style")
)


def file_of(folder, elision=False, focus=False):
    """A box that is drawn in pixels of sampled visibility, as a file; the words that draw it."""
    scene = box_scene()
    own_style(scene).elision.enabled = elision
    if focus:
        scene.fovea.focus_model, scene.fovea.focus_place = "IMAGE", (0.4, 0.5)
    blend = folder / "box.blend"
    bpy.ops.wm.save_as_mainfile(filepath=str(blend))
    return [str(blend), "-o", str(folder / "box.png")]


def dumped(folder, *words, **how):
    path = folder / "frame.npz"
    draw.main([*file_of(folder, **how), "--dump", str(path), *words])
    with np.load(path, allow_pickle=False) as file:
        return {name: file[name] for name in file.files}


def frame_of_scene():
    """The Frame of a final render of the scene that is open, and its Style."""

    def make(found, seen, chosen, backend, options, tell, cancel, near):
        beside = {"colors": found.colors, "notes": found.notes}
        frame = pipeline.frame(found.placed, seen, chosen, backend, options, **beside)
        frame.ink()
        return frame, chosen

    return as_rendered.look(bpy.context, lambda *render: session.final(*render, make)[1])


@pytest.mark.parametrize("visibility", ["exact", "atlas"])
def test_a_dump_has_the_numbers_of_the_frame_that_is_drawn(tmp_path, visibility):
    found = dumped(tmp_path, "--visibility", visibility, elision=True, focus=True)
    frame, chosen = frame_of_scene()
    for whole, members in {
        "view": ("world_to_view", "width", "height", "reference_scale"),
        "options": ("visibility", "probes", "spur"),
        "paths": ("points_obj", "offsets", "ids"),
        "clipped": ("px", "offsets", "path", "samples"),
        "visible": ("piece", "start_px", "end_px", "invisibility"),
        "runs": ("piece", "start_px", "end_px", "invisibility"),
        "drawn": ("piece", "start_px", "end_px", "invisibility"),
        "strokes": ("px", "triangles", "half_width", "opacity", "pen", "count"),
    }.items():
        for member in members:
            wanted = getattr(getattr(frame, whole), member)
            np.testing.assert_array_equal(found[f"{whole}.{member}"], wanted, f"{whole}.{member}")
    np.testing.assert_array_equal(found["shown"], frame.shown)
    np.testing.assert_array_equal(found["focus"], frame.focus)
    assert ("samples" in found) == (frame.samples is not None) == (visibility == "atlas")
    assert style.parse(str(found["style"])) == chosen
    assert {f"stages.{stage}" for stage in frame.stages} <= found.keys()
    assert found["strokes.count"] == session.last_statistics()["strokes"] > 0


def test_a_dump_tells_where_points_of_its_paths_are_in_the_picture(tmp_path):
    found = dumped(tmp_path)
    clip = np.c_[found["clipped.position_view"], np.ones(len(found["clipped.px"]))] @ found["view.view_to_clip"].T
    size = found["view.width"], found["view.height"]
    np.testing.assert_allclose((clip[:, :2] / clip[:, 3:] + 1) / 2 * size, found["clipped.px"], atol=1e-2)
    assert found["objects"].tolist() == ["Box"]


def test_what_a_frame_has_not_is_not_in_its_dump(tmp_path):
    found = dumped(tmp_path)
    assert not {"shown", "samples", "focus"} & found.keys()
    assert all(array.dtype.kind in "biufU" for array in found.values())


def test_every_frame_has_a_dump(tmp_path):
    draw.main([*file_of(tmp_path), "--dump", str(tmp_path / "frame.npz"), "--frames", "3-4"])
    names = {path.name for path in tmp_path.iterdir()} - {"box.blend"}
    assert names == {"box_0003.png", "box_0004.png", "frame_0003.npz", "frame_0004.npz"}


def test_a_dump_is_there_when_the_picture_fails(tmp_path, monkeypatch):
    def fail(scene, path):
        raise ValueError("no picture")

    monkeypatch.setattr(draw.picture, "render", fail)
    with pytest.raises(ValueError, match="no picture"):
        dumped(tmp_path)
    with np.load(tmp_path / "frame.npz", allow_pickle=False) as file:
        assert file["strokes.count"] > 0


def test_a_dump_that_cannot_be_written_leaves_what_was_there(tmp_path, monkeypatch):
    def fail(path, **arrays):
        Path(path).write_bytes(b"PK half of it")
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(frame_dump.np, "savez_compressed", fail)
    (tmp_path / "frame.npz").write_text("old")
    with pytest.raises(ValueError, match="frame.npz could not be written .No space left"):
        dumped(tmp_path)
    assert (tmp_path / "frame.npz").read_text() == "old" and len(list(tmp_path.glob("*.npz"))) == 1
