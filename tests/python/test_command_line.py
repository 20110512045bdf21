"""Errors of the command line: missing, unknown or excess arguments give one line that says what to do."""

import os
import pathlib
import re

import pytest

from program import ciel

ROOT = pathlib.Path(__file__).parents[2]
COMMANDS = ["import", "info", "append", "demo", "extract", "render", "serve", "bench"]


WRONG = [
    ("no command", [], ["command is missing", *COMMANDS, "`ciel --help`"]),
    ("unknown command", ["frobnicate", "x"], ["'frobnicate'", *COMMANDS, "`ciel --help`"]),
    ("option before the command", ["--bogus", "info"], ["'--bogus'"]),
    ("unknown option", ["info", "x.ciel", "--bogus"], ["--bogus", "`ciel info --help`"]),
    ("missing value", ["render", "x.ciel", "-o"], ["--output", "`ciel render --help`"]),
    ("missing argument", ["info"], ["dataset is required", "`ciel info --help`"]),
    ("too many arguments", ["info", "x.ciel", "y.ciel"], ["y.ciel", "`ciel info --help`"]),
    ("not a number", ["extract", "x.ciel", "--time", "soon", "-o", "s.ply"], ["--time", "soon", "`ciel extract --help`"]),
    ("outside the range", ["serve", "--workers", "0"], ["--workers", "64", "`ciel serve --help`"]),
    ("not one of", ["serve", "--gl", "vulkan"], ["--gl", "vulkan", "osmesa", "`ciel serve --help`"]),
    ("no port", ["serve", "--port", "99999"], ["--port", "65535", "`ciel serve --help`"]),
    ("an empty token", ["serve", "--token", ""], ["--token", "leave --token out"]),
    ("too little to serve anybody", ["serve", "--limit-memory-bytes", "1K"], ["--limit-memory-bytes", "64 MiB"]),
    ("a limit beyond sense", ["serve", "--limit-histogram-bins", "5000"], ["--limit-histogram-bins", "4096"]),
    ("a limit without a number", ["serve", "--limit-message-bytes", "much"], ["--limit-message-bytes", "64M"]),
    ("missing company", ["append", "x.ciel", "--time", "1"], ["--time", "--array", "`ciel append --help`"]),
    ("nothing to append", ["append", "x.ciel"], ["--from", "`ciel append --help`"]),
]


@pytest.mark.parametrize("arguments,words", [row[1:] for row in WRONG], ids=[row[0] for row in WRONG])
def test_wrong_usage_is_one_line_and_exit_code_two(arguments, words):
    result = ciel(*arguments)
    assert result.returncode == 2, result.stderr
    assert result.stdout == ""
    assert result.stderr.startswith("ciel: ") and result.stderr.count("\n") == 1, result.stderr
    for word in words:
        assert word in result.stderr, result.stderr


def test_an_empty_token_of_the_environment_is_refused(tmp_path):
    result = ciel("serve", tmp_path, env={**os.environ, "CIEL_TOKEN": ""})
    assert result.returncode != 0 and "CIEL_TOKEN is empty" in result.stderr, result.stderr


def test_help_is_everywhere_and_names_the_exit_codes():
    result = ciel("--help")
    assert result.returncode == 0 and result.stderr == ""
    assert all(command in result.stdout for command in COMMANDS) and "2 wrong usage" in result.stdout
    for command in COMMANDS:
        result = ciel(command, "--help")
        assert result.returncode == 0 and result.stderr == "" and "Usage: ciel " + command in result.stdout


def test_the_help_of_serve_lists_each_limit_with_its_variable_and_default():
    text = " ".join(ciel("serve", "--help").stdout.split())
    source = (ROOT / "server/limits/limits.cpp").read_text(encoding="utf-8")
    names = re.findall(r"^    \{\"(\w+)\", &Limits::\1,", source, re.M)
    assert len(names) > 40
    for name in names:
        option, variable = "--limit-" + name.replace("_", "-"), "CIEL_LIMIT_" + name.upper()
        kind = r"(COUNT|BYTES|BYTES\|N%|PIXELS|SECONDS)"
        assert re.search(rf"{option} {kind}(=| \[).+? \(Env:{variable}\) \w", text), name
    # Depending on the release, CLI11 prints a default as =64 or [64].
    assert re.search(r"--limit-sessions COUNT(=64| \[64\]) \(Env:CIEL_LIMIT_SESSIONS\) sessions kept", text)
    assert re.search(r"--limit-message-bytes BYTES(=1 MiB| \[1 MiB\]) \(Env:CIEL_LIMIT_MESSAGE_BYTES\)", text)
    assert re.search(r"--limit-dataset-memory-bytes BYTES\|N%(=| \[)\d+ [MG]iB", text)


def test_the_version_is_one_line():
    result = ciel("--version")
    assert result.returncode == 0 and result.stdout.startswith("ciel ") and result.stdout.count("\n") == 1
