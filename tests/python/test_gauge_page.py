# SPDX-License-Identifier: GPL-3.0-or-later
"""The page of a gauge study: its script, run by Node.js, computes gauges as Python does, and saves what the analysis
reads; the page is one file that needs no network."""

import json
import re
import shutil
import subprocess

import numpy as np
import pytest
from gauges import formulas, page

from addon import gauges as shared

TOLD = {
    "study": "abc",
    "build": "test",
    "model": "</script>ball",
    "size": [1024, 768],
    "radius": 20.0,
    "stimuli": [{"style": "a", "file": "a.png", "sha256": "1"}, {"style": "b", "file": "b.png", "sha256": "2"}],
    "gauges": [{"x": 10.5 * i, "y": 7.0 * i, "n": [0.6, 0.0, 0.8]} for i in range(45)],
}
# What is computed: gauge.js is in the first argument, its numbers come as JSON on standard input.
RUN = """
const told = JSON.parse(require("fs").readFileSync(0)), gauge = require(process.argv[1]);
let seed = 1, clock = 0;
const random = () => (seed = seed * 16807 % 2147483647) / 2147483647;
const session = new gauge.Session(told.study, told.study.stimuli[0], {participant: "me", device: {}}, 1, random,
                                  () => clock);
const log = [];
while (!session.done) {
    const before = session.at;
    log.push(session.next());  // not turned yet
    session.turn(gauge.dragged(before, -3, 20));
    clock += 1000;
    session.next();
    if (before === 4) { session.back(); clock += 500; session.turn([0, 0, 1]); session.next(); }
    if (before === 9) log.push(session.lines().split("\\n").length - 1);
}
const counts = [0, 0, 0];
for (let i = 0; i < 6000; ++i) ++counts[gauge.chosen([0, 1, 3], random)];
const anywhere = Array.from({length: 3000}, () => gauge.anywhere(random));
console.log(JSON.stringify({
    dragged: told.offsets.map(([x, y]) => gauge.dragged(x, y, 20)),
    ellipses: told.normals.map(n => gauge.ellipse(n, 20)),
    sets: told.counts.map(count => gauge.sets(count)),
    strings: told.strings.map(each => gauge.sets(200, each)), log,
    lines: session.lines(), back: session.back(), counts, anywhere,
    ellipsoid: gauge.normalOfEllipsoid(30, -40, [100, 100, 100]),
    example: told.example.places.map(([x, y]) => gauge.normalOfEllipsoid(
        x - told.example.middle[0], told.example.middle[1] - y, told.example.axes)),
    off: gauge.degreesBetween([0, 0, 1], [0.6, 0, 0.8]),
}));
"""
OFFSETS = [(x, y) for x in (-60, -7, 0, 21) for y in (-35, 0, 4, 19)]
STRINGS = [[[90, 105]], [[45, 60], [60, 75]], [[150, 160], [160, 180], [180, 200]]]
COUNTS = [7, 30, 31, 45, 90, 91, 180, 1000]


@pytest.fixture(scope="module")
def found():
    node = shutil.which("node")
    if node is None:
        pytest.skip("Node.js, which would run the page's script, is not installed")
    normals = [formulas.dragged(offset, 20) for offset in OFFSETS]
    study = {**TOLD, "gauges": [[gauge["x"], gauge["y"]] for gauge in TOLD["gauges"]]}
    asked = {"offsets": OFFSETS, "normals": [list(n) for n in normals], "counts": COUNTS, "strings": STRINGS}
    asked["study"], asked["example"] = study, formulas.EXAMPLE
    words = [node, "-e", RUN, str(page.HERE / "gauge.js")]
    done = subprocess.run(words, input=json.dumps(asked), capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout) | {"normals": normals}


def test_the_page_turns_gauges_as_formulas_say_with_y_downwards(found):
    assert np.allclose(found["dragged"], [formulas.dragged((x, -y), 20) for x, y in OFFSETS])


def test_the_page_draws_the_ellipse_and_the_pin(found):
    for n, drawn in zip(found["normals"], found["ellipses"]):
        major, minor, angle, pin = formulas.ellipse(n, 20)
        assert (drawn["rx"], drawn["ry"]) == pytest.approx((major, minor))
        assert drawn["pin"] == pytest.approx((pin[0], -pin[1]))
        # The axis ry, downwards before it is turned, is the minor one.
        turned = np.radians(drawn["turn"] + 90)
        assert abs(np.cos(turned) * np.cos(angle) - np.sin(turned) * np.sin(angle)) == pytest.approx(1)


