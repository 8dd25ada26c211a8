# SPDX-License-Identifier: GPL-3.0-or-later
"""`fovea bench ink`: how the surfaces of models are drawn, and how much ink each line definition takes; see
bench/ink.py, which measures it."""

import argparse
import json

from . import actions
from .target import SHARED


def ink(target, words):
    parser = argparse.ArgumentParser("fovea bench ink")
    parser.add_argument("models", nargs="*", metavar="MODEL|SCENE", help="those of the shared folder, and the demo")
    parser.add_argument("--style", default="plain", metavar="NAME")
    parser.add_argument("--json", action="store_true", help="print JSON instead of a table")
    options = parser.parse_args(words)
    models = options.models or [*sorted(map(str, (SHARED / "models").rglob("*.obj"))), "demo"]
    asked = [options.style, *models]
    rows = json.loads(actions.written_by(target, f"drawing {len(models)} models", "bench/ink.py", asked))
    print(json.dumps(rows, indent=1) if options.json else table(rows))
    return 0


def table(rows):
    """Text: a line per row of bench/ink.py, shares in percent."""
    lines = []
    for row in rows:
        shapes = ", ".join(f"{count} {shape}" for shape, count in sorted(row["shapes"].items()))
        shares = sorted(row["of"].items(), key=lambda item: -item[1])
        kinds = ", ".join(f"{name} {100 * share:.1f}" for name, share in shares)
        lines.append(f"{row['model']:20} {row['ink']:7}  {shapes:28} {kinds}")
    return "\n".join(lines)
