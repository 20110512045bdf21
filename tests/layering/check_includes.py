"""Fails when an include crosses an edge that CMake does not declare, or when a library of the outside world leaks."""

import pathlib
import re
import sys

# Which folder may include which part of the outside world.
OUTSIDE = {
    "boost/": {"gateway"},
    "GL/": {"render"},
    "EGL/": {"render"},
    "vtk": {"import"},
    "png.h": {"wire"},
    "meshoptimizer.h": {"wire"},
    "ft2build.h": {"render"},
    "tbb/": {"ciel"},
    "voro++": {"demo"},
    "CLI/": {"app", "import"},
    "nlohmann/": {"store", "scene", "session", "methods", "gateway", "app", "import"},
}
PROGRAMS = {"app", "import"}  # nothing may include these


def main(server: pathlib.Path, edges_file: pathlib.Path) -> int:
    edges = {tuple(line.split()) for line in edges_file.read_text().splitlines()}
    folders = {path.name for path in server.iterdir() if path.is_dir()}
    problems = []
    for source in sorted(server.rglob("*.[ch]pp")):
        folder = source.relative_to(server).parts[0]
        for number, line in enumerate(source.read_text().splitlines(), 1):
            match = re.match(r'\s*#\s*include\s*[<"]([^>"]+)[>"]', line)
            if not match:
                continue
            name = match.group(1)
            where = f"{source}:{number}"
            other = name.split("/")[0]
            if "/" in name and other in folders and other != folder:
                if other in PROGRAMS:
                    problems.append(f"{where}: {name}: {other}/ is a program; nothing includes it")
                elif (folder, other) not in edges:
                    problems.append(f"{where}: {name}: CMake declares no link {folder} -> {other}")
            for prefix, allowed in OUTSIDE.items():
                if name.startswith(prefix) and folder not in allowed:
                    problems.append(f"{where}: {name}: only {', '.join(sorted(allowed))} may include it")
    print("\n".join(problems) or f"{len(folders)} folders, every include follows a declared link")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])))
