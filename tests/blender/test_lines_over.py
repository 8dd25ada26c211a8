# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines over photographs: they lie on the outlines of what another engine renders, in every way to render."""

import subprocess

import bpy
import numpy as np
import pytest
from photographs import (
    AWAY,
    EEVEE,
    ENGINES,
    FOCAL,
    MIDDLE,
    RADIUS,
    edge,
    lines_over,
    middle,
    outlines,
    parts,
    photograph,
    profile,
    with_lines,
)
from pictures import drawn, pixels_of
from the_addon import box_mesh, fovea, new_object, part

lines_scenes, check = part("render.lines_scenes"), part("render.lines_over_check")
NEAR = 0.5  # pixels that a line may be off


@pytest.fixture(params=ENGINES)
def scene(request):
    return photograph(request.param)


@pytest.fixture
def cycles():
    return photograph("CYCLES")


@pytest.mark.parametrize("engine", (*ENGINES, EEVEE))
def test_lines_and_photograph_lie_where_the_closed_form_has_the_outlines(engine, tmp_path):
    scene = photograph(engine)
    photo, _ = parts(drawn(scene, tmp_path / "photo.png"))
    assert bpy.ops.fovea.lines_over() == {"FINISHED"}
    lines = with_lines(scene, tmp_path / "both.png")
    known = list(outlines())
    off = [edge(profile(photo, kind, i), at, before) - at for kind, i, at, before in known]
    lines_off = [middle(profile(lines, kind, i), at) - at for kind, i, at, _ in known]
    assert len(known) > 150 and np.abs(off).max() < NEAR and np.abs(lines_off).max() < NEAR
    assert np.abs(np.subtract(off, lines_off)).max() < NEAR


def both(scene, path):
    """The picture of the scene with lines."""
    bpy.ops.fovea.lines_over()
    return drawn(scene, path)


def test_a_still_a_frame_of_the_command_line_and_of_an_animation_are_the_same_picture(cycles, tmp_path):
    still = both(cycles, tmp_path / "still.png")
    cycles.frame_start = cycles.frame_end = cycles.frame_current
    cycles.render.filepath = str(tmp_path / "animation_####")
    bpy.ops.render.render(animation=True)
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "scene.blend"))
    in_another_blender(tmp_path / "scene.blend", tmp_path / "frame_####")
    for name in ("animation_0001.png", "frame_0001.png"):
        assert np.abs(pixels_of(tmp_path / name) - still).max() < 0.01


def in_another_blender(file, output, addons=fovea.__name__):
    """Renders frame 1 of a file; what Blender prints."""
    command = [bpy.app.binary_path, "-b", "--factory-startup", "--addons", addons, str(file)]
    command += ["-o", str(output), "-F", "PNG", "-f", "1"]
    return subprocess.run(command, capture_output=True, text=True, errors="replace", check=True).stdout


def test_without_the_extension_the_photograph_is_intact(cycles, tmp_path):
    photo = drawn(cycles, tmp_path / "photo.png")
    bpy.ops.fovea.lines_over()
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "scene.blend"))
    in_another_blender(tmp_path / "scene.blend", tmp_path / "frame_####", addons="cycles")
    assert np.abs(pixels_of(tmp_path / "frame_0001.png") - photo).max() < 0.01


def counts():
    trees = sum(len(tree.nodes) for tree in bpy.data.node_groups if tree.bl_idname == "CompositorNodeTree")
    tree = getattr(bpy.context.scene, "node_tree", None)
    return len(bpy.data.scenes), trees, len(tree.nodes) if tree else 0


def test_removing_leaves_what_was_there_before(scene, tmp_path):
    photo, before = drawn(scene, tmp_path / "photo.png"), counts()
    bpy.ops.fovea.lines_over()
    assert counts() != before and lines_over.is_on(scene)
    assert bpy.ops.fovea.lines_over_remove() == {"FINISHED"}
    assert counts() == before and not lines_over.is_on(scene)
    assert np.array_equal(drawn(scene, tmp_path / "again.png"), photo)
    assert bpy.ops.fovea.lines_over() == bpy.ops.fovea.lines_over_remove() == {"FINISHED"} and counts() == before


