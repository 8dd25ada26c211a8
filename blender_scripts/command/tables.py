# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of addon/docs that follow from what the native module says of line definitions and styles; `fovea stub` writes
them."""

import re

from .pages import DOCS

CONTENTS, KEYS = DOCS / "lines" / "README.md", DOCS / "style_files.md"
LISTED = re.compile(r'^\| \[<img src="(\w+)\.png".*$', re.MULTILINE)
RECORDS = {  # first cell of a table of KEYS -> the record whose members it lists
    "`paper`": "Paper",
    "`color`": "Color",
    "`section`": "Section",
    "`elision`": "Elision",
    "`focus`": "Focus",
    "a place in `points`": "FocusPlace",
    "`effects`": "Effects",
    "`distance`": "Distance",
    "`animation`": "Animation",
    "a transfer function": "Transfer",
    "a line set in `line_sets`": "LineSet",
    "an entry of `hidden`": "Hidden",
    "a pen": "Pen",
}
FAR = 1e8  # limits beyond are none
_COLOR, _PAPER = "red, green, blue", '`"paper"`'


def pages(catalogue, style):
    """{file: its text, with its tables renewed}, from the modules addon.catalogue and addon.style."""
    return {
        CONTENTS: contents(CONTENTS.read_text(encoding="utf-8"), catalogue.definitions()),
        KEYS: style_keys(KEYS.read_text(encoding="utf-8"), style),
    }


def contents(text, definitions):
    """The list of line definitions with a row for each of `definitions`. A row stays in its table; a new one follows
    the definition before it in the registry."""
    blocks, table_of = text.split("\n\n"), {}
    for number, block in enumerate(blocks):
        table_of |= dict.fromkeys(LISTED.findall(block), number)
    rows = {number: [] for number in sorted(set(table_of.values()))}
    last = next(iter(rows))
    for definition in definitions:
        last = table_of.get(definition["name"], last)
        rows[last].append(_entry(**{key: definition[key] for key in ("name", "label", "description")}))
    for number, listed in rows.items():
        head = [line for line in blocks[number].split("\n") if not LISTED.match(line)]
        blocks[number] = "\n".join([*head, *listed])
    return "\n\n".join(blocks)


def _entry(name, label, description):
    picture = f'<img src="{name}.png" width="160" alt="{label}">'
    return f"| [{picture}]({name}.md) | [{label}]({name}.md) `{name}` | {description} |"


def style_keys(text, style):
    """The page on style files with the table of every record: key, name in Blender, meaning, values, default."""
    blocks = text.split("\n\n")
    for number, block in enumerate(blocks):
        head = re.match(r"\| ([^|]*) \|", block)
        if head and head[1] in RECORDS:
            blocks[number] = "\n".join(table(head[1], getattr(style, RECORDS[head[1]]).fields, style))
    return "\n\n".join(blocks).rstrip("\n") + "\n"


def table(title, fields, style):
    """Yields the lines of the table of a record's fields."""
    yield f"| {title} | in Blender | | values | default |"
    yield "|---|---|---|---|---|"
    for field in fields:
        if field["key"]:
            cells = f"`{field['key']}`", field["label"], field["description"], values(field, style), default(field)
            yield re.sub(r"\| (?= \|)", "|", f"| {' | '.join(cells)} |")


def values(field, style):
    """The values that a key of a style file may have, in words."""
    kind = field["type"]
    if kind in ("number", "whole number"):
        return _range(field)
    if kind == "choice":
        return ", ".join(f"`{name}`" for name, *_ in field["choices"])
    if field["names"] in ("texture", "paper"):
        return ", ".join(f"`{name}`" for name in (style.textures if field["names"] == "texture" else style.papers)())
    if kind == "text":
        return "a name" if field["names"] else "any"
    if kind == "color":
        return "numbers" if field["unit"] != "light" else _COLOR if field["default"] else f"{_COLOR}; or {_PAPER}"
    return {"switch": "`true`, `false`", "transfer": "transfer function"}.get(kind, "")


def _range(field):
    least, most = field["min"], field["max"]
    unit = {"": "", "share": "", "seed": "", "reference pixels": " px"}.get(field["unit"], f" {field['unit']}")
    return "any" if least < -FAR else f"from {least:.10g}" if most > FAR else f"{least:.10g} to {most:.10g}{unit}"


def default(field):
    """The default of a key, as it is written in a file; "" where that says nothing."""
    value = field["default"]
    if field["type"] == "switch":
        return f"`{str(value).lower()}`"
    if field["type"] == "transfer":
        return f"strength {value.strength:g}"
    if field["type"] == "color":
        return _PAPER if value is None else ", ".join(f"{channel:g}" for channel in value)
    if isinstance(value, (int, float)):
        return f"{value:.10g}"
    return f"`{value}`" if isinstance(value, str) and value else ""
