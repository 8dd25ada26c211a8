# SPDX-License-Identifier: GPL-3.0-or-later
"""A gauge study of a ball, and files of those who take part in it."""

import json

import numpy as np
from gauges import formulas, records

GAUGES = 90


def ball(random, count):
    """(count, 3) normals of a ball at places that are spread evenly over its picture."""
    far, turn = 0.97 * np.sqrt(random.random(count)), 2 * np.pi * random.random(count)
    return np.stack([far * np.cos(turn), far * np.sin(turn), np.sqrt(1 - far**2)], axis=1)


def study(tmp_path, styles=("pencil", "shaded"), count=GAUGES):
    random = np.random.default_rng(5)
    stimuli = [{"style": style, "file": f"{style}.png", "sha256": style * 3} for style in styles]
    places = random.random((count, 2)) * (1024, 768)
    gauges = [{"x": x, "y": y, "n": list(n)} for (x, y), n in zip(places, ball(random, count))]
    told = {"study": "test", "build": "test", "model": "ball", "size": [1024, 768], "radius": 20}
    told |= {"stimuli": stimuli, "gauges": gauges}
    (tmp_path / records.STUDY).write_text(json.dumps(told))
    return records.read_study(tmp_path)


def save(made, participant, style, settings_of, part=0):
    """Writes a session of one participant, a set of gauges twice. `settings_of(truth)`: normals (n, 3)."""
    numbers = np.arange(len(made.truth))[formulas.sets(len(made.truth), made.strings)[part]]
    lines = []
    for repeat in (0, 1):
        for order, (gauge, n) in enumerate(zip(numbers, settings_of(made.truth[numbers]))):
            line = {"study": made.name, "stimulus": made.stimuli[style]["sha256"], "style": style, "n": list(n)}
            line |= {"participant": participant, "session": part, "gauge": int(gauge), "repeat": repeat, "ms": 4000}
            lines.append(json.dumps(line | {"order": order}))
    (made.folder / f"{participant}-{part}.jsonl").write_text("\n".join(lines) + "\n")
