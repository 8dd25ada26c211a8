# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures as PNG files."""

import pytest
from native_core import core

np = pytest.importorskip("numpy")


def test_a_picture_comes_back(tmp_path):
    gray = np.arange(35, dtype=np.uint8).reshape(5, 7) * 7
    file = tmp_path / "gray.png"
    file.write_bytes(core.png_bytes(np.repeat(gray[..., None], 3, axis=2)))
    read = np.asarray(core.fit_texture(core.read_texture(str(file)), 7.0, 5.0))
    # Textures are read from the top, where files begin.
    assert read.shape == gray.shape and abs(255 * read[::-1] - gray).max() < 1.01


@pytest.mark.parametrize("shape", [(0, 3, 3), (3, 0, 3), (4, 4), (4, 4, 4)])
def test_what_is_no_picture_is_refused(shape):
    with pytest.raises(ValueError):
        core.png_bytes(np.zeros(shape, np.uint8))