def test_sets_are_those_of_the_analysis(found):
    for count, sets in zip(COUNTS, found["sets"]):
        assert [[part.start, part.stop] for part in formulas.sets(count)] == sets
    for strings, sets in zip(STRINGS, found["strings"]):
        assert [[part.start, part.stop] for part in formulas.sets(200, strings)] == sets


def test_a_session_is_a_set_of_gauges_twice_each_time_in_an_order_of_its_own(found):
    lines = [json.loads(line) for line in found["lines"].splitlines()]
    part = formulas.sets(45)[1]
    own = list(range(part.start, part.stop))
    first, again = lines[: len(own)], lines[len(own) :]
    for repeat, half in enumerate((first, again)):
        assert sorted(line["gauge"] for line in half) == own and {line["repeat"] for line in half} == {repeat}
        assert [line["gauge"] for line in half] != own
    assert [line["gauge"] for line in first] != [line["gauge"] for line in again]
    assert [line["order"] for line in lines] == list(range(len(lines)))


def test_lines_have_what_is_known_of_a_setting(found):
    line = json.loads(found["lines"].splitlines()[7])
    assert set(line) == set(
        "study build stimulus style model participant session order gauge x y repeat n ms start device".split()
    )
    assert (line["study"], line["stimulus"], line["style"], line["session"]) == ("abc", "1", "a", 1)
    assert (line["x"], line["y"]) == (10.5 * line["gauge"], 7.0 * line["gauge"])
    assert line["n"] == pytest.approx(formulas.dragged((7, 3), 20), abs=1e-5) and line["ms"] == 1000
    assert np.linalg.norm(line["start"]) == pytest.approx(1, abs=1e-5) and line["start"][2] > 0


def test_a_gauge_that_is_not_touched_is_not_set_and_one_can_go_back(found):
    saved = [each for each in found["log"] if not isinstance(each, bool)]
    assert saved == [10] and True not in [each for each in found["log"] if isinstance(each, bool)]
    fifth = json.loads(found["lines"].splitlines()[4])
    assert fifth["n"] == [0, 0, 1] and fifth["ms"] == 1500 and found["back"] is True


def test_pictures_with_fewer_sessions_are_likelier(found):
    assert np.array(found["counts"]) / 6000 == pytest.approx(np.array([1, 1 / 2, 1 / 4]) / 1.75, abs=0.03)


def test_gauges_begin_anywhere_on_the_hemisphere(found):
    z = np.array(found["anywhere"])[:, 2]
    assert z.min() >= np.cos(np.radians(88)) and np.quantile(z, (0.25, 0.75)) == pytest.approx((0.27, 0.76), abs=0.04)
    assert np.abs(np.mean(found["anywhere"], axis=0)[:2]).max() < 0.05


def test_the_shape_to_practice_on_has_its_normals(found):
    assert found["ellipsoid"] == pytest.approx((0.3, -0.4, np.sqrt(0.75)))
    assert np.allclose(found["example"], [shared.normal_of_example(place) for place in shared.EXAMPLE["places"]])
    assert found["off"] == pytest.approx(np.degrees(np.arccos(0.8)))


def test_the_page_is_one_file_with_its_pictures_and_without_the_truth():
    text = page.page(TOLD, {"a": b"first", "b": b"second"})
    assert text.count("data:image/png;base64,") == 2 and "Zmlyc3Q=" in text
    assert re.search("@[A-Z]+@", text) is None
    outside = re.findall(r"(?:https?:)?//[\w.]+[^\s\"]*", re.sub(r"(?m)(^|\s)// .*$", "", text))
    assert outside == ["http://www.w3.org/2000/svg"], "the name of a namespace, which nothing loads"
    assert "default-src 'none'" in text and text.count("</script>") == 1
    assert '"gauges": [[0.0, 0.0], [10.5, 7.0]' in text and '"n"' not in text and "0.6" not in text


def test_the_page_has_every_element_that_its_script_asks_for():
    text, script = page.page(TOLD, {"a": b"", "b": b""}), page.script_of("page.js")
    asked = set(re.findall(r"\$\(\"(\w+)\"\)", script)) | set(re.findall(r"show\(\"(\w+)\"\)", script))
    assert len(asked) > 12 and asked <= set(re.findall(r" id=\"(\w+)\"", text))
