# SPDX-License-Identifier: GPL-3.0-or-later
"""The sidecar of a folder of rendered frames, FOLDER/.fovea/frames.jsonl: what each frame was rendered from, and the
hash of its pixels. Without Blender.

A line is a JSON object: frame, file (its name), key (what it was rendered from: runs with equal keys render equal
frames), pixels_sha256, seconds, host, blender, and build (of the extension). Lines are only appended; the last one of a
file counts. What a killed process left half written is no JSON, and is passed over."""

import json
import os
from pathlib import Path

from .held_folder import lock

FOLDER, NAME = ".fovea", "frames.jsonl"


def append(folder, record):
    """Appends one record, durably; several processes may do so at once."""
    path = Path(folder, FOLDER, NAME)
    path.parent.mkdir(exist_ok=True)
    line = json.dumps(record, ensure_ascii=False).encode() + b"\n"
    with path.open("ab+", buffering=0) as file:
        lock(file)  # otherwise another process's line may be seen half written
        file.write(b"\n" + line if _is_torn(file) else line)
        os.fsync(file.fileno())


def _is_torn(file):
    """Whether a process was killed as it wrote the last line."""
    if not file.seek(0, os.SEEK_END):
        return False
    file.seek(-1, os.SEEK_END)
    return file.read(1) != b"\n"


def read(folder):
    """{name of a file: its last record}."""
    try:
        lines = Path(folder, FOLDER, NAME).read_bytes().splitlines()
    except FileNotFoundError:
        return {}
    records = filter(None, map(_record, lines))
    return {record["file"]: record for record in records}


def _record(line):
    try:
        record = json.loads(line)
        return record if isinstance(record["frame"], int) and isinstance(record["file"], str) else None
    except (ValueError, KeyError, TypeError):
        return None
