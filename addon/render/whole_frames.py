# SPDX-License-Identifier: GPL-3.0-or-later
"""Frames of background renders that are whole, recorded, and rendered once, where FOVEA_ATOMIC is 1, by any engine.

Blender writes frames in place, and skips by *Overwrite* whatever is there, also what a killed Blender left of a frame.
So here it writes them to a folder of its own beside their place; each is read, moved into place, and recorded
(frame_records.py). Frames that are recorded with the same key and have the pixels of their record are done: with
FOVEA_RESUME, or *Overwrite* off, these alone are skipped. Blender does so because its folder has a file of their name.

Placeholders are off meanwhile. Movies, and what File Output nodes write, are left to Blender."""

import os
import socket
import sys
import time
from contextlib import ExitStack
from pathlib import Path

import bpy
from bpy.app.handlers import persistent

from .. import files, frame_records
from ..held_folder import LOCK, held_folder
from . import as_rendered, frame_key, lines_scenes, whole_pictures

PREFIX = "part-"  # of the folders that Blender writes to
finished = []  # paths of the frames that this process has moved into place, or found done, in order
failures = []  # sentences on those that are not whole
exits = True  # whether Blender ends, with status 1, after a render with failures

_render = None  # the Render in progress
_known = {}  # (path, size, time of its last change in ns) -> hash of its pixels


class Render:
    """One call of Blender's, of a frame or an animation: from render_init to render_complete or render_cancel."""

    def __init__(self, scene, stack):
        render = scene.render
        self.scene, self.stack, self.key = scene, stack, frame_key.key_of(scene)
        self.place, self.folder = _folders(scene, stack)
        resumes = os.environ.get("FOVEA_RESUME") == "1" or not render.use_overwrite
        for name in ("filepath", "use_overwrite", "use_placeholder"):
            stack.callback(setattr, render, name, getattr(render, name))
        name = render.filepath.replace("\\", "/").rpartition("/")[2]
        render.filepath = f"{whole_pictures.literal(self.folder)}/{name}"
        render.use_overwrite = render.use_placeholder = False
        self.skipped = {LOCK}
        if resumes:
            self._skip_done()
        self.started = time.monotonic()

    def _skip_done(self):
        """Leaves a file of each name that need not be rendered where Blender looks for it."""
        scene, records = self.scene, frame_records.read(self.place)
        for frame in sorted({scene.frame_current, *range(scene.frame_start, scene.frame_end + 1, scene.frame_step)}):
            paths = [Path(path) for path in _paths(scene, frame)]
            if all(self._is_done(records, path.name) for path in paths):
                for path in paths:
                    (self.folder / path.name).touch()
                    self.skipped.add(path.name)

    def _is_done(self, records, name):
        record = records.get(name)
        return bool(record and record["key"] == self.key and record["pixels_sha256"] == _pixels(self.place / name))

    def finish(self):
        """Moves what Blender has written into place. NotWritten if it is not whole, or lacks lines that should lie over
        it."""
        lost = lines_scenes.failure(self.scene)
        for fresh in sorted(self.folder.iterdir()):
            if fresh.name in self.skipped:
                continue
            if lost:
                fresh.unlink()
                continue
            place, pixels = self.place / fresh.name, _pixels(fresh)
            try:
                files.move(fresh, place, lambda _, pixels=pixels: pixels is not None)
            finally:
                fresh.unlink(missing_ok=True)
            record = {"frame": self.scene.frame_current, "file": place.name, "key": self.key}
            record |= {"pixels_sha256": pixels, "seconds": round(time.monotonic() - self.started, 3)}
            record |= {"host": socket.gethostname(), "blender": frame_key.blender(), "build": frame_key.build()}
            frame_records.append(self.place, record)
            finished.append(place)
            print(f"Saved: '{place}'", flush=True)  # as Blender told of the file before it was moved
        if lost:
            raise files.NotWritten(f"Frame {self.scene.frame_current} has no lines over it and is not kept: {lost}")


