"""Fails if no CMake file names a C++ source of the server or of the tests. A test that is not listed would never run."""

import pathlib
import re
import sys

# Programs outside of the build: the suite install compiles them against an installed kernel.
ELSEWHERE = ("server/ciel/examples/", "tests/install/")


def named_in(file: pathlib.Path) -> list[pathlib.Path]:
    """Paths of the sources that a CMake file names, relative to its folder or to ${...}, the folder of the project or its own."""
    names = re.findall(r"[\w${}./-]+\.cpp", file.read_text(encoding="utf-8"))
    return [(file.parent / re.sub(r"^\$\{\w+\}/", "", name)).resolve() for name in names]


def main(root: pathlib.Path) -> int:
    folders = [root / "server", root / "tests"]
    lists = [file for folder in folders for name in ("CMakeLists.txt", "*.cmake") for file in folder.rglob(name)]
    named = {path for file in lists for path in named_in(file)}
    sources = [file for folder in folders for file in sorted(folder.rglob("*.cpp"))]
    missing = [
        str(file.relative_to(root))
        for file in sources
        if file.resolve() not in named
        and not file.with_suffix(".cmake").exists()  # a fuzz target, which the file beside it declares
        and not str(file.relative_to(root)).startswith(ELSEWHERE)
    ]
    print("\n".join(f"{file}: no CMake file names it; add it to a list" for file in missing) or f"{len(sources)} sources are listed")
    return 1 if missing else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
