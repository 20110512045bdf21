"""The Python client's package, installed into a fresh virtual environment."""

import shutil

from conftest import ROOT, run


def test_the_client_installs_without_a_network_and_brings_its_types(tmp_path):
    source = shutil.copytree(ROOT / "protocol/python", tmp_path / "source")  # setuptools writes into the source folder
    run("/usr/bin/python3", "-m", "venv", "--system-site-packages", tmp_path / "venv")
    program = tmp_path / "venv/bin/python"
    run(program, "-m", "pip", "install", "--no-build-isolation", "--no-index", "--no-deps", source)
    shutil.rmtree(source)
    said = run(
        program, "-c", "import ciel_client, pathlib; print(pathlib.Path(ciel_client.__file__).with_name('py.typed').exists(),"
        " ciel_client.Client('http://127.0.0.1:1').picture_render.__doc__)", cwd=tmp_path
    )  # fmt: skip
    assert said.startswith("True Draws one lossless picture"), said
    code = "import importlib.metadata, ciel_client; print(importlib.metadata.version('ciel-client'), ciel_client.__version__)"
    version = (ROOT / "server/ciel/version.txt").read_text().strip()
    assert run(program, "-c", code, cwd=tmp_path).split() == [version, version]
