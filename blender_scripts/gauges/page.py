# SPDX-License-Identifier: GPL-3.0-or-later
"""The page of a study by which people take part: one HTML file that needs no others and no network. It has the
pictures and the places of gauges, and not the true normals."""

import base64
import json
from pathlib import Path

from .formulas import EXAMPLE

HERE = Path(__file__).parent


def page(told, pictures):
    """The text of the page. `told`: what study.json has; `pictures`: {style: bytes of its PNG file}."""
    shown = {key: told[key] for key in ("study", "build", "model", "size", "radius")}
    shown["example"] = EXAMPLE
    shown["strings"] = told.get("strings", [])
    shown["gauges"] = [[gauge["x"], gauge["y"]] for gauge in told["gauges"]]
    shown["stimuli"] = [
        {"style": each["style"], "sha256": each["sha256"], "picture": _inlined(pictures[each["style"]])}
        for each in told["stimuli"]
    ]
    data = json.dumps(shown).replace("<", "\\u003c")
    script = "\n".join([f"const STUDY = {data};", script_of("gauge.js"), script_of("page.js")])
    text = (HERE / "page.html").read_text(encoding="utf-8")
    width, height = told["size"]
    for name, value in {"@WIDTH@": str(width), "@HEIGHT@": str(height), "@SCRIPT@": script}.items():
        text = text.replace(name, value)
    return text


def script_of(name):
    return (HERE / name).read_text(encoding="utf-8")


def _inlined(png):
    return f"data:image/png;base64,{base64.b64encode(png).decode()}"
