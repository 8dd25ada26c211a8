# SPDX-License-Identifier: GPL-3.0-or-later
"""Records of rendered frames: a line each, of which the last one counts, whatever a killed process left."""

import json
import multiprocessing
import os

import pytest

from addon import frame_records


def record(frame, key="a"):
    return {"frame": frame, "file": f"x_{frame:04}.png", "key": key, "pixels_sha256": f"{frame:064}"}


def lines(folder):
    return (folder / ".fovea" / "frames.jsonl").read_bytes().splitlines()


def test_a_record_is_a_line_and_the_last_one_of_a_file_counts(tmp_path):
    assert frame_records.read(tmp_path) == {}
    for each in (record(1), record(2), record(1, "b")):
        frame_records.append(tmp_path, each)
    assert [json.loads(line)["frame"] for line in lines(tmp_path)] == [1, 2, 1]
    assert frame_records.read(tmp_path) == {"x_0001.png": record(1, "b"), "x_0002.png": record(2)}


def test_a_line_that_breaks_off_is_passed_over_and_does_not_spoil_the_next(tmp_path):
    frame_records.append(tmp_path, record(1))
    path = tmp_path / ".fovea" / "frames.jsonl"
    whole = path.read_bytes()
    for kept in (1, len(whole) // 2, len(whole) - 1):
        path.write_bytes(whole + whole[:kept])
        frame_records.append(tmp_path, record(2))
        assert frame_records.read(tmp_path) == {"x_0001.png": record(1), "x_0002.png": record(2)}


def test_lines_that_are_no_records_are_passed_over(tmp_path):
    frame_records.append(tmp_path, record(1))
    with (tmp_path / ".fovea" / "frames.jsonl").open("a") as file:
        file.write('3\n[]\nnull\n{"frame": "1", "file": "x_0001.png"}\n{"file": "y.png"}\n\n')
    assert frame_records.read(tmp_path) == {"x_0001.png": record(1)}


def write_many(folder, first):
    for frame in range(first, first + 400):
        frame_records.append(folder, record(frame))


@pytest.mark.skipif(os.name != "posix", reason="on Windows files are not locked")
def test_several_processes_append_at_once(tmp_path):
    context = multiprocessing.get_context("fork")
    writers = [context.Process(target=write_many, args=(tmp_path, first)) for first in (1, 401, 801)]
    for writer in writers:
        writer.start()
    for writer in writers:
        writer.join()
    assert [writer.exitcode for writer in writers] == [0, 0, 0]
    assert len(frame_records.read(tmp_path)) == len(lines(tmp_path)) == 1200
