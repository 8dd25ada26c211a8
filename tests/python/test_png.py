# SPDX-License-Identifier: GPL-3.0-or-later
"""PNG encoding of pictures."""

import struct

import numpy as np
import pytest
from native_core import core


def test_the_file_has_the_size_of_the_picture():
    data = core.png_bytes(np.zeros((5, 7, 3), np.uint8))
    assert data[1:4] == b"PNG" and struct.unpack(">II", data[16:24]) == (7, 5)


@pytest.mark.parametrize("shape", [(0, 3, 3), (3, 0, 3), (4, 4), (4, 4, 4)])
def test_what_is_no_picture_is_refused(shape):
    with pytest.raises(ValueError):
        core.png_bytes(np.zeros(shape, np.uint8))
