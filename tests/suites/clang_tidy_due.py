"""Groups the sources of server/ that clang-tidy has to check, and prints the names of the groups, without an extension.

NAME.cpp includes all sources of a group, so that clang-tidy reads their shared headers once. NAME.list has the path of each
source, and the key under which a pass is remembered.
"""

import collections
import hashlib
import json
import os
import pathlib
import re
import subprocess
import sys


def includes() -> dict[str, list[str]]:
    """Maps each object file to the files that it was compiled from, by ninja's dependency log."""
    found, files = {}, []
    for line in subprocess.run(["ninja", "-C", "build", "-t", "deps"], capture_output=True, text=True).stdout.splitlines():
        if line.startswith("    "):
            files.append(line.strip())
        elif ": #deps" in line:
            files = found.setdefault(line.split(": #deps")[0], [])
    return found


def state(file: str, known: dict[str, str]) -> str:
    """State of a file: the content of a project file, or the size and time of a system file."""
    if file not in known:
        path = pathlib.Path("build", file)
        ours = path.resolve().is_relative_to(pathlib.Path.cwd())
        stat = path.stat()
        known[file] = hashlib.sha256(path.read_bytes()).hexdigest() if ours else f"{stat.st_size} {stat.st_mtime_ns}"
    return known[file]


def flags(entry: dict[str, str]) -> str:
    """The compiler flags of a source, which all sources of one group must share."""
    return re.sub(r" -(MT|MF|o|c) \S+", "", entry["command"])


def write_group(name: str, due: list[tuple[dict[str, str], str]]) -> dict[str, str]:
    first = due[0][0]
    pathlib.Path(name + ".cpp").write_text("".join(f'#include "{entry["file"]}"\n' for entry, _ in due))
    pathlib.Path(name + ".list").write_text("".join(f"{entry['file']} {key}\n" for entry, key in due))
    command = first["command"].replace(f" -c {first['file']}", f" -c {name}.cpp")
    return {"directory": first["directory"], "file": f"{name}.cpp", "command": command}


def main(cache: pathlib.Path, group_size: int) -> None:
    entries = json.load(open("build/compile_commands.json"))
    for entry in entries:  # clang cannot read g++'s precompiled header. The sources include everything that they need.
        entry["command"] = re.sub(r" -Winvalid-pch -include \S+/cmake_pch\.hxx", "", entry["command"])
    made_from, known = includes(), {}
    release = subprocess.run(["clang-tidy", "--version"], capture_output=True, text=True, check=True).stdout
    checks = release + os.environ["checks"] + pathlib.Path(".clang-tidy").read_text()
    alike = collections.defaultdict(list)
    for entry in sorted(entries, key=lambda entry: entry["file"]):
        if not entry["file"].startswith(f"{pathlib.Path.cwd()}/server/"):
            continue
        made = made_from.get(re.search(r" -o (\S+)", entry["command"]).group(1), [])
        parts = [checks, entry["command"].replace(str(pathlib.Path.cwd()), ".")] + [state(file, known) for file in made]
        mark = cache / hashlib.sha256("\n".join(parts).encode()).hexdigest()
        if made and mark.exists():
            mark.touch()
        else:
            alike[flags(entry)].append((entry, mark.name))
    folder = pathlib.Path("build/clang-tidy").resolve()
    folder.mkdir(exist_ok=True)
    for due in alike.values():
        for begin in range(0, len(due), group_size):
            name = f"{folder}/{hashlib.sha256(due[begin][0]['file'].encode()).hexdigest()[:16]}"
            entries.append(write_group(name, due[begin : begin + group_size]))
            print(name)
    json.dump(entries, open(folder / "compile_commands.json", "w"))


main(pathlib.Path(sys.argv[1]), int(sys.argv[2]))
