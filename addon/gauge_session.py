# SPDX-License-Identifier: GPL-3.0-or-later
"""Sessions of gauge studies that are set without a browser: what a person is shown in which order, what the pointer and
keys do, and the file that is saved, as by the page of `fovea study make`. Without Blender."""

import hashlib
import json
import random as randoms
import secrets
import time
from dataclasses import dataclass
from pathlib import Path

from . import files, gauges

STUDY = "study.json"
NEXT, BACK = {"SPACE", "RET", "NUMPAD_ENTER"}, {"BACK_SPACE"}
FIRST = "Drag the gauge first"


@dataclass(frozen=True)
class Study:
    """What is shown; not the true normals."""

    folder: Path
    name: str
    build: str
    model: str
    size: tuple  # (width, height) of pictures in pixels
    radius: float  # of gauges in pixels
    places: list  # of (x, y), pixels from the upper left
    stimuli: list  # of {style, file, sha256}
    strings: list  # of (first, end)

    @property
    def sets(self):
        return gauges.sets(len(self.places), self.strings)

    def picture(self, stimulus):
        """The Path of a stimulus. ValueError where it is not the one that the study was made with."""
        path = self.folder / stimulus["file"]
        if not path.is_file() or hashlib.sha256(path.read_bytes()).hexdigest() != stimulus["sha256"]:
            raise ValueError(f"{path} is not the picture that the study was made with: make the study again")
        return path


def read(path):
    """The Study of a study.json. ValueError, in a sentence, where it is none."""
    path = Path(path)
    if path.name != STUDY or not path.is_file():
        raise ValueError(f"'{path.name}' is no study: name the {STUDY} of a folder that `fovea study make` wrote")
    try:
        told = json.loads(path.read_text(encoding="utf-8"))
        stimuli = [{key: str(each[key]) for key in ("style", "file", "sha256")} for each in told["stimuli"]]
        places = [(float(gauge["x"]), float(gauge["y"])) for gauge in told["gauges"]]
        size, radius = tuple(map(int, told["size"])), float(told["radius"])
        strings = [tuple(map(int, each)) for each in told.get("strings", [])]
        study = Study(path.parent, told["study"], told["build"], told["model"], size, radius, places, stimuli, strings)
    except (KeyError, TypeError, ValueError) as error:
        raise ValueError(f"{path} is not as `fovea study make` wrote it ({error!r}): make the study again") from error
    if not study.places or not study.stimuli or min(*size, radius) <= 0:
        raise ValueError(f"{path} has no gauges, or no pictures: make the study again")
    return study


def counts(study):
    """How many sessions of each stimulus are in the study's folder."""
    found = {each["sha256"]: set() for each in study.stimuli}
    for path in study.folder.glob("*.jsonl"):
        for line in path.read_bytes().splitlines():
            try:
                told = json.loads(line)
                found[told["stimulus"]].add((told["participant"], told["session"]))
            except (KeyError, TypeError, ValueError):
                continue  # the analysis names such lines
    return [len(found[each["sha256"]]) for each in study.stimuli]


def begun(study, before, device, random=None):
    """The Session that comes after one of the same person, or where `before` is None the first one of a new person, who
    sees a stimulus that is the likelier the fewer sessions it has. ValueError after the last one."""
    random = random or randoms.SystemRandom()
    if before is None:
        weights = [1 / (count + 1) for count in counts(study)]
        (stimulus,) = random.choices(study.stimuli, weights)
        return Session(study, stimulus, secrets.token_hex(8), 0, device, random)
    if before.number + 1 >= len(study.sets):
        raise ValueError("This person has set all gauges of the study: choose Another Person")
    return Session(study, before.stimulus, before.participant, before.number + 1, device, random)


@dataclass
class Step:
    """One gauge as it comes up."""

    gauge: int
    repeat: int  # 1: for the second time
    start: object  # (3,) normal that it has first
    n: object = None  # (3,) normal that it was turned to
    ms: float = 0.0
    is_set: bool = False


