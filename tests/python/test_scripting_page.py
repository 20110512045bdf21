"""Runs the programs in protocol/python/README.md."""

import pathlib
import re

import pytest

import box_dataset
from ciel_client import Client
from serve_process import Server

PAGE = pathlib.Path(__file__).parents[2] / "protocol/python/README.md"


@pytest.fixture
def shown(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with Server(box_dataset.write_box(tmp_path / "box.ciel")) as running:
        names: dict = {}
        for program in re.findall(r"```python\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.S):
            exec(compile(program.replace("127.0.0.1:8080", f"127.0.0.1:{running.port}"), str(PAGE), "exec"), names)
        yield names, Client(f"http://127.0.0.1:{running.port}")


def test_each_program_runs_and_writes_its_file(shown, tmp_path):
    names, client = shown
    assert (tmp_path / "picture.png").read_bytes()[:4] == b"\x89PNG"
    assert (tmp_path / "slice.ply").read_bytes()[:3] == b"ply"
    assert names["still"][:4] == b"\x89PNG"
    assert names["there"]["hit"]
    assert names["stages"][0] == "surfaces 0/1"
    assert client.scene_get(session=names["session"])["can_redo"]


def test_every_method_of_the_contract_is_a_function(shown):
    _, client = shown
    for method in client.rpc_discover()["methods"]:
        assert callable(getattr(client, method["name"].replace(".", "_")))