def _folders(scene, stack):
    """(where a scene's frames belong, a folder beside them for Blender to write to), as long as the stack is open.
    NotWritten if nothing can be written there."""
    place = Path(scene.render.frame_path(frame=scene.frame_current)).parent
    try:
        place.mkdir(parents=True, exist_ok=True)
        stack.callback(_remove_if_empty, place / frame_records.FOLDER)
        folder, _ = stack.enter_context(held_folder(place / frame_records.FOLDER, PREFIX))
    except OSError as error:
        refused = f"{scene.render.frame_path()} could not be written ({error.strerror}): name another place"
        raise files.NotWritten(refused) from error
    return place, folder


def check_place(scene):
    """NotWritten if a scene's frames cannot be written where they belong."""
    with ExitStack() as stack:
        _folders(scene, stack)


def in_place(path):
    """Where a file beside a picture that Blender is writing belongs: beside that picture's own place."""
    return _render.place / path.name if _render and path.parent == _render.folder else path


def _paths(scene, frame):
    """The files that Blender writes of a frame, those of both eyes if they are apart."""
    render = scene.render
    if render.use_multiview and render.image_settings.views_format == "INDIVIDUAL":
        return [render.frame_path(frame=frame, view=view.name) for view in render.views if view.use]
    return [render.frame_path(frame=frame)]


def _pixels(path):
    """The hash of a file's pixels, read once as long as it is the same; None if it is not whole."""
    try:
        found = path.stat()
    except FileNotFoundError:
        return None
    same = path.name, found.st_ino, found.st_size, found.st_mtime_ns
    if same not in _known:
        _known[same] = whole_pictures.pixels_sha256(path)
    return _known[same]


def _remove_if_empty(folder):
    """Removes a folder in which no frame is recorded."""
    if folder.is_dir() and [path.name for path in folder.iterdir()] == [LOCK]:
        (folder / LOCK).unlink()
        folder.rmdir()


@persistent
def _begin(scene, *_):
    global _render
    if as_rendered.is_looking() or scene.render.is_movie_format:
        return
    with ExitStack() as stack:
        try:
            _render = Render(scene, stack)
        except files.NotWritten as error:
            _fail(str(error))
        except OSError as error:
            _fail(f"{error.filename} could not be read ({error.strerror}): name another place")
        else:
            _render.stack = stack.pop_all()
    if failures and exits:  # else Blender would write in place
        sys.exit(1)


@persistent
def _restart_clock(*_):
    if _render:
        _render.started = time.monotonic()


@persistent
def _written(*_):
    if _render:
        try:
            _render.finish()
        except files.NotWritten as error:
            _fail(str(error))
        except OSError as error:
            _fail(f"Frame {_render.scene.frame_current} could not be recorded ({error.strerror}): make room")


@persistent
def _end(*_):
    global _render
    if _render:
        _render.stack.close()
        _render = None
        if failures and exits:
            sys.exit(1)


def _fail(sentence):
    failures.append(sentence)
    print(f"Error: {sentence}", file=sys.stderr, flush=True)


HANDLERS = {
    "render_init": _begin,
    "render_pre": _restart_clock,
    "render_write": _written,
    "render_complete": _end,
    "render_cancel": _end,
}


def switch_on():
    """As FOVEA_ATOMIC does, for scripts of farms whose tasks have no environment of their own."""
    for name, handler in HANDLERS.items():
        if handler not in getattr(bpy.app.handlers, name):
            getattr(bpy.app.handlers, name).append(handler)


def register():
    if bpy.app.background and os.environ.get("FOVEA_ATOMIC") == "1":
        switch_on()


def unregister():
    for name, handler in HANDLERS.items():
        if handler in getattr(bpy.app.handlers, name):
            getattr(bpy.app.handlers, name).remove(handler)
