"""The render engine from outside: files that renders write, and what is said when there is nothing to write."""

import math
import os
import subprocess
import time
from types import SimpleNamespace

import bpy
import numpy as np
import pytest
from the_addon import add_camera, box_mesh, empty_scene, fovea, new_object, part

native = part("native")
session = part("blender.session")
SIZE = (160, 90)


@pytest.fixture
def scene():
    """A box before a camera, drawn with a plain pen."""
    scene = empty_scene()
    new_object(box_mesh(), "Box")
    add_camera()
    render = scene.render
    render.engine, render.resolution_x, render.resolution_y = "FOVEA", *SIZE
    render.dither_intensity = 0.0
    scene.view_settings.view_transform = "Standard"
    scene.fovea.style = "technical"
    scene.fovea.backend, scene.fovea.pen_width = "CPU", 30.0
    return scene


def drawn(scene, path):
    """(H, W, 4) of a PNG still, top row last."""
    scene.render.image_settings.file_format = "PNG"
    scene.render.image_settings.color_mode = "RGBA"
    scene.render.filepath = str(path)
    bpy.ops.render.render(write_still=True)
    return pixels_of(path)


def pixels_of(path):
    image = bpy.data.images.load(str(path))
    image.colorspace_settings.name = "Non-Color"
    pixels = np.empty(len(image.pixels), np.float32)
    image.pixels.foreach_get(pixels)
    width, height = image.size
    bpy.data.images.remove(image)
    return pixels.reshape(height, width, -1)


def ink(picture):
    """(H, W) how dark each pixel is."""
    return 1 - picture[..., :3].mean(axis=2)


def layered(scene, path):
    """Renders a multilayer EXR; {channel: (H, W)}, top row last."""
    settings = scene.render.image_settings
    if hasattr(settings, "media_type"):
        settings.media_type = "MULTI_LAYER_IMAGE"
    settings.file_format, settings.color_depth = "OPEN_EXR_MULTILAYER", "32"
    scene.render.filepath = str(path)
    bpy.ops.render.render(write_still=True)
    # Blender 5 writes each pass as a part of its own.
    info = subprocess.run(["oiiotool", "--info", "-v", "-a", str(path)], capture_output=True, text=True, check=True)
    lists = [line.split(":", 1)[1] for line in info.stdout.splitlines() if "channel list:" in line]
    found, one = {}, path.with_name("channel.exr")
    for index, names in enumerate(lists):
        for name in (name.split("(")[0].strip() for name in names.split(",")):
            pick = ["--subimage", str(index), "--ch", name, "--chnames", "R"]
            subprocess.run(["oiiotool", str(path), *pick, "-o", str(one)], check=True)
            found[name] = pixels_of(one)[..., 0]
    return found


def test_a_still_shows_the_box(scene, tmp_path):
    picture = drawn(scene, tmp_path / "still.png")
    assert picture.shape == (SIZE[1], SIZE[0], 4)
    assert (picture[..., 3] == 1).all()
    # White paper stays white, and a box seen from a corner has nine visible edges of solid ink.
    assert (picture[0] == 1).all() and (picture[-1] == 1).all()
    assert 0.01 < (ink(picture) > 0.9).mean() < 0.2
    statistics = session.last_statistics()
    assert statistics["triangles"] == 12 and statistics["strokes"] > 0 and statistics["backend"] == "cpu"
    assert statistics["lines_s"] > 0 and "visibility" in statistics["stages"]


def test_an_animation_writes_every_frame(scene, tmp_path):
    box = bpy.data.objects["Box"]
    box.keyframe_insert("location", frame=1)
    box.location.x = 1
    box.keyframe_insert("location", frame=3)
    scene.frame_start, scene.frame_end = 1, 3
    scene.render.image_settings.file_format = "PNG"
    scene.render.filepath = str(tmp_path / "frame_")
    bpy.ops.render.render(animation=True)
    frames = [pixels_of(tmp_path / f"frame_{number:04}.png") for number in (1, 2, 3)]
    assert all(ink(frame).max() > 0.9 for frame in frames)
    assert not np.array_equal(frames[0], frames[1]) and not np.array_equal(frames[1], frames[2])
    # The box moved, its mesh did not.
    assert session._caches["RENDER"].rebuilt == []


def test_markers_switch_the_camera(scene, tmp_path):
    near = scene.camera
    far = add_camera((20, -28, 16))
    for frame, camera in ((1, near), (2, far)):
        scene.timeline_markers.new("cut", frame=frame).camera = camera
    scene.frame_set(1)
    close = ink(drawn(scene, tmp_path / "near.png")).sum()
    scene.frame_set(2)
    assert ink(drawn(scene, tmp_path / "far.png")).sum() < 0.6 * close


