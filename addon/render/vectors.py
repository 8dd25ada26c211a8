# SPDX-License-Identifier: GPL-3.0-or-later
"""Final renders as files of other programs: vectors, layers, pictures of black and white alone."""

from functools import partial

from .. import files, native, pipeline
from . import as_rendered, one_bit, open_raster, properties, session, vector_settings


def options(**given):
    """Native VectorOptions; those not given have their defaults."""
    return native.load().VectorOptions(**given)


def options_of(scene, titles=None, **given):
    """The same of a scene, whose settings say what is in the title block. `titles`: {member of Titles: text} in their
    place."""
    kept = vector_settings.values(scene.fovea.vectors.titles, vector_settings.title_fields())
    said = native.load().Titles(**kept | (titles or {}))
    return options(titles=said, unit_meters=scene.unit_settings.scale_length, **given)


def remark(asked):
    """A sentence about what VectorOptions leave out, or None."""
    if asked.plotter and asked.title_block:
        return "The title block has its lines alone: a plotter's pens have no letters"
    return None


def screen(**given):
    """Native Screen, which pictures of 1 bit are made by; what is not given has its default."""
    return native.load().Screen(**given)


def choices(of):
    """(name, label, description) of what an option can be: of `KINDS` of files, or of the core's `SHEETS`."""
    if native.problem():
        return []
    return vector_settings.kinds() if of == "KINDS" else getattr(native.load(), of)


_kept = {}  # Blender does not keep items of functions alive


def kept_items(of):
    """The same as a list that stays alive, empty as long as the native module is not there."""
    if not _kept.get(of):
        _kept[of] = list(choices(of))
    return _kept[of]


def sheets():
    """The items of SHEETS that are sheets of paper."""
    return [item for item in kept_items("SHEETS") if any(native.load().sheet_size(item[0]).values())]


def room_on_sheet(upright, **given):
    """(width, height) in millimeters of the largest picture on a sheet. `given`: the VectorOptions that say which."""
    with native.refusals():
        return tuple(native.load().room_on_sheet(options(**given), upright).values())


def drawing(context, kind, asked=None, camera=None, **how):
    """A drawing for files of a kind, of a final render of the context's frame and view layer, or None if the user
    canceled it. `asked`: VectorOptions, or of a PNG its Screen. `camera`: the object that sees it, None: the scene's
    camera; `how` as for `session.final`.

    It has `file()`, the bytes of a file, and `figures`, {what there is: how much}."""

    def prepare(scene):
        if camera:
            as_rendered.see_from(camera, scene)
        if kind == "png":
            _size_page(scene, asked, how.get("chosen"))

    draw = partial(_drawing, kind=kind, asked=asked)
    found = as_rendered.look(context, partial(session.final, make=draw, **how), prepare)
    return found and found[1]


def made(frame, kind, asked):
    """The same of a native Frame."""
    with native.refusals():
        if kind == "ora":
            return Layers(frame)
        return Bits(frame, asked) if kind == "png" else native.load().Drawing(frame, asked, kind)


def write(drawn, path):
    """Writes a drawing to a file, which is whole or not there."""
    content = drawn.file()
    with files.written(path) as fresh:
        fresh.write_bytes(content)


class Layers:
    """A frame as an OpenRaster file."""

    def __init__(self, frame):
        self._parts = native.load().layered_picture(frame)
        self._size = frame.view.width, frame.view.height
        self.figures = {"layers": len(self._parts["layers"])}

    def file(self):
        return open_raster.file_of(**self._parts, size=self._size)


class Bits:
    """A frame as a PNG of black and white."""

    def __init__(self, frame, asked):
        self._white, self._dpi = native.load().one_bit(frame, asked), asked.dpi
        self.figures = {"pixels": self._white.size, "black": int(self._white.size - self._white.sum())}

    def file(self):
        return one_bit.file_of(self._white, self._dpi)


def _size_page(scene, asked, chosen):
    """Gives a scene the pixels that its page has at a Screen's resolution."""
    page = properties.style_of(scene, given=chosen).paper.height_mm
    render, height = scene.render, asked.page_height(page)
    width = round(height * render.resolution_x / render.resolution_y)
    render.resolution_x, render.resolution_y, render.resolution_percentage = width, height, 100


def _drawing(found, *given, kind, asked):
    """`given`: what `session.draw` is given after what is read."""
    *shown, progress, cancel, near = given
    beside = {"colors": found.colors, "notes": found.notes, "near": near, "progress": progress, "cancel": cancel}
    return made(pipeline.frame(found.placed, *shown, **beside), kind, asked)
