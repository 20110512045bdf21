"""ciel bench: every table is there and its figures belong together. No time is judged."""

import json

import pytest

from box_dataset import write_box
from program import ciel


@pytest.fixture(scope="module")
def box(tmp_path_factory):
    return write_box(tmp_path_factory.mktemp("bench") / "box.ciel", 6)


def test_every_table(box, tmp_path):
    result = ciel("bench", box, "--array", "r", "--json", tmp_path / "bench.json")
    assert result.returncode == 0, result.stderr
    told = json.loads((tmp_path / "bench.json").read_text())
    assert [table["name"] for table in told["tables"]] == ["memory", "preprocessing", "slices", "surfaces", "volume"]
    figures = {figure["what"]: figure["value"] for figure in told["tables"][0]["figures"]}
    info = json.loads(ciel("info", box, "--json").stdout)
    assert figures["half-edges"] == info["mesh"]["half_edges"] and figures["topology"] == info["memory"]["topology_bytes"]
    rows = {row["what"]: row for table in told["tables"] for row in table["rows"]}
    for engine in ("naive", "propagation", "signatures"):
        assert rows[f"100 surfaces, {engine}"]["triangles"] == rows["100 surfaces, naive"]["triangles"] > 0
        assert rows[f"100 box-aligned, {engine}"]["triangles"] == rows["100 box-aligned, naive"]["triangles"] > 0
    for row in rows.values():
        assert row["what"] in result.stdout and row["repetitions"] > 0
        assert 0 < row["wall_seconds"]["low"] <= row["wall_seconds"]["median"] <= row["wall_seconds"]["high"]


def test_what_cannot_be_cut_is_said(box):
    result = ciel("bench", box, "--array", "nope")
    assert result.returncode == 1 and "no scalar 'nope'" in result.stderr
