# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of a study: study.json of what was shown, with the true normals, and .jsonl files that participants' pages
save, a setting a line."""

import json
import math
from dataclasses import dataclass
from pathlib import Path

import numpy as np

STUDY = "study.json"


@dataclass(frozen=True)
class Study:
    """What was shown."""

    folder: Path
    name: str  # identifies it in settings
    model: str
    size: tuple  # (width, height) of pictures in pixels
    radius: float  # of gauges in pixels
    stimuli: dict  # style -> {file, sha256}
    places: np.ndarray  # (n, 2)
    truth: np.ndarray  # (n, 3)
    strings: list  # of (first, end) of gauges along a line each, the last ones of all

    @property
    def even(self):
        """How many gauges are spread evenly: the first ones."""
        return self.strings[0][0] if self.strings else len(self.truth)


@dataclass(frozen=True)
class Session:
    """What one participant has set in one go."""

    participant: str
    number: int
    style: str
    gauge: np.ndarray  # (n,) which one of the study's
    repeat: np.ndarray  # (n,) 0, or 1 where it was set before
    normals: np.ndarray  # (n, 3)
    seconds: np.ndarray  # (n,) that each took


def read_study(folder):
    """The Study of a folder. ValueError in a sentence where it has none."""
    path = Path(folder) / STUDY
    if not path.is_file():
        raise ValueError(f"{folder} has no {STUDY}: name a folder that `fovea study make` wrote")
    try:
        told = json.loads(path.read_text(encoding="utf-8"))
        stimuli = {each["style"]: {key: str(each[key]) for key in ("file", "sha256")} for each in told["stimuli"]}
        places = np.array([[gauge["x"], gauge["y"]] for gauge in told["gauges"]], np.float64).reshape(-1, 2)
        truth = np.array([gauge["n"] for gauge in told["gauges"]], np.float64).reshape(-1, 3)
        size, radius = tuple(map(int, told["size"])), float(told["radius"])
        strings = [tuple(map(int, each)) for each in told.get("strings", [])]
        study = Study(Path(folder), told["study"], told["model"], size, radius, stimuli, places, truth, strings)
    except (KeyError, TypeError, ValueError) as error:
        raise ValueError(f"{path} is not as `fovea study make` wrote it ({error!r}): make the study again") from error
    if len(truth) < 3 or not np.allclose(np.linalg.norm(truth, axis=1), 1, atol=1e-6):
        raise ValueError(f"{path} has too few gauges, or broken normals: make the study again")
    ends = [study.even, *(end for _, end in strings)]
    if study.even < 3 or ends[-1] != len(truth) or any(f != e or e + 3 > end for e, (f, end) in zip(ends, strings)):
        raise ValueError(f"{path} has strings that are not its last gauges: make the study again")
    return study


def read_sessions(study):
    """The Sessions in a study's folder, in order. A setting that several files have counts once: pages save all of a
    session each time. ValueError, which names the file and line, where one cannot be read."""
    found = {}
    for path in sorted(study.folder.glob("*.jsonl")):
        for number, line in enumerate(path.read_bytes().splitlines(), start=1):
            if line.strip():
                try:
                    session, which, setting = _setting(study, line)
                except (KeyError, TypeError, ValueError) as error:
                    why = error.args[0] if type(error) is ValueError else f"it is not whole: {error!r}"
                    raise ValueError(f"{path.name}, line {number}: {why}; take the file away, or that line") from error
                found.setdefault(session, {})[which] = setting
    return [_session(key, settings) for key, settings in sorted(found.items())]


def _setting(study, line):
    """((participant, session, style), (gauge, repeat), (normal, seconds)) of a line."""
    told = json.loads(line)
    if told["study"] != study.name:
        raise ValueError(f"it is of another study, {told['study']}")
    style, gauge, repeat = told["style"], int(told["gauge"]), int(told["repeat"])
    if style not in study.stimuli or told["stimulus"] != study.stimuli[style]["sha256"]:
        raise ValueError(f"it is of another picture than this study's '{style}'")
    if not 0 <= gauge < len(study.truth):
        raise ValueError(f"the study has no gauge {gauge}")
    n = np.array(told["n"], np.float64)
    if n.shape != (3,) or not n[2] > 0 or not math.isclose(np.linalg.norm(n), 1, abs_tol=1e-3):
        raise ValueError(f"n is no unit vector towards the viewer: {told['n']}")
    seconds = float(told["ms"]) / 1000
    if not math.isfinite(seconds):
        raise ValueError(f"ms is no time: {told['ms']}")
    session = str(told["participant"]), int(told["session"]), style
    return session, (gauge, repeat), (n / np.linalg.norm(n), seconds)


def _session(key, settings):
    gauge, repeat = np.array(list(settings), np.intp).T
    normals, seconds = (np.array(values, np.float64) for values in zip(*settings.values()))
    return Session(*key, gauge, repeat, normals, seconds)
