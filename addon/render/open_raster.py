# SPDX-License-Identifier: GPL-3.0-or-later
"""OpenRaster files (.ora): a picture as layers, for Krita, GIMP and other programs that paint."""

import io
import zipfile
from itertools import groupby
from xml.sax.saxutils import quoteattr

NEW_YEAR = (1980, 1, 1, 0, 0, 0)  # of all files in it, so that equal pictures are equal files


def file_of(layers, merged, thumbnail, size):
    """The bytes of a file. `layers`: (line set or "", name, PNG) from below; line sets become groups of layers.
    `merged`, `thumbnail`: PNGs of all together. `size`: width and height in pixels."""
    content = io.BytesIO()
    with zipfile.ZipFile(content, "w") as archive:
        _add(archive, "mimetype", b"image/openraster")  # first and not compressed, so that its place is known
        _add(archive, "stack.xml", _stack(layers, size).encode(), zipfile.ZIP_DEFLATED)
        for number, (_, _, png) in enumerate(layers):
            _add(archive, _source(number), png)
        _add(archive, "mergedimage.png", merged)
        _add(archive, "Thumbnails/thumbnail.png", thumbnail)
    return content.getvalue()


def _add(archive, name, content, compression=zipfile.ZIP_STORED):
    entry = zipfile.ZipInfo(name, NEW_YEAR)
    entry.compress_type = compression
    archive.writestr(entry, content)


def _source(number):
    return f"data/layer{number}.png"


def _stack(layers, size):
    """The XML of the order of layers, the uppermost first."""
    width, height = size
    lines = ["<?xml version='1.0' encoding='UTF-8'?>", f'<image version="0.0.3" w="{width}" h="{height}">', "<stack>"]
    from_above = [(number, *layers[number]) for number in reversed(range(len(layers)))]
    for group, members in groupby(from_above, lambda layer: layer[1]):
        shown = [f'<layer name={_quoted(name)} src="{_source(n)}" x="0" y="0"/>' for n, _, name, _ in members]
        lines += [f"<stack name={_quoted(group)}>", *shown, "</stack>"] if group else shown
    return "\n".join([*lines, "</stack>", "</image>", ""])


def _quoted(text):
    """An attribute of XML; what it cannot hold becomes question marks."""
    return quoteattr("".join(c if c.isprintable() else "?" for c in text))
