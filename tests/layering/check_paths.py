"""Fails if server/README.md names a file, a folder or a test that does not exist. Paths are relative to the root or to server/."""

import pathlib
import re
import subprocess
import sys

PAGE = "server/README.md"
# A path has a slash and no blank; `*` stands for any name.
PATH = re.compile(r"`([\w.*-]+/[\w./*-]*)`")
# Suite.Test of GTest or ctest, or a test of Python. `*` stands for all tests of a suite.
TEST = re.compile(r"`(\w+)\.(\w+|\*)`|`(test_\w+)`")
RULES = "## Rules that always hold"


def names_of_tests(root: pathlib.Path) -> set[tuple[str, str]]:
    """Pairs of suite and test; the suite of a test of Python is empty."""
    listed = subprocess.run(["git", "-C", root, "ls-files", "tests"], capture_output=True, text=True, check=True).stdout.split()
    texts = [(root / name).read_text(encoding="utf-8") for name in listed
             if name.endswith((".cpp", ".py")) and (root / name).is_file()]
    tests = {pair for text in texts for pair in re.findall(r"\bTEST(?:_F|_P)?\((\w+), (\w+)\)", text)}
    tests |= {("", name) for text in texts for name in re.findall(r"\bdef (test_\w+)\(", text)}
    tests |= {("fuzz_replay", pathlib.Path(name).stem) for name in listed if name.startswith("tests/fuzz/")}
    return tests


def main(root: pathlib.Path) -> int:
    text = (root / PAGE).read_text(encoding="utf-8")
    rules_begin = text[:text.index(RULES)].count("\n") + 1
    tests = names_of_tests(root)
    problems, paths, named = [], 0, 0
    for number, line in enumerate(text.splitlines(), 1):
        for path in PATH.findall(line):
            paths += 1
            if not any(next((root / base).glob(path.rstrip("/")), None) for base in ("", "server")):
                problems.append(f"{PAGE}:{number}: {path} does not exist; correct the path")
        for suite, test, of_python in TEST.findall(line) if number > rules_begin else []:
            named += 1
            known = any(of == suite for of, _ in tests) if test == "*" else (suite, test or of_python) in tests
            if not known:
                problems.append(f"{PAGE}:{number}: there is no test {suite}.{test}{of_python}; correct the name")
    print("\n".join(problems) or f"{paths} paths and {named} tests in {PAGE} exist")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