def test_one_step_of_undo_takes_the_lines_away(cycles):
    before = counts()
    bpy.ops.ed.undo_push(message="before")
    bpy.ops.fovea.lines_over()
    bpy.ops.ed.undo_push(message="lines")
    bpy.ops.ed.undo()
    assert counts() == before and not lines_over.is_on(bpy.context.scene)
    bpy.ops.ed.redo()
    assert lines_over.is_on(bpy.context.scene) and list(check.problems(bpy.context.scene)) == []


@pytest.mark.parametrize("projection", ["PERSP", "ORTHO"])
def test_both_eyes_of_a_stereo_pair_have_their_lines(cycles, tmp_path, projection):
    cycles.cycles.samples, cycles.render.use_multiview = 4, True
    camera = cycles.camera.data
    camera.type, camera.ortho_scale = projection, 7.2
    camera.stereo.interocular_distance, camera.stereo.convergence_distance = 0.3, 20
    for obj in cycles.objects:
        obj.hide_render = obj.name.startswith("Box")
    bpy.ops.fovea.lines_over()
    cycles.render.filepath = str(tmp_path / "pair.png")
    cycles.render.image_settings.file_format = "PNG"
    bpy.ops.render.render(write_still=True)
    at = []
    for side in "LR":
        photo, lines = parts(pixels_of(tmp_path / f"pair_{side}.png"))
        columns = np.arange(len(lines[0])) + 0.5
        at.append([np.average(columns, weights=each.sum(axis=0)) for each in (photo, lines)])
    (photo_left, lines_left), (photo_right, lines_right) = at
    assert abs(photo_left - photo_right) > 1
    assert lines_right - lines_left == pytest.approx(photo_right - photo_left, abs=NEAR)


def a_border(scene):
    render = scene.render
    render.use_border = True
    render.border_min_x, render.border_max_x, render.border_min_y, render.border_max_y = 0.2, 0.55, 0.1, 0.9


def a_cropped_border(scene):
    a_border(scene)
    scene.render.use_crop_to_border = True


def another_size(scene):
    scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = 240, 130, 80


def a_camera_of_a_marker(scene):
    other = scene.camera.copy()
    other.data = other.data.copy()
    other.data.lens, other.location.x = 40, 0.5
    scene.collection.objects.link(other)
    scene.timeline_markers.new("first", frame=-5).camera = scene.camera
    scene.timeline_markers.new("other", frame=1).camera = other


def a_keyed_camera(scene):
    scene.camera.keyframe_insert("location", frame=1)
    scene.camera.location.x = 2
    scene.camera.keyframe_insert("location", frame=5)
    scene.frame_set(3)


def a_later_object(scene):
    new_object(box_mesh(0.4), "Later", (0, -1, 1.4)).data.materials.append(bpy.data.materials["White"])


def an_excluded_collection(scene):
    hidden = bpy.data.collections.new("Hidden")
    scene.collection.children.link(hidden)
    new_object(box_mesh(0.4), "Later", (0, -1, 1.4), hidden)
    scene.view_layers[0].layer_collection.children["Hidden"].exclude = True


def stretched_pixels(scene):
    scene.render.pixel_aspect_x = 1.5


def a_shifted_lens(scene):
    scene.camera.data.shift_x, scene.camera.data.type = 0.1, "ORTHO"
    scene.camera.data.ortho_scale = 7


def a_background_set(scene):
    scene.background_set = bpy.data.scenes.new("Stage")
    box = new_object(box_mesh(0.4), "Later", (0, -1, 1.4), scene.background_set.collection)
    box.data.materials.append(bpy.data.materials["White"])


