"""Benchmarks measure what a render does: they hook into it, and notice when there is nothing to hook into."""

import json
import sys
from pathlib import Path

from the_addon import part

sys.path.insert(0, str(Path(__file__).parents[2] / "blender_scripts"))

from bench import agreement


def test_agreement_judges_the_samples_of_a_render(tmp_path, monkeypatch):
    methods = part("pipeline").METHODS
    monkeypatch.setitem(methods, "exact", methods["exact"])  # taken back afterwards
    out = tmp_path / "rows.json"
    agreement.main(out, "boxes:2", "--size", "160x120")
    rows = json.loads(out.read_text())
    assert [(row["probes"], row["depth_scale"]) for row in rows] == list(agreement.METHODS)
    assert all(row["samples"] > 100 and row["all"]["agree"] > 0.95 for row in rows)
