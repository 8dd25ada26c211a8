# SPDX-License-Identifier: GPL-3.0-or-later
"""Precompiled headers of build folders. ccache takes one that is there for one that is read: it would compile it anew,
and with it everything that reads it, in each build folder."""

import hashlib

from .target import PROJECT

FILES = ("*.gch", "*.pch")  # of GCC and of Clang


def forget_changed(folder):
    """Deletes those of a build folder that were compiled by another CMakeLists.txt, which has their options."""
    digest = hashlib.sha256((PROJECT / "CMakeLists.txt").read_bytes()).hexdigest()
    record = folder / "precompiled-by"
    if record.exists() and record.read_text() == digest:
        return
    for file in (file for pattern in FILES for file in folder.rglob(pattern)):
        file.unlink()
    record.write_text(digest)