def a_linked_collection(scene):
    """Of another file, with an instance, and the object itself as an override that is elsewhere."""
    made = bpy.data.collections.new("Linked")
    new_object(box_mesh(0.3), "Linked", (0, 0, 0), made)
    file = f"{bpy.app.tempdir}linked.blend"
    bpy.data.libraries.write(file, {made})
    bpy.data.objects.remove(bpy.data.objects["Linked"])
    bpy.data.collections.remove(made)
    with bpy.data.libraries.load(file, link=True) as (_, wanted):
        wanted.collections = ["Linked"]
    (linked,) = wanted.collections
    instance = bpy.data.objects.new("Instance", None)
    instance.instance_type, instance.instance_collection = "COLLECTION", linked
    instance.location = 0, -2, 1.2
    scene.collection.objects.link(instance)
    scene.collection.children.link(linked)
    linked.override_hierarchy_create(scene, scene.view_layers[0]).objects[0].location = 1.2, -2, 1.2


CHANGES = (
    (a_border, a_later_object),
    (a_cropped_border, a_camera_of_a_marker, an_excluded_collection),
    (another_size, a_keyed_camera, stretched_pixels),
    (a_shifted_lens, a_background_set, a_linked_collection),
)


@pytest.mark.parametrize("changes", CHANGES, ids=lambda changes: "-".join(change.__name__ for change in changes))
def test_lines_follow_what_changes_after_the_click(cycles, tmp_path, changes):
    """They are those of a render by Fovea itself."""
    cycles.cycles.samples = 4
    bpy.ops.fovea.lines_over()
    for change in changes:
        change(cycles)
    alpha = with_lines(cycles, tmp_path / "both.png")
    bpy.ops.fovea.lines_over_remove()
    cycles.render.engine, cycles.render.film_transparent = "FOVEA", True
    own = drawn(cycles, tmp_path / "own.png")[..., 3]
    assert alpha.shape == own.shape and own.sum() > 20
    assert np.abs(alpha - own).max() < 0.02


def test_opacity_and_blend_can_be_keyed(cycles, tmp_path):
    part("style.style_data").of(cycles).fovea.line_sets[-1].pen.color = (0.25, 0, 0)
    cycles.cycles.samples = 4
    full = both(cycles, tmp_path / "full.png")
    node = lines_over.node(cycles, lines_over.OVER)
    photo = drawn_without(cycles, node, tmp_path / "photo.png")
    opacity = node.inputs["Opacity"]
    for frame, value in ((1, 1.0), (11, 0.0)):
        opacity.default_value = value
        opacity.keyframe_insert("default_value", frame=frame)
    cycles.frame_set(6)
    half = drawn(cycles, tmp_path / "half.png")
    assert np.abs(half - (full + photo) / 2).max() < 0.02 < np.abs(full - photo).max()
    cycles.frame_set(1)
    assert np.abs(drawn(cycles, tmp_path / "again.png") - full).max() < 0.01
    assert cycles.fovea.lines_blend == "OVER"
    cycles.fovea.lines_blend = "MULTIPLY"
    darker = drawn(cycles, tmp_path / "multiplied.png")[..., :3]
    coverage = (photo - full)[..., 1]  # of lines on white
    white = photo[..., 1] > 0.999
    assert white.sum() > 1000 and np.abs(darker - full[..., :3])[white].max() < 0.02
    black = photo[..., :3].max(axis=2) == 0
    assert np.abs(darker[black]).max() < 0.01 < full[..., 0][black].max() and coverage.max() > 0.9


def drawn_without(scene, node, path):
    node.mute = True
    picture = drawn(scene, path)
    node.mute = False
    return picture


def test_the_nodes_of_an_own_compositor_stay_and_get_lines_over_their_picture(cycles, tmp_path):
    compositor = part("render.compositor")
    tree = compositor.make_tree(cycles)
    out = compositor.output(tree)
    gone = compositor.alpha_over(tree, out.links[0].from_socket, (0.0, 0.0, 1.0, 1.0), 0.5)
    tree.links.new(out, gone)
    names = {node.name for node in tree.nodes}
    blue = drawn(cycles, tmp_path / "blue.png")
    picture = both(cycles, tmp_path / "both.png")
    assert blue[0, 0, 2] > 0.45 and picture[0, 0, 2] > 0.45 and parts(picture)[1].max() > 0.9
    bpy.ops.fovea.lines_over_remove()
    assert {node.name for node in tree.nodes} == names
    assert np.abs(drawn(cycles, tmp_path / "again.png") - blue).max() < 0.01


