# SPDX-License-Identifier: GPL-3.0-or-later
"""The bundled pen textures: equal to the script's output, seamless along the stroke, each with its length."""

import importlib.util
import json
import struct
import zlib
from pathlib import Path

import pytest

np = pytest.importorskip("numpy")

PROJECT = Path(__file__).parents[2]
FOLDER = PROJECT / "addon" / "textures"
SCRIPT = PROJECT / "blender_scripts" / "make_textures.py"
LENGTHS = json.loads((FOLDER / "textures.json").read_text())


def read_png(path):
    """Values of an 8-bit gray PNG whose rows are not filtered, as the script writes them."""
    data, at, packed = path.read_bytes(), 8, b""
    while at < len(data):
        (size,), name = struct.unpack(">I", data[at : at + 4]), data[at + 4 : at + 8]
        body = data[at + 8 : at + 8 + size]
        if name == b"IHDR":
            width, height = struct.unpack(">II", body[:8])
        if name == b"IDAT":
            packed += body
        at += size + 12
    return np.frombuffer(zlib.decompress(packed), np.uint8).reshape(height, width + 1)[:, 1:].astype(int)


def test_every_texture_has_a_length_and_a_file():
    assert set(LENGTHS) == {path.stem for path in FOLDER.glob("*.png")}
    assert set(LENGTHS) >= {"solid", "pencil", "charcoal", "ink", "dashes", "dots"}


@pytest.mark.parametrize("name", LENGTHS)
def test_texture(name):
    ink = read_png(FOLDER / f"{name}.png")
    rows, columns = ink.shape
    assert columns == rows * LENGTHS[name]["length_in_widths"], "texels are square on paper"
    assert ink.max() > 200 and ink.mean() > 70, "the pen draws"
    assert ink[rows // 2 - 1 : rows // 2 + 1, 0].min() > 60, "the middle of a path has ink"
    steps = np.abs(np.diff(ink, axis=1)).mean(axis=0)
    seam = np.abs(ink[:, 0] - ink[:, -1]).mean()
    assert seam <= max(steps.max(), 1), "the repetition shows no seam"


@pytest.mark.parametrize("name", ["pencil", "charcoal", "smudge", "chalk", "brush", "marker"])
def test_grain_has_all_frequencies_alike(name):
    """Along the stroke, in its middle: no power is 1.4 times the mean of that an octave below and above. Grain of one
    size would look like worms."""
    ink = read_png(FOLDER / f"{name}.png")[8:24].astype(float)
    power = (np.abs(np.fft.rfft(ink - ink.mean(axis=1, keepdims=True), axis=1)) ** 2).mean(axis=0)
    middles = 32 * 2 ** np.arange(0, 5.01, 0.5)  # cycles of the whole texture, up to the finest
    means = np.array([power[int(at * 2**-0.25) : int(at * 2**0.25) + 1].mean() for at in middles])
    assert (means[2:-2] < 1.4 * np.sqrt(means[:-4] * means[4:])).all()


@pytest.mark.skipif(not SCRIPT.exists(), reason="only in the checkout")
def test_the_script_makes_them(tmp_path):
    spec = importlib.util.spec_from_file_location("make_textures", SCRIPT)
    script = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(script)
    script.main(tmp_path)
    assert json.loads((tmp_path / "textures.json").read_text()) == LENGTHS
    for name in LENGTHS:
        difference = np.abs(read_png(tmp_path / f"{name}.png") - read_png(FOLDER / f"{name}.png"))
        assert difference.max() <= 1, f"{name}: run blender_scripts/make_textures.py"
