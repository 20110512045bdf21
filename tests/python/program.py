"""Runs the `ciel` program for the tests."""

import os
import pathlib
import subprocess

CIEL = os.environ.get("CIEL_BINARY", str(pathlib.Path(__file__).parents[2] / "build" / "ciel"))
CIEL_IMPORT = os.environ.get("CIEL_IMPORT_BINARY", CIEL + "-import")


def ciel(*arguments, **options):
    return subprocess.run([CIEL, *map(str, arguments)], capture_output=True, encoding="utf-8", **options)