def mute_the_nodes(scene):
    lines_over.node(scene, lines_over.OVER).mute = True


def remove_the_lines(scene):
    bpy.data.scenes.remove(lines_scenes.of(scene))


def remove_a_node(scene):
    part("render.compositor").tree(scene).nodes.remove(lines_over.node(scene, lines_over.LINES))


def unlink_the_lines(scene):
    tree, node = part("render.compositor").tree(scene), lines_over.node(scene, lines_over.OVER)
    tree.links.remove(node.inputs["Lines"].links[0])


def turn_compositing_off(scene):
    scene.render.use_compositing = False


def render_a_single_layer(scene):
    scene.render.use_single_layer = True


TROUBLES = (
    *(mute_the_nodes, remove_the_lines, remove_a_node, unlink_the_lines, turn_compositing_off, render_a_single_layer),
)


def test_what_keeps_lines_away_is_told_as_a_render_begins_and_repaired(cycles, tmp_path, capfd):
    cycles.cycles.samples = 1
    bpy.ops.fovea.lines_over()
    for trouble in TROUBLES:
        assert list(check.problems(cycles)) == []
        trouble(cycles)
        assert len(list(check.problems(cycles))) == 1, trouble.__name__
        if trouble is mute_the_nodes:
            drawn(cycles, tmp_path / "without.png")
            assert "Fovea draws no lines over 'Scene'" in capfd.readouterr().out
        assert bpy.ops.fovea.lines_over_repair() == {"FINISHED"}, trouble.__name__
    assert with_lines(cycles, tmp_path / "both.png").max() > 0.9


def test_vectors_with_every_render_are_of_the_lines_and_beside_the_picture(cycles, tmp_path):
    cycles.cycles.samples = 1
    cycles.fovea.vectors.kind, cycles.fovea.vectors.sheet = "SVG", "pixels"
    bpy.ops.fovea.lines_over()
    render_a_frame(cycles, tmp_path)
    assert sorted(file.name for file in tmp_path.iterdir()) == ["frame_0001.png", "frame_0001.svg"]
    text = (tmp_path / "frame_0001.svg").read_text()
    assert 'data-object="Sphere"' in text and "<rect" not in text and "<image" not in text, "lines alone"


def test_lines_that_cannot_be_drawn_leave_the_photograph_and_are_told(cycles, tmp_path, capfd):
    cycles.cycles.samples = 1
    bpy.ops.fovea.lines_over()
    cycles.camera.data.type = "PANO"
    drawn(cycles, tmp_path / "photo.png")
    assert "Fovea draws no lines over 'Scene': Camera 'Camera' is panoramic" in capfd.readouterr().out
    assert "panoramic" in lines_scenes.failure(cycles)
    cycles.camera.data.type = "PERSP"
    assert with_lines(cycles, tmp_path / "both.png").max() > 0.9 and lines_scenes.failure(cycles) is None


def test_farms_get_no_frame_that_lacks_its_lines(cycles, tmp_path, monkeypatch):
    whole = part("render.whole_frames")
    monkeypatch.setattr(whole, "exits", False)
    whole.switch_on()
    try:
        cycles.cycles.samples, cycles.camera.data.type = 1, "PANO"
        bpy.ops.fovea.lines_over()
        render_a_frame(cycles, tmp_path)
        (sentence,) = whole.failures
        assert "Frame 1 has no lines over it and is not kept: Camera 'Camera' is panoramic" in sentence
        assert not list(tmp_path.glob("*.png"))
    finally:
        whole.unregister()
        whole.failures.clear(), whole.finished.clear()


def render_a_frame(scene, folder):
    scene.frame_start = scene.frame_end = 1
    scene.render.filepath = str(folder / "frame_####")
    scene.render.image_settings.file_format = "PNG"
    bpy.ops.render.render(animation=True)


def test_lines_stay_after_the_file_is_reloaded_and_the_scene_renamed(cycles, tmp_path):
    before = both(cycles, tmp_path / "before.png")
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "scene.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "scene.blend"))
    scene = bpy.context.scene
    scene.name = "Renamed"
    assert list(check.problems(scene)) == []
    assert np.abs(drawn(scene, tmp_path / "after.png") - before).max() < 0.01


