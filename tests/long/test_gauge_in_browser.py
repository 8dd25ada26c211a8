# SPDX-License-Identifier: GPL-3.0-or-later
"""The page of a gauge study in Chromium without a window: one practices, drags every gauge, goes back once, and the
file that is saved is what the analysis reads. Left out where Chromium is not installed."""

import hashlib
import html
import json
import re
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).parents[2] / "blender_scripts"))

from gauges import formulas, page, records

PNG = bytes.fromhex(
    "89504e470d0a1a0a0000000d4948445200000001000000010802000000907753de0000000c49444154789c63f8ffff3f0005fe02fe"
    "0def46b80000000049454e44ae426082"
)
OFFSETS = [(12, 5), (-18, 9), (3, -25), (0, 38), (-44, -44)]
COUNT = 6

# Runs in the page after its script: events as of a hand, and what is saved goes into the page for --dump-dom.
DRIVER = """
<script>
const saved = [], seen = [];
URL.createObjectURL = blob => { blob.text().then(text => saved.push(text)); return "#"; };
HTMLAnchorElement.prototype.click = function () { seen.push(["file", this.download]); };
SVGElement.prototype.setPointerCapture = () => {};  // events that a script makes have no pointer
function press(key) { document.dispatchEvent(new KeyboardEvent("keydown", {key, cancelable: true})); }
function drag(svg, [x, y], [dx, dy]) {
    const {a, d, e, f} = svg.getScreenCTM();
    const event = (name, x, y) => new PointerEvent(name, {
        pointerId: 7, button: 0, cancelable: true, bubbles: true, clientX: a * x + e, clientY: d * y + f,
    });
    svg.dispatchEvent(event("pointerdown", x + 1, y + 1));
    svg.dispatchEvent(event("pointermove", x + dx, y + dy));
    svg.dispatchEvent(event("pointerup", x + dx, y + dy));
    svg.dispatchEvent(event("pointermove", x, y));  // after the button is up: nothing
}
function place(svg) {
    return svg.lastElementChild.getAttribute("transform").match(/-?[0-9.]+/g).map(Number);
}
function visible() {
    return [...document.querySelectorAll("section")].filter(each => !each.hidden).map(each => each.id).join();
}
const offsets = OFFSETS;
seen.push(["start", visible()]);
document.getElementById("go").click();
const example = document.getElementById("practice");
press(" ");
seen.push(["practice", visible(), document.getElementById("hint").textContent]);
while (visible() === "practicing") {
    drag(example, place(example), [30, -20]);
    seen.push(["hint", document.getElementById("hint").textContent]);
    press(" ");
}
const picture = document.getElementById("picture"), counted = document.getElementById("count");
press("Enter");
seen.push(["untouched", counted.textContent, document.getElementById("told").textContent]);
for (let i = 0; visible() === "setting" && i < 100; ++i) {
    drag(picture, place(picture), offsets[i % offsets.length]);
    seen.push(["count", counted.textContent]);
    press(i % 2 ? " " : "Enter");
    if (i === 2) {
        press("Backspace");
        seen.push(["back", counted.textContent]);
        press(" ");
    }
}
seen.push(["end", visible()]);
setTimeout(() => {
    const told = document.createElement("pre");
    told.id = "outcome";
    told.textContent = JSON.stringify({saved, seen});
    document.body.append(told);
}, 200);
</script>
"""


@pytest.fixture(scope="module")
def chromium():
    found = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
    if found is None:
        pytest.skip("Chromium, in which the page would be opened, is not installed")
    return found


@pytest.fixture(scope="module")
def taken_part(chromium, tmp_path_factory):
    """(Study, Session, what was seen) of one who takes part."""
    folder = tmp_path_factory.mktemp("study")
    gauges = [{"x": 200.5 + 100 * i, "y": 150.0 + 70 * i, "n": [0.0, 0.6, 0.8], "object": ""} for i in range(COUNT)]
    stimuli = [{"style": "plain", "file": "plain.png", "sha256": hashlib.sha256(PNG).hexdigest()}]
    told = {"study": "abc", "build": "test", "model": "ball", "size": [1024, 768], "radius": 20.0}
    told |= {"stimuli": stimuli, "gauges": gauges}
    (folder / records.STUDY).write_text(json.dumps(told))
    text = page.page(told, {"plain": PNG}).replace(
        "</body>", DRIVER.replace("OFFSETS", json.dumps(OFFSETS)) + "</body>"
    )
    (folder / "study.html").write_text(text, encoding="utf-8")
    words = ["--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={folder / 'profile'}", "--dump-dom"]
    words += ["--window-size=1200,600", "--virtual-time-budget=5000", (folder / "study.html").as_uri()]
    done = subprocess.run([chromium, *words], capture_output=True, text=True, timeout=120)
    outcome = re.search(r'<pre id="outcome">(.*?)</pre>', done.stdout, re.DOTALL)
    assert outcome, done.stderr[-2000:]
    outcome = json.loads(html.unescape(outcome[1]))
    (folder / "taken.jsonl").write_text(outcome["saved"][-1], encoding="utf-8")
    study = records.read_study(folder)
    (session,) = records.read_sessions(study)
    return study, session, outcome["seen"]


def test_one_practices_and_then_sets_every_gauge_twice(taken_part):
    _, session, seen = taken_part
    assert seen[0] == ["start", "start"] and seen[-2][0] == "file" and seen[-1] == ["end", "finished"]
    assert seen[1] == ["practice", "practicing", "Drag the gauge."], "space alone does not lead on"
    assert [each[0] for each in seen].count("hint") == 4
    assert sorted(session.gauge) == sorted([*range(COUNT)] * 2) and sorted(session.repeat) == [0] * COUNT + [1] * COUNT
    counts = [each[1] for each in seen if each[0] == "count"]
    assert counts == [f"Gauge {i + 1} of {2 * COUNT}" for i in range(2 * COUNT)]
    assert ["untouched", f"Gauge 1 of {2 * COUNT}", "Drag the gauge first."] in seen
    assert ["back", f"Gauge 3 of {2 * COUNT}"] in seen


def test_gauges_are_as_they_were_dragged(taken_part):
    _, session, _ = taken_part
    for i, n in enumerate(session.normals):
        x, y = OFFSETS[i % len(OFFSETS)]
        assert formulas.angles(n, formulas.dragged((x, -y), 20)) < 0.1, (
            "also where the window is wider than the picture"
        )
    assert np.isfinite(session.seconds).all()


def test_the_file_is_named_by_the_model_and_a_random_number(taken_part):
    _, session, seen = taken_part
    (name,) = (each[1] for each in seen if each[0] == "file")
    assert name == f"ball-{session.participant}-0.jsonl" and re.fullmatch("[0-9a-f]{16}", session.participant)
