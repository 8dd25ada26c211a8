# SPDX-License-Identifier: GPL-3.0-or-later
"""Flamenco's job type under a stub of its manager: which tasks it makes of a job, and the command lines of Blender."""

import json
import shutil
import subprocess
from pathlib import Path

import pytest

JOB_TYPE = Path(__file__).parents[2] / "addon" / "farm" / "fovea_frames.js"

# As Flamenco's manager gives job types their names; its engine of JavaScript has neither modules nor promises.
STUB = """
const fs = require("fs"), vm = require("vm"), tasks = [];
class Command { constructor(name, parameters) { Object.assign(this, {name, parameters}); } }
class Task {
    constructor(name, type) { Object.assign(this, {name, type, commands: [], dependencies: []}); }
    addCommand(command) { this.commands.push(command); }
    addDependency(task) { this.dependencies.push(task.name); }
}
function frameChunker(frames, size) {
    const all = frames.split(",").flatMap(part => {
        const ends = part.split("-").map(Number), last = ends[ends.length - 1];
        return Array.from({length: last - ends[0] + 1}, (_, i) => ends[0] + i);
    });
    const chunks = [];
    for (let i = 0; i < all.length; i += size) {
        const runs = [];
        for (const frame of all.slice(i, i + size)) {
            const run = runs[runs.length - 1];
            if (run && run[1] + 1 === frame) run[1] = frame; else runs.push([frame, frame]);
        }
        chunks.push(runs.map(run => run[0] === run[1] ? `${run[0]}` : `${run[0]}-${run[1]}`).join(","));
    }
    return chunks;
}
const author = {
    Task: (name, type) => new Task(name, type), Command: (name, parameters) => new Command(name, parameters),
};
const job = {settings: JSON.parse(process.argv[3]), addTask: task => tasks.push(task)};
const names = {author, job, frameChunker, path: require("path"), print: console.error};
const script = fs.readFileSync(process.argv[2], "utf8") + ";compileJob(job); JOB_TYPE";
const type = vm.runInNewContext(script, names);
console.log(JSON.stringify({type, tasks}));
"""
SETTINGS = {"frames": "1-25,40", "chunk_size": 10, "output": "/frames/a_####"}
SETTINGS |= {"backend": "cpu", "blendfile": "/a.blend"}


@pytest.fixture(scope="module")
def compiled(tmp_path_factory):
    node = shutil.which("node")
    assert node, "Debian's nodejs is missing"
    stub = tmp_path_factory.mktemp("flamenco") / "stub.js"
    stub.write_text(STUB)
    words = [node, stub, JOB_TYPE, json.dumps(SETTINGS)]
    done = subprocess.run(words, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def test_a_flamenco_job_renders_chunks_and_checks_them_after_all(compiled):
    *chunks, check = compiled["tasks"]
    assert [task["name"] for task in chunks] == ["render-1-10", "render-11-20", "render-21-25,40"]
    assert check["name"] == "check" and check["dependencies"] == [task["name"] for task in chunks]
    assert {task["type"] for task in chunks} == {"blender"} and check["type"] == "misc"
    (command,) = check["commands"]
    assert command["name"] == "exec" and command["parameters"]["args"][-3:] == ["/frames", "--frames", "1-25,40"]


def test_a_task_of_flamenco_is_a_command_line_of_blender(compiled):
    (command,) = compiled["tasks"][2]["commands"]
    told = command["parameters"]
    assert command["name"] == "blender-render" and told["blendfile"] == "/a.blend"
    assert told["args"] == ["--render-output", "/frames/a_####", "--render-frame", "21..25,40"]
    *rest, expression = told["argsBefore"]
    assert rest == ["--python-exit-code", "1", "--python-expr"]
    compile(expression, "expression", "exec")
    assert "FOVEA_BACKEND='cpu'" in expression and "switch_on()" in expression


def test_a_chunk_of_consecutive_frames_is_one_animation(compiled):
    (command,) = compiled["tasks"][0]["commands"]
    of_animation = ["--frame-start", "1", "--frame-end", "10", "--frame-jump", "1", "--render-anim"]
    assert command["parameters"]["args"] == ["--render-output", "/frames/a_####", *of_animation]


def test_every_setting_that_a_flamenco_job_reads_is_declared(compiled):
    declared = {setting["key"]: setting for setting in compiled["type"]["settings"]}
    assert declared.keys() == SETTINGS.keys()
    assert {setting["type"] for setting in declared.values()} <= {"string", "int32", "bool", "float"}
