"""Fails when an include crosses an edge that CMake does not declare, goes up in a room's order of folders, or takes a
library of the outside world into another room, when the declared edges form a circle, when a room above the store reads
the face lists of a mesh, when a private name of the kernel is not in ciel::detail or is used elsewhere, when a room opens
the kernel's namespace, or when a unit test opens the namespace of a room that it does not test."""

import graphlib
import pathlib
import re
import sys

# External include prefixes, and the rooms that may use them.
OUTSIDE = {
    "boost/": {"gateway"},
    "GL/": {"render"},
    "EGL/": {"render"},
    "vtk": {"import"},
    "png.h": {"wire"},
    "meshoptimizer.h": {"wire"},
    "ft2build.h": {"fonts"},
    "fontconfig/": {"fonts"},
    "tbb/": {"ciel"},
    "thread": {"ciel", "engine", "gateway", "importing", "limits", "render", "store"},  # who starts threads, or sleeps
    "voro++": {"demo"},
    "CLI/": {"app", "import"},
    "spdlog/": {"logging", "gateway", "app"},
    "nlohmann/": {
        "store",
        "scene",
        "logging",
        "geometry",
        "probe",
        "frames",
        "sessions",
        "engine",
        "methods",
        "gateway",
        "app",
        "import",
    },
}
# Face lists of a mesh, and every function that returns a view of them: a view in an `auto` variable names no type. Rooms
# above the store ask store/mesh_questions.hpp, LoadedDataset, ScalarField and ciel/cell_locator.hpp instead.
FACE_LISTS = re.compile(
    r"\bFaceMesh(?:View)?\b|\bmesh_arrays\b|\bMeshArrays\b|\bface_mesh_view\b|\bwith_faces\b|(?:\.|->)stored\(\)"
    r"|\.loop\(|\.neighbour\b|\.owner\[|\bface_(?:offset|vertex)\b"
)
WITH_FACE_LISTS = {"ciel", "store", "import", "demo", "bench"}
PROGRAMS = {"app", "import"}  # no room may include these
KERNEL_SOURCES = pathlib.Path("ciel/src")  # an include root of the kernel only
# Private names of the kernel: its public headers declare some, and some tests have KERNEL_SOURCES as an include root.
# Another library's `detail` has that library's name before it.
PRIVATE_NAMES = re.compile(r"(?<!::)\bdetail::|\bciel::detail\b")
WITH_PRIVATE_NAMES = (
    "server/ciel/include",
    "server/ciel/src",
    "tests/allocations",
    "tests/oracle",
    "tests/unit/ciel",
)
# What may begin in the first column in a header of KERNEL_SOURCES while `namespace ciel` is open: nested classes of
# public classes, their access labels, and comments. All else is in ciel::detail.
IN_PUBLIC_NAMESPACE = re.compile(r"(?:struct|class) \w+::\w+ \{$|(?:public|protected|private):$|\}|//|\s|$")
INCLUDE = re.compile(r'\s*#\s*include\s*[<"]([^>"]+)[>"]')


def read_declared(edges_file):
    """Reads the links between rooms and the order of each room's folders, from below. "." is the room itself."""
    edges, orders = set(), {}
    for line in edges_file.read_text().splitlines():
        first, *rest = line.split()
        if first == "folders":
            orders[rest[0]] = rest[1:]
        else:
            edges.add((first, rest[0]))
    return edges, orders


def place_of(path):
    """Returns (room, folder in the room) for a path relative to server/."""
    room, *folders = path.parent.parts
    return room, "/".join(folders) or "."


def circle_in(edges):
    """Returns the rooms of a circle of links, as a sentence; nothing if all links go downwards."""
    links = graphlib.TopologicalSorter()
    for room, lower in edges:
        links.add(room, lower)
    try:
        links.prepare()
    except graphlib.CycleError as error:
        return [f"links between rooms form a circle: {' -> '.join(reversed(error.args[1]))}"]
    return []


