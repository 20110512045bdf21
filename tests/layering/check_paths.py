"""Fails if server/README.md names a file or folder that does not exist. Paths are relative to the root or to server/."""

import pathlib
import re
import sys

# A path has a slash and no blank; `*` stands for any name.
PATH = re.compile(r"`([\w.*-]+/[\w./*-]*)`")


def main(root: pathlib.Path) -> int:
    page = "server/README.md"
    problems, count = [], 0
    for number, line in enumerate((root / page).read_text(encoding="utf-8").splitlines(), 1):
        for path in PATH.findall(line):
            count += 1
            if not any(next((root / base).glob(path.rstrip("/")), None) for base in ("", "server")):
                problems.append(f"{page}:{number}: {path} does not exist; correct the path")
    print("\n".join(problems) or f"{count} paths in {page} exist")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