class Session:
    """A set of gauges in random order, and the same again in another order."""

    def __init__(self, study, stimulus, participant, number, device, random, now=time.perf_counter):
        self.study, self.stimulus, self.participant, self.number = study, stimulus, participant, number
        self.device, self.now, self.at = device, now, 0
        own = range(len(study.places))[study.sets[number % len(study.sets)]]
        self.steps = [
            Step(gauge, repeat, gauges.anywhere(random)) for repeat in (0, 1) for gauge in random.sample(own, len(own))
        ]
        self.since = now()

    @property
    def done(self):
        return self.at == len(self.steps)

    @property
    def place(self):
        return self.study.places[self.steps[self.at].gauge]

    @property
    def normal(self):
        step = self.steps[self.at]
        return step.start if step.n is None else step.n

    def turn(self, n):
        self.steps[self.at].n = n

    def next(self):
        """Takes the gauge as it is and goes on; False: it has not been touched."""
        if self.done or self.steps[self.at].n is None:
            return False
        self.pause()
        self.steps[self.at].is_set = True
        self.at += 1
        return True

    def back(self):
        if not self.at:
            return False
        self.pause()
        self.at -= 1
        return True

    def pause(self):
        """Adds the time since the last step to the gauge that is shown."""
        now = self.now()
        if not self.done:
            self.steps[self.at].ms += 1000 * (now - self.since)
        self.since = now

    def resume(self):
        """Leaves out the time since the last step."""
        self.since = self.now()

    @property
    def count(self):
        """How many are set."""
        return sum(step.is_set for step in self.steps)

    @property
    def path(self):
        return self.study.folder / f"{self.study.model}-{self.participant}-{self.number}.jsonl"

    def save(self):
        """Writes all gauges that are set, whole; nothing where there are none. files.NotWritten where it cannot be."""
        if self.count:
            with files.written(self.path) as fresh:
                fresh.write_text(self.lines(), encoding="utf-8")

    def lines(self):
        """A line of JSON for each gauge that is set."""
        told = enumerate(self.steps)
        return "".join(f"{json.dumps(self._told(order, step))}\n" for order, step in told if step.is_set)

    def _told(self, order, step):
        study, (x, y) = self.study, self.study.places[step.gauge]
        return {
            "study": study.name, "build": study.build, "stimulus": self.stimulus["sha256"],
            "style": self.stimulus["style"], "model": study.model, "participant": self.participant,
            "session": self.number, "order": order, "gauge": step.gauge, "x": x, "y": y, "repeat": step.repeat,
            "n": _rounded(step.n), "ms": round(step.ms), "start": _rounded(step.start), "device": self.device,
        }  # fmt: skip


def _rounded(n):
    return [round(float(value), 6) for value in n]


class Hand:
    """What the pointer and keys, by Blender's names, do to a Session. `told`: a sentence to show, or ""."""

    def __init__(self, session):
        self.session, self.is_held, self.told = session, False, ""

    def take(self, kind, value, px):
        """What became of an event at pixels (x, y) of the picture from the upper left: "turned", "moved" (to another
        gauge), "told", "end", or None where it means nothing."""
        if kind == "ESC" and value == "PRESS":
            return "end"
        if kind == "LEFTMOUSE":
            self.is_held = value in {"PRESS", "DOUBLE_CLICK"}
        if self.is_held and kind in {"LEFTMOUSE", "MOUSEMOVE", "INBETWEEN_MOUSEMOVE"}:
            x, y = self.session.place
            self.session.turn(gauges.dragged((px[0] - x, y - px[1]), self.session.study.radius))
            self.told = ""
            return "turned"
        if value == "PRESS" and kind in NEXT | BACK:
            return self._step(kind)
        return None

    def _step(self, kind):
        self.is_held = False
        moved = self.session.next() if kind in NEXT else self.session.back()
        self.told = FIRST if kind in NEXT and not moved else ""
        if moved and self.session.done:
            return "end"
        return "moved" if moved else "told"
