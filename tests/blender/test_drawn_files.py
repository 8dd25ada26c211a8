# SPDX-License-Identifier: GPL-3.0-or-later
"""`fovea draw FILE.blend` draws what F12 renders, whatever the file's output settings and the reports on opening it."""

import struct
import sys
from pathlib import Path

import bpy
import pytest
from pictures import SIZE, box_scene, pixels_of
from the_addon import new_object, part

sys.path.insert(0, str(Path(__file__).parents[2] / "blender_scripts"))

import draw
import ending
import scene_source
from command import draw_options, quantities

properties, style = part("render.properties"), part("style")

CHANNEL = 77  # a number that is easily found


def saved(path):
    bpy.ops.wm.save_as_mainfile(filepath=str(path), compress=False)
    return str(path)


def to_video(render):
    if "media_type" in render.image_settings.bl_rna.properties:
        render.image_settings.media_type = "VIDEO"
    render.image_settings.file_format = "FFMPEG"


def to_layers(render):
    if "media_type" in render.image_settings.bl_rna.properties:
        render.image_settings.media_type = "MULTI_LAYER_IMAGE"
    render.image_settings.file_format = "OPEN_EXR_MULTILAYER"


def to_stereo(render):
    render.use_multiview = True


@pytest.mark.parametrize("suffix", [".png", ".exr"])
@pytest.mark.parametrize("set_output", [to_video, to_layers, to_stereo])
def test_a_file_is_drawn_to_a_picture_whatever_its_output_is(tmp_path, set_output, suffix):
    set_output(box_scene().render)
    blend, path = saved(tmp_path / "box.blend"), tmp_path / f"box{suffix}"
    draw.main([blend, "-o", str(path)])
    assert sorted(p.name for p in tmp_path.iterdir()) == ["box.blend", path.name]
    assert pixels_of(path).shape[:2] == SIZE[::-1]


def test_a_file_is_drawn_though_opening_it_reports_an_error(tmp_path, capfd):
    scene = box_scene()
    editor = scene.sequence_editor_create()
    length = {"length": 5} if bpy.app.version >= (5, 0, 0) else {"frame_end": 6}
    (editor.strips if hasattr(editor, "strips") else editor.sequences).new_effect(
        "Zebra", "COLOR", CHANNEL, 1, **length
    )
    blend, path = tmp_path / "strip.blend", tmp_path / "strip.png"
    saved(blend)
    data = bytearray(blend.read_bytes())
    channel = data.index(struct.pack("<i", CHANNEL), data.index(b"SQZebra\0"))
    struct.pack_into("<i", data, channel, 7777)  # beyond what Blender reads
    blend.write_bytes(data)
    draw.main([str(blend), "-o", str(path)])
    assert "Error: 1 sequence strips were not read" in capfd.readouterr().out
    assert pixels_of(path).shape[:2] == SIZE[::-1]


def test_a_style_is_that_of_a_name_or_of_a_file(tmp_path):
    paper = style.Paper(color=(0.25, 0.5, 0.75))
    (tmp_path / "my own.json").write_text(style.dump(style.load("charcoal").replace(paper=paper)), encoding="utf-8")
    drawn = []
    for words in ("charcoal", str(tmp_path / "my own.json")):
        draw.main(["boxes:1", "--size", "64x36", "--style", words, "-o", str(tmp_path / "a.png")])
        drawn.append(properties.style_of(bpy.context.scene))
    assert drawn[1] == drawn[0].replace(paper=paper) and drawn[1] != drawn[0]
    with pytest.raises(style.StyleError, match="none.json cannot be read: No such file"):
        draw.main(["boxes:1", "--style", str(tmp_path / "none.json"), "-o", str(tmp_path / "a.png")])


def test_what_is_no_blend_file_is_refused(tmp_path):
    blend = tmp_path / "text.blend"
    blend.write_text("no blend file")
    with pytest.raises(RuntimeError, match="text.blend"):
        draw.main([str(blend), "-o", str(tmp_path / "none.png")])
    assert not (tmp_path / "none.png").exists()


def test_scripts_of_a_file_are_not_run(tmp_path):
    box_scene()
    ran = tmp_path / "ran"
    text = bpy.data.texts.new("start.py")
    text.write(f"open({str(ran)!r}, 'w')")
    text.use_module = True
    blend = saved(tmp_path / "script.blend")
    bpy.ops.wm.open_mainfile(filepath=blend, use_scripts=True)  # from now on scripts run unless it is said otherwise
    assert ran.exists()
    ran.unlink()
    scene_source.open_scene(blend)
    assert not ran.exists()


@pytest.mark.parametrize("words", [["-o", "x.png"], ["-o", "x.svg"], ["-o", "x.ora"], ["--dump", "x.npz"]])
def test_what_cannot_be_drawn_is_one_sentence_whatever_is_written(tmp_path, monkeypatch, words):
    data = box_scene().camera.data
    data.clip_start, data.clip_end = 200.0, 100.0
    blend = saved(tmp_path / "behind.blend")
    (out := tmp_path / "out").mkdir()
    monkeypatch.chdir(out)
    monkeypatch.setattr("sys.argv", ["blender", "--", blend, *words])
    with pytest.raises(SystemExit, match="^fovea: [^\n]*[Cc]lip"):
        ending.run(draw.main)
    assert not list(out.iterdir())


def test_a_lens_is_refused_where_the_scene_is_seen_from_no_camera(tmp_path):
    scene = box_scene()
    scene.camera = new_object(None, "Empty")
    blend = saved(tmp_path / "empty.blend")
    with pytest.raises(ValueError, match="'Empty', which the scene is seen from, is no camera"):
        draw.main([blend, "--lens", "35", "-o", str(tmp_path / "none.png")])


def test_numbers_are_refused_that_blender_would_change():
    sides = (bpy.types.RenderSettings.bl_rna.properties[name] for name in ("resolution_x", "resolution_y"))
    assert {(side.hard_min, side.hard_max) for side in sides} == {quantities.FRAME_SIDES}
    assert bpy.types.Scene.bl_rna.properties["frame_current"].hard_max == quantities.LAST_FRAME
    lens = bpy.types.Camera.bl_rna.properties["lens"]
    assert (lens.hard_min, lens.soft_max) == draw_options.LENSES