def test_film_transparent(scene, tmp_path):
    opaque = drawn(scene, tmp_path / "opaque.png")
    scene.render.film_transparent = True
    clear = drawn(scene, tmp_path / "clear.png")
    assert (clear[0, :, 3] == 0).all()
    assert np.allclose(clear[..., 3], ink(opaque), atol=0.3)
    assert (clear[..., 3][ink(opaque) > 0.99] > 0.99).all()


@pytest.mark.parametrize("crop", [True, False])
def test_a_border_draws_a_part_of_the_full_frame(scene, tmp_path, crop):
    full = drawn(scene, tmp_path / "full.png")
    render = scene.render
    render.use_border, render.use_crop_to_border = True, crop
    render.border_min_x, render.border_max_x = 0.25, 0.75
    render.border_min_y, render.border_max_y = 0.3, 0.9
    part_drawn = drawn(scene, tmp_path / "part.png")
    rows, columns = slice(27, 81), slice(40, 120)
    if not crop:
        assert (part_drawn[0] == 0).all()
        part_drawn = part_drawn[rows, columns]
    assert part_drawn.shape == (54, 80, 4)
    assert np.abs(part_drawn - full[rows, columns]).max() < 0.05


def test_orthographic(scene, tmp_path):
    camera = scene.camera
    camera.data.type, camera.data.ortho_scale = "ORTHO", 4.0
    camera.location, camera.rotation_euler = (0, 0, 10), (0, 0, 0)
    picture = ink(drawn(scene, tmp_path / "above.png"))
    # A square two units wide, 4 units across the frame, seen from above: only its four sides.
    inside = picture[11:79, 46:114]
    assert picture[45, 40] > 0.9 and picture[45, 119] > 0.9 and picture[5, 80] > 0.9 and picture[84, 80] > 0.9
    assert inside.max() == 0


def test_half_the_percentage_is_half_the_size_of_the_same_drawing(scene, tmp_path):
    full = ink(drawn(scene, tmp_path / "full.png"))
    scene.render.resolution_percentage = 50
    half = ink(drawn(scene, tmp_path / "half.png"))
    assert half.shape == (45, 80)
    shrunk = full.reshape(45, 2, 80, 2).mean(axis=(1, 3))
    assert np.abs(half - shrunk).mean() < 0.03


def test_passes_in_a_multilayer_exr(scene, tmp_path):
    scene.view_layers[0].use_pass_z = True
    scene.camera.data.type = "ORTHO"
    scene.camera.location, scene.camera.rotation_euler = (0, 0, 10), (0, 0, 0)
    scene.fovea.paper_color = (0.5, 0.25, 0.75)
    channels = layered(scene, tmp_path / "passes.exr")
    named = {name.partition(".")[2]: values for name, values in channels.items()}
    assert {f"{p}.{c}" for p in ("Combined", "Lines") for c in "RGBA"} | {"Depth.Z"} == set(named)
    assert named["Depth.Z"][45, 80] == pytest.approx(9.0, rel=1e-5)
    assert named["Depth.Z"][0, 0] > 1e9
    assert named["Combined.G"][45, 80] == pytest.approx(0.25)
    lines = named["Lines.A"]
    assert lines[0, 0] == 0 and lines.max() > 0.99
    assert np.allclose(named["Combined.R"], 0.5 * (1 - lines) + named["Lines.R"], atol=1e-3)


def test_every_view_layer_is_drawn(scene, tmp_path):
    bpy.ops.scene.view_layer_add()
    collection = bpy.data.collections.new("Second")
    scene.collection.children.link(collection)
    new_object(box_mesh(0.5), "Small", (1, -2, 1), collection)
    scene.view_layers[0].layer_collection.children["Second"].exclude = True
    channels = layered(scene, tmp_path / "layers.exr")
    first, second = (channels[f"{layer.name}.Lines.A"] for layer in scene.view_layers)
    assert first.max() > 0.9 and second.max() > 0.9 and not np.array_equal(first, second)


def test_a_holdout_hides_and_cuts_a_hole(scene, tmp_path):
    front = new_object(box_mesh(0.2), "Front", scene.camera.location * 0.5)
    front.is_holdout = True
    picture = drawn(scene, tmp_path / "hole.png")
    assert picture[45, 80, 3] == 0
    assert picture[0, 0, 3] == 1
    assert ink(picture)[picture[..., 3] == 1].max() > 0.9


ERRORS = {
    "no camera": (lambda scene: bpy.data.objects.remove(scene.camera), "no camera"),
    "panoramic": (lambda scene: setattr(scene.camera.data, "type", "PANO"), "panoramic"),
    "empty": (lambda scene: bpy.data.objects.remove(bpy.data.objects["Box"]), "empty"),
}