def wrong_namespaces(server):
    """Returns a sentence for each line that declares a private name of the kernel in ciel, or uses one elsewhere."""
    problems = []
    for header in sorted((server / KERNEL_SOURCES).rglob("*.hpp")):
        is_public = False
        for number, line in enumerate(header.read_text().splitlines(), 1):
            if line.startswith("namespace "):
                is_public = line != "namespace ciel::detail {"
            elif line.startswith("} // namespace"):
                is_public = False
            elif is_public and not IN_PUBLIC_NAMESPACE.match(line):
                problems.append(f"{header}:{number}: {line}: move it to namespace ciel::detail")
    root = server.parent
    for source in sorted([*server.rglob("*.[ch]pp"), *(root / "tests").rglob("*.[ch]pp")]):
        if source.relative_to(root).as_posix().startswith(tuple(f"{folder}/" for folder in WITH_PRIVATE_NAMES)):
            continue
        problems += [
            f"{source}:{number}: {match.group(0)}: only {', '.join(WITH_PRIVATE_NAMES)} use private names of the kernel"
            for number, line in enumerate(source.read_text().splitlines(), 1)
            if (match := PRIVATE_NAMES.search(line))
        ]
    return problems


def rooms_in_the_kernel(server):
    """Returns a sentence for each line with which a room opens the kernel's namespace. Rooms are in server::ROOM."""
    return [
        f"{source}:{number}: {line}: only the kernel opens namespace ciel; a room's names are in server::ROOM"
        for source in sorted(server.rglob("*.[ch]pp"))
        if source.relative_to(server).parts[0] != "ciel"
        for number, line in enumerate(source.read_text().splitlines(), 1)
        if re.match(r"(?:inline )?namespace ciel\b(?!.*=)", line)
    ]


def misplaced_tests(root):
    """Returns a sentence for each unit test that opens the namespace of another room than that of its folder."""
    names = {"import": "importer"}  # `import` is a reserved word of C++20
    return [
        f"{source}:{number}: {line}: this folder tests the room {source.relative_to(root / 'tests/unit').parts[0]}"
        for source in sorted((root / "tests/unit").rglob("*.[ch]pp"))
        for number, line in enumerate(source.read_text().splitlines(), 1)
        if (opened := re.match(r"namespace server::(\w+)", line))
        and opened.group(1) != names.get(room := source.relative_to(root / "tests/unit").parts[0], room)
    ]


def main(server: pathlib.Path, edges_file: pathlib.Path) -> int:
    edges, orders = read_declared(edges_file)
    rooms = {path.name for path in server.iterdir() if path.is_dir()}
    problems = circle_in(edges) + wrong_namespaces(server) + rooms_in_the_kernel(server) + misplaced_tests(server.parent)
    for source in sorted(server.rglob("*.[ch]pp")):
        relative = source.relative_to(server)
        room, folder = place_of(relative)
        order = orders.get(room, ["."])
        if folder not in order:
            problems.append(f"{source}: server/{room}/CMakeLists.txt does not name {folder}/ in ciel_folders")
            continue
        for number, line in enumerate(source.read_text().splitlines(), 1):
            if room not in WITH_FACE_LISTS and (word := FACE_LISTS.search(line)):
                problems.append(f"{source}:{number}: {word.group(0)}: only {', '.join(sorted(WITH_FACE_LISTS))} read face lists")
            match = INCLUDE.match(line)
            if not match:
                continue
            name = match.group(1)
            where = f"{source}:{number}"
            for prefix, allowed in OUTSIDE.items():
                if name.startswith(prefix) and room not in allowed:
                    problems.append(f"{where}: {name}: only {', '.join(sorted(allowed))} may include it")
            other = pathlib.Path(name)
            if other.parts[:2] == KERNEL_SOURCES.parts:
                problems.append(f"{where}: {name}: only server/ciel/include is for others")
            if room == "ciel" and (server / KERNEL_SOURCES / other).exists():
                other = KERNEL_SOURCES / other
            elif other.parts[0] == "ciel":
                other = pathlib.Path("ciel/include") / other
            if len(other.parts) < 2 or other.parts[0] not in rooms:
                continue
            other_room, other_folder = place_of(other)
            if other_room == room:
                if other_folder in order and order.index(other_folder) > order.index(folder):
                    problems.append(f"{where}: {name}: {other_folder} lies above {folder} in {room}/")
            elif other_room in PROGRAMS:
                problems.append(f"{where}: {name}: {other_room}/ is a program; nothing includes it")
            elif (room, other_room) not in edges:
                problems.append(f"{where}: {name}: CMake declares no link {room} -> {other_room}")
    print("\n".join(problems) or f"{len(rooms)} rooms, every include follows a declared link")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])))