def test_a_keyed_style_and_focus_of_the_scene_are_those_of_the_frame(cycles, tmp_path):
    cycles.cycles.samples = 1
    pen = part("style.style_data").of(cycles).fovea.line_sets[-1].pen
    width = pen.width
    for frame, value in ((1, width), (3, 3 * width)):
        pen.width = value
        pen.keyframe_insert("width", frame=frame)
    bpy.ops.fovea.lines_over()
    covered = []
    for frame in (1, 3):
        cycles.frame_set(frame)
        covered.append(with_lines(cycles, tmp_path / f"{frame}.png").sum())
    assert 2 < covered[1] / covered[0] < 4


def test_line_thinning_smoothed_over_frames_finds_the_lines_of_each_once(cycles, tmp_path, monkeypatch):
    cycles.cycles.samples = 1
    style = part("style.style_data").of(cycles).fovea
    style.elision.enabled, style.elision.frames = True, 2
    a_keyed_camera(cycles)
    bpy.ops.fovea.lines_over()
    stills = {}
    for frame in (1, 2, 3):
        cycles.frame_set(frame)
        stills[frame] = drawn(cycles, tmp_path / f"still_{frame}.png")
    session, looked = part("render.session"), []
    look = session._look
    monkeypatch.setattr(session, "_look", lambda *given: looked.append(look(*given)) or looked[-1])
    cycles.frame_start, cycles.frame_end = 1, 3
    cycles.render.filepath = str(tmp_path / "animation_####.png")
    bpy.ops.render.render(animation=True)
    assert len(looked) == 3 + 4 - 1
    for frame, still in stills.items():
        assert np.array_equal(pixels_of(tmp_path / f"animation_{frame:04}.png"), still)


def test_a_compositor_that_several_scenes_share_is_copied(cycles):
    compositor = part("render.compositor")
    if not compositor.GROUPS:
        pytest.skip("scenes have compositors of their own in this Blender")
    tree, other = compositor.make_tree(cycles), bpy.data.scenes.new("Other")
    other.compositing_node_group = tree
    bpy.ops.fovea.lines_over()
    assert other.compositing_node_group == tree and lines_over.node(other, lines_over.OVER) is None
    assert lines_over.node(cycles, lines_over.OVER) is not None


def in_layers(scene):
    """Makes a scene of two view layers: the sphere, and the boxes, one of which lies behind the sphere. The compositor
    lays the first over the second. Gives the layers."""
    compositor = part("render.compositor")
    boxes = [obj for obj in scene.objects if obj.name.startswith("Box")]
    boxes[0].location = 0.9, 3, 0
    behind = bpy.data.collections.new("Behind")
    scene.collection.children.link(behind)
    for obj in boxes:
        scene.collection.objects.unlink(obj)
        behind.objects.link(obj)
    before = bpy.data.collections.new("Before")
    scene.collection.children.link(before)
    sphere = scene.objects["Sphere"]
    scene.collection.objects.unlink(sphere)
    before.objects.link(sphere)
    first, second = scene.view_layers[0], scene.view_layers.new("Second")
    first.layer_collection.children["Behind"].exclude = True
    second.layer_collection.children["Before"].exclude = True
    scene.render.film_transparent, scene.cycles.samples = True, 4
    tree = compositor.make_tree(scene)
    above, below = (compositor.rendered(tree, scene, layer.name).outputs["Image"] for layer in (first, second))
    tree.links.new(compositor.output(tree), compositor.alpha_over(tree, below, above))
    for node in [node for node in tree.nodes if node.type == "R_LAYERS" and not node.outputs["Image"].is_linked]:
        tree.nodes.remove(node)
    return first, second


def of_layer(layer):
    """Turns the lines over a view layer on or off."""
    with bpy.context.temp_override(view_layer=layer):
        assert bpy.ops.fovea.lines_over_layer() == {"FINISHED"}