@pytest.mark.parametrize("case", ERRORS)
def test_what_cannot_be_drawn_is_said_and_writes_no_file(scene, tmp_path, case, caplog):
    spoil, words = ERRORS[case]
    spoil(scene)
    with pytest.raises(RuntimeError, match=f"(?i){words}"):
        drawn(scene, tmp_path / "none.png")
    assert not (tmp_path / "none.png").exists()
    assert not caplog.records


def test_a_missing_native_module_is_said(scene, tmp_path, monkeypatch):
    def missing():
        raise native.Unavailable("the native module is missing")

    monkeypatch.setattr(native, "load", missing)
    with pytest.raises(RuntimeError, match="native module is missing"):
        drawn(scene, tmp_path / "none.png")


def test_any_other_failure_is_said_too(scene, tmp_path, monkeypatch, caplog):
    def broken(*_arguments, **_options):
        raise ValueError("ink ran out")

    monkeypatch.setattr(session.pipeline, "draw", broken)
    with pytest.raises(RuntimeError, match="ValueError: ink ran out"):
        drawn(scene, tmp_path / "none.png")
    assert not (tmp_path / "none.png").exists()
    assert "ink ran out" in caplog.text


def test_a_scene_whose_objects_are_all_hidden_is_blank_paper(scene, tmp_path):
    bpy.data.objects["Box"].hide_render = True
    assert (drawn(scene, tmp_path / "blank.png") == 1).all()


def test_nan_vertices_are_left_out(scene, tmp_path):
    bpy.data.objects["Box"].data.vertices[0].co.x = math.nan
    picture = drawn(scene, tmp_path / "broken.png")
    assert ink(picture).max() > 0.9


def test_what_was_left_out_is_said_once():
    said = []
    engine = SimpleNamespace(report=lambda kind, message: said.append((kind, message)))
    report = {"degenerate_polygons": 3, "loose_edges": 0, "non_finite_vertices": 1}
    session._report_skipped(engine, [SimpleNamespace(name="Box", report=report)])
    ((kind, message),) = said
    assert kind == {"INFO"} and "'Box'" in message and "3 faces have no area" in message and "loose" not in message


class StoppedEngine:
    """An engine whose user pressed Escape."""

    backend = None

    def __init__(self):
        self.asked = 0

    def test_break(self):
        self.asked += 1
        return True

    def report(self, kind, message):
        raise AssertionError(message)

    def update_progress(self, share):
        pass

    update_stats = report


def test_cancel_reaches_what_runs_natively():
    cancel = native.load().Cancel()
    engine = StoppedEngine()
    with session._watched(engine, cancel):
        for _ in range(100):
            if cancel.requested:
                break
            time.sleep(0.02)
    assert cancel.requested and engine.asked == 1


def test_a_stopped_render_gives_no_picture(scene, monkeypatch):
    def stopped(*_arguments, cancel, **_options):
        raise native.load().Cancelled("cancelled")

    monkeypatch.setattr(session.pipeline, "draw", stopped)
    depsgraph = bpy.context.evaluated_depsgraph_get()
    view = part("stages").View(np.eye(4), np.eye(4), 4, 4, True, 0.1, 10.0)
    assert session._draw(StoppedEngine(), depsgraph, view) is None


def in_child(tmp_path, scene, environment):
    """Exit code, output and picture of `blender -b` that renders the scene's file."""
    blend, out = tmp_path / "scene.blend", tmp_path / "child_"
    scene.render.image_settings.file_format = "PNG"
    bpy.ops.wm.save_as_mainfile(filepath=str(blend))
    command = [bpy.app.binary_path, "-b", "--factory-startup", "--addons", fovea.__name__, str(blend)]
    command += ["-E", "FOVEA", "-o", str(out), "-f", "1"]
    kept = {key: value for key, value in os.environ.items() if not key.startswith("FOVEA_GL")}
    done = subprocess.run(command, env={**kept, **environment}, capture_output=True, text=True, timeout=300)
    return done.returncode, done.stdout + done.stderr, tmp_path / "child_0001.png"


def test_background_render_without_a_camera_fails(scene, tmp_path):
    bpy.data.objects.remove(scene.camera)
    code, output, picture = in_child(tmp_path, scene, {})
    assert code != 0 and not picture.exists()
    assert "no camera" in output and "Traceback" not in output


def test_background_render_without_opengl_uses_the_cpu(scene, tmp_path):
    scene.fovea.backend = "GPU"
    code, output, picture = in_child(tmp_path, scene, {"__EGL_VENDOR_LIBRARY_FILENAMES": "/nonexistent"})
    assert code == 0, output
    assert ink(pixels_of(picture)).max() > 0.9
