"""Fails on files of more than 500 lines, and on functions of more than 60 lines in server/ (CONTRIBUTING.md).

clang-format makes a function end with the first line that is only a brace and is indented
like its first line.
"""

import pathlib
import re
import subprocess
import sys

MOST_LINES = 500  # of a file
MOST_OF_FUNCTION = 60
SOURCES = {".cpp", ".hpp", ".ts", ".tsx", ".py", ".css"}
# Generated, or a list of the same few lines.
LEFT_OUT = {"protocol/python/ciel_client/schemas.py", "protocol/python/ciel_client/methods.py"}
# The last line before the body of a function or of a named lambda.
OPENS = re.compile(r"(\s*)\S.*\)( const)?( noexcept)?( override)?( -> .*)? \{|(\s*): .*\{")
NO_FUNCTION = re.compile(r"\s*(\[|\}|(if|for|while|switch|else|catch|do)\b)")


def functions(lines: list[str]):
    """Yields the number of the first line of each function's body, and the number of its lines."""
    for at, line in enumerate(lines):
        opens = OPENS.fullmatch(line)
        if opens is None or NO_FUNCTION.match(line):
            continue
        indent = len(line) - len(line.lstrip()) - (4 if line.lstrip().startswith(":") else 0)
        end = next((i for i in range(at + 1, len(lines)) if lines[i].rstrip(";),") == " " * indent + "}"), at)
        yield at + 1, end - at + 1


def main(root: pathlib.Path) -> int:
    names = subprocess.run(["git", "-C", root, "ls-files"], capture_output=True, text=True, check=True).stdout.split("\n")
    problems = []
    for name in names:
        path = root / name
        if path.suffix not in SOURCES or name in LEFT_OUT or not path.is_file():
            continue
        lines = path.read_text(encoding="utf-8").splitlines()
        if len(lines) > MOST_LINES:
            problems.append(f"{name}: {len(lines)} lines; make two units of it ({MOST_LINES} at most)")
        if not name.startswith("server/") or path.suffix not in {".cpp", ".hpp"}:
            continue
        problems += [
            f"{name}:{first}: a function of {count} lines; {MOST_OF_FUNCTION} at most"
            for first, count in functions(lines)
            if count > MOST_OF_FUNCTION
        ]
    print("\n".join(problems) or f"no file and no function of {len(names)} files is too long")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
