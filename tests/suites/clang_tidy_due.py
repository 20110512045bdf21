"""Prints, for each source of server/ that clang-tidy has to read, its path and the key under which a pass is remembered."""

import hashlib
import json
import os
import pathlib
import re
import subprocess
import sys


def includes() -> dict[str, list[str]]:
    """What each object was made from, as the compiler told ninja."""
    found, files = {}, []
    for line in subprocess.run(["ninja", "-C", "build", "-t", "deps"], capture_output=True, text=True).stdout.splitlines():
        if line.startswith("    "):
            files.append(line.strip())
        elif ": #deps" in line:
            files = found.setdefault(line.split(": #deps")[0], [])
    return found


def state(file: str, known: dict[str, str]) -> str:
    """Of a file of ours its content, of the system's its size and time."""
    if file not in known:
        path = pathlib.Path("build", file)
        ours = path.resolve().is_relative_to(pathlib.Path.cwd())
        stat = path.stat()
        known[file] = hashlib.sha256(path.read_bytes()).hexdigest() if ours else f"{stat.st_size} {stat.st_mtime_ns}"
    return known[file]


def main(cache: pathlib.Path) -> None:
    entries = json.load(open("build/compile_commands.json"))
    for entry in entries:  # clang cannot read what g++ precompiled; the sources include all they need themselves
        entry["command"] = re.sub(r" -Winvalid-pch -include \S+/cmake_pch\.hxx", "", entry["command"])
    os.makedirs("build/clang-tidy", exist_ok=True)
    json.dump(entries, open("build/clang-tidy/compile_commands.json", "w"))
    made_from, known = includes(), {}
    checks = os.environ["checks"] + pathlib.Path(".clang-tidy").read_text()
    for entry in entries:
        if not entry["file"].startswith(f"{pathlib.Path.cwd()}/server/"):
            continue
        made = made_from.get(re.search(r" -o (\S+)", entry["command"]).group(1), [])
        parts = [checks, entry["command"]] + [state(file, known) for file in made]
        key = hashlib.sha256("\n".join(parts).encode()).hexdigest()
        if not made or not (cache / key).exists():
            print(entry["file"], key, sep="\n")


main(pathlib.Path(sys.argv[1]))
