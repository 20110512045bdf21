"""ciel bench prints every table with consistent figures. No time is checked."""

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
    assert [table["name"] for table in told["tables"]] == ["memory", "preprocessing", "slices", "surfaces"]
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


def test_what_pictures_cost(box, tmp_path):
    result = ciel("bench", box, "--array", "r", "--render", "--table", "memory", "--json", tmp_path / "bench.json")
    assert result.returncode == 0, result.stderr
    assert [line for line in result.stdout.splitlines()[1:] if line[0] != " "] == ["memory", "frames", "volume"]
    tables = {table["name"]: table for table in json.loads((tmp_path / "bench.json").read_text())["tables"]}
    assert list(tables) == ["memory", "frames", "volume"]
    rows = {row["what"]: row for table in tables.values() for row in table.get("rows", [])}
    changes = ["iso-value", "slice along x", "camera around an iso-surface", "camera around a volume",
               "still of an iso-surface", "still of a volume"]
    for change in changes:
        stages = [rows[f"{change}: {stage}"] for stage in ("extract", "upload", "draw", "read", "PNG")]
        assert all(stage["repetitions"] >= 3 for stage in stages)
        assert rows[change]["note"].endswith(" kB")
        assert (rows[change].get("triangles", 0) > 0) == ("volume" not in change)
    for light in ("shaded", "unshaded"):
        assert rows[f"preview, {light}, draw"]["triangles"] < rows[f"box-aligned, {light}, draw"]["triangles"]
        assert rows[f"screen-aligned, {light}, draw"]["triangles"] > 0
    figures = {figure["what"]: figure["value"] for figure in tables["volume"]["figures"]}
    for of in ("box-aligned", "screen-aligned", "preview"):
        assert 5 < figures[f"{of}: picture covered"] < 95
    # A ray through the box's center meets most of the slices; in a preview, every fifth of them.
    assert 20 < figures["box-aligned: samples a covered pixel"] < 100
    assert 4 < figures["preview: samples a covered pixel"] < 20
    assert figures["preview: samples"] < figures["box-aligned: samples"] / 15


def test_what_cannot_be_cut_is_said(box):
    result = ciel("bench", box, "--array", "nope")
    assert result.returncode == 1 and "no scalar 'nope'" in result.stderr
