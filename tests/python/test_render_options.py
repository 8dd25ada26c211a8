# SPDX-License-Identifier: GPL-3.0-or-later
"""`fovea render` and `fovea farm` refuse what cannot be meant, before Blender starts."""

import pytest
from command import farm, render_options


@pytest.fixture
def file(tmp_path):
    path = tmp_path / "scene.blend"
    path.touch()
    return path


def test_words_are_taken_as_they_are_given(file, tmp_path):
    options = render_options.parse([str(file), "--frames", "3-7", "-o", str(tmp_path / "new" / "a_####"), "--resume"])
    assert options.file == file and options.frames == (3, 7) and options.resume and not options.scripts
    assert (tmp_path / "new").is_dir()


@pytest.mark.parametrize(
    "words, said",
    [
        (["none.blend"], "there is no Blender file"),
        (["{file}", "--frames", "7-3"], "is not FIRST-LAST"),
        (["{file}", "--threads", "-1"], "name 1 to 1024"),
        (["{file}", "-o", "{file}/a_####"], "cannot be made"),
        (["{file}", "-o", "{file.parent}"], "is a folder: name frames in it"),
        (["{file}", "-o", "new/"], "is a folder: name frames in it, as"),
    ],
)
def test_what_cannot_be_rendered_is_refused(file, capsys, words, said):
    with pytest.raises(SystemExit) as ended:
        render_options.parse([word.format(file=file) for word in words])
    assert ended.value.code == 2 and said in capsys.readouterr().err


@pytest.mark.parametrize(
    "words, said",
    [
        (["mend", "{folder}"], "invalid choice"),
        (["check", "{folder}/none"], "there is no folder"),
        (["check", "{folder}", "{folder}", "{folder}"], "or two are compared"),
        (["check", "--neighbours", "{folder}", "--frames", "1-2"], "frames of one Blender file"),
        (["check", "--neighbours", "{file}"], "name the frames"),
    ],
)
def test_what_cannot_be_checked_is_refused(file, tmp_path, capsys, words, said):
    with pytest.raises(SystemExit) as ended:
        farm.parse([word.format(folder=tmp_path, file=file) for word in words])
    assert ended.value.code == 2 and said in capsys.readouterr().err


def run(monkeypatch, tmp_path, differing):
    """The status of a comparison of frames alone and in order, and what Blender was to render."""
    rendered = []
    monkeypatch.setenv("TMPDIR", str(tmp_path))
    monkeypatch.setattr(farm.actions, "render", lambda _target, words: rendered.append(words[1:]))
    result = {"frames": 3, "equal": not differing, "different": [{"frame": frame} for frame in differing]}
    monkeypatch.setattr(farm, "checked", lambda *_: {"result": result})
    return farm.farm(None, ["check", "--neighbours", str(tmp_path / "scene.blend"), "--frames", "4-6"]), rendered


def test_frames_are_rendered_in_order_and_each_alone(file, tmp_path, monkeypatch, capsys):
    status, rendered = run(monkeypatch, tmp_path, [])
    together, alone = (str(tmp_path / name / "frame_####") for name in ("together", "alone"))
    expected = [("4-6", together), ("4-4", alone), ("5-5", alone), ("6-6", alone)]
    assert rendered == [["--frames", frames, "-o", place] for frames, place in expected]
    assert status == 0 and capsys.readouterr().out == "3 frames: alone as in the animation\n"


def test_frames_that_are_others_alone_are_told_with_the_remedy(file, tmp_path, monkeypatch, capsys):
    status, _ = run(monkeypatch, tmp_path, [6])
    told, end = capsys.readouterr().out.splitlines()
    assert status == 1 and told.startswith("frame 6 is another one alone") and "bake simulations" in end
