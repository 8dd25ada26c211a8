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
    ],
)
def test_what_cannot_be_checked_is_refused(tmp_path, capsys, words, said):
    with pytest.raises(SystemExit) as ended:
        farm.parse([word.format(folder=tmp_path) for word in words])
    assert ended.value.code == 2 and said in capsys.readouterr().err