def in_parts(lines):
    """Ink of lines (inside of the sphere, on its outline, beside it)."""
    y, x = np.indices(lines.shape)
    away = np.hypot(x + 0.5 - MIDDLE[0], y + 0.5 - MIDDLE[1])
    outline = FOCAL * RADIUS / np.sqrt(AWAY**2 - RADIUS**2)
    return [float(lines[part].sum()) for part in (away < outline - 3, abs(away - outline) <= 3, away > outline + 3)]


def test_each_view_layer_has_lines_over_its_own_picture_and_may_have_none(cycles, tmp_path):
    first, second = in_layers(cycles)
    assert bpy.ops.fovea.lines_over() == {"FINISHED"} and list(check.problems(cycles)) == []
    inside, outline, beside = in_parts(with_lines(cycles, tmp_path / "both.png"))
    assert inside == 0 and outline > 300 and beside > 300, "the sphere hides lines of the layer below"
    of_layer(second)
    alone = in_parts(with_lines(cycles, tmp_path / "first.png"))
    assert alone[1] == pytest.approx(outline, rel=0.1) and alone[2] == 0
    of_layer(first)
    assert not lines_over.is_on(cycles) and not lines_scenes.all_of(cycles)
    of_layer(second)
    inside, outline, again = in_parts(with_lines(cycles, tmp_path / "second.png"))
    assert inside == 0 and outline < 120 and again == pytest.approx(beside, rel=0.05)
    assert bpy.ops.fovea.lines_over_remove() == {"FINISHED"}
    assert with_lines(cycles, tmp_path / "none.png").max() == 0 and len(bpy.data.scenes) == 1


def test_lines_of_a_view_layer_follow_what_changes_and_may_have_a_style_of_their_own(cycles, tmp_path):
    _, second = in_layers(cycles)
    of_layer(second)
    cycles.view_layers[0].name, second.name = "Renamed", "Also renamed"
    _, _, beside = in_parts(with_lines(cycles, tmp_path / "two.png"))
    for collection in (cycles.collection, bpy.data.collections["Behind"]):
        where = (-2.4, 0, 1.6) if collection == cycles.collection else (2.4, 0, 1.6)
        new_object(box_mesh(0.3), "Later", where, collection).data.materials.append(bpy.data.materials["White"])
    _, _, more = in_parts(with_lines(cycles, tmp_path / "four.png"))
    assert more > 1.4 * beside
    second.layer_collection.children["Behind"].exclude = True
    _, _, left = in_parts(with_lines(cycles, tmp_path / "one.png"))
    assert 0 < left < 0.5 * beside
    second.layer_collection.children["Behind"].exclude = False
    lines, style_data = lines_scenes.of(cycles, second), part("style.style_data")
    lines.fovea.style = style_data.of(cycles).copy()
    pen = lines.fovea.style.fovea.line_sets[-1].pen
    for frame, width in ((1, pen.width), (3, 2 * pen.width)):
        pen.width = width
        pen.keyframe_insert("width", frame=frame)
    ink = []
    for frame in (1, 3):
        cycles.frame_set(frame)
        ink.append(in_parts(with_lines(cycles, tmp_path / f"{frame}.png"))[2])
    assert ink[0] == pytest.approx(more, rel=0.02) and 1.6 < ink[1] / ink[0] < 2.4


def test_lines_of_a_view_layer_that_is_gone_are_told_and_repaired(cycles):
    first, second = in_layers(cycles)
    bpy.ops.fovea.lines_over()
    assert len(bpy.data.scenes) == 3
    lines_over.node(cycles, lines_over.OVER, first).mute = True
    cycles.view_layers.remove(second)
    assert len(list(check.problems(cycles))) == 2
    assert bpy.ops.fovea.lines_over_repair() == {"FINISHED"}
    assert list(check.problems(cycles)) == [] and len(bpy.data.scenes) == 2


def test_a_view_layer_that_the_compositor_does_not_show_gets_no_lines(cycles):
    hidden = cycles.view_layers.new("Hidden")
    with (
        bpy.context.temp_override(view_layer=hidden),
        pytest.raises(RuntimeError, match="shows no picture of 'Hidden'"),
    ):
        bpy.ops.fovea.lines_over_layer()
    assert len(bpy.data.scenes) == 1 and part("render.compositor").tree(cycles) is None
