"""Writes OpenFOAM cases as text: a cube of hexahedra and two polyhedra, whole or decomposed, with patches and zones."""

import itertools

import numpy as np

N = 4  # cells along each side of the unit cube

POINTS = [(i / N, j / N, k / N) for k in range(N + 1) for j in range(N + 1) for i in range(N + 1)]
CENTERS = np.array([((i + 0.5) / N, (j + 0.5) / N, (k + 0.5) / N) for k in range(N) for j in range(N) for i in range(N)])


def header(kind, name):
    return f"FoamFile\n{{\n    version 2.0;\n    format ascii;\n    class {kind};\n    object {name};\n}}\n"


def listing(rows):
    return f"{len(rows)}\n(\n" + "\n".join(rows) + "\n)\n"


def side_of(here, axis, side, point):
    """Loop of one side of the cube at `here`, wound outwards. point(i, j, k) returns the id of a corner."""
    u, v = (axis + 1) % 3, (axis + 2) % 3
    loop = []
    for du, dv in [(0, 0), (1, 0), (1, 1), (0, 1)]:
        corner = list(here)
        corner[axis] += side
        corner[u] += du
        corner[v] += dv
        loop.append(point(*corner))
    return loop if side else loop[::-1]


def mesh():
    """Faces as (owner, neighbor or patch, loop). One inner face is split in two, so its two cells are polyhedra."""
    point = lambda i, j, k: i + (N + 1) * (j + (N + 1) * k)
    cell = lambda i, j, k: i + N * (j + N * k)
    inner, outer = [], {"inlet": [], "outlet": [], "walls": []}
    for i, j, k in itertools.product(range(N), range(N), range(N)):
        here = (i, j, k)
        for axis in range(3):
            for side in (0, 1):
                loop = side_of(here, axis, side, point)
                other = list(here)
                other[axis] += 1 if side else -1
                if 0 <= other[axis] < N:
                    if side:
                        inner.append((cell(*here), cell(*other), loop))
                else:
                    patch = ("inlet", "outlet")[side] if axis == 0 else "walls"
                    outer[patch].append((cell(*here), loop))
    owner, neighbour, loop = inner.pop(N)
    inner += [(owner, neighbour, [loop[0], loop[1], loop[2]]), (owner, neighbour, [loop[0], loop[2], loop[3]])]
    inner.sort(key=lambda face: face[:2])
    return inner, outer


def field(kind, name, dimensions, internal, patches):
    rows = "".join(f"    {p} {{ {entry} }}\n" for p, entry in patches.items())
    text = lambda v: "(" + " ".join(map(repr, map(float, v))) + ")" if np.ndim(v) else repr(float(v))
    values = listing([text(v) for v in internal])
    of = "vector" if kind == "volVectorField" else "scalar"
    return (
        header(kind, name)
        + f"dimensions {dimensions};\ninternalField nonuniform List<{of}>\n{values};\nboundaryField\n{{\n{rows}}}\n"
    )


def write_mesh(poly, points, inner, outer, kinds):
    """`kinds`: for each patch, its entries in the file `boundary` except those that number its faces."""
    poly.mkdir(parents=True)
    (poly / "points").write_text(header("vectorField", "points") + listing([f"({x} {y} {z})" for x, y, z in points]))
    loops = [loop for *_, loop in inner] + [loop for faces in outer.values() for _, loop in faces]
    (poly / "faces").write_text(header("faceList", "faces") + listing([f"{len(f)}({' '.join(map(str, f))})" for f in loops]))
    owners = [o for o, *_ in inner] + [o for faces in outer.values() for o, _ in faces]
    (poly / "owner").write_text(header("labelList", "owner") + listing([str(o) for o in owners]))
    (poly / "neighbour").write_text(header("labelList", "neighbour") + listing([str(n) for _, n, _ in inner]))
    start, rows = len(inner), []
    for name, faces in outer.items():
        rows.append(f"{name} {{ {kinds[name]} nFaces {len(faces)}; startFace {start}; }}")
        start += len(faces)
    (poly / "boundary").write_text(header("polyBoundaryMesh", "boundary") + listing(rows))


def write_fields(case, centers, more_patches=()):
    """Writes U and p at the times 1 and 2 for cells with these centers."""
    processor = {name: "type processor; value uniform 0;" for name in more_patches}
    for time in (1, 2):
        folder = case / str(time)
        folder.mkdir(parents=True)
        speed = np.zeros((len(centers), 3))
        speed[:, 0] = time * centers[:, 1] * (1 - centers[:, 1])
        (folder / "U").write_text(
            field("volVectorField", "U", "[0 1 -1 0 0 0 0]", speed, {
                "inlet": "type fixedValue; value uniform (5 0 0);",
                "outlet": "type zeroGradient;",
                "walls": "type noSlip;",
                **{name: "type processor; value uniform (0 0 0);" for name in more_patches},
            }))
        (folder / "p").write_text(
            field("volScalarField", "p", "[1 -1 -2 0 0 0 0]", time + centers[:, 0], {
                "inlet": "type zeroGradient;", "outlet": "type fixedValue; value uniform 7;", "walls": "type zeroGradient;",
                **processor,
            }))


KINDS = {"inlet": "type patch;", "outlet": "type patch;", "walls": "type wall;"}


def write_control(case):
    (case / "system").mkdir(parents=True, exist_ok=True)
    (case / "system/controlDict").write_text(header("dictionary", "controlDict") + "startTime 0;\nendTime 2;\ndeltaT 1;\nwriteInterval 1;\n")
    (case / "a.foam").touch()
    return case


def write_case(case):
    inner, outer = mesh()
    write_control(case)
    write_mesh(case / "constant/polyMesh", POINTS, inner, outer, KINDS)
    write_fields(case, CENTERS)
    return case


def write_cell_zones(poly, zones):
    rows = [f"{name}\n{{\n    type cellZone;\n    cellLabels List<label>\n{listing(list(map(str, cells)))};\n}}" for name, cells in zones.items()]
    (poly / "cellZones").write_text(header("regIOobject", "cellZones") + listing(rows))


def write_regions(case, regions):
    """Writes cubes side by side, each a region with a zone of two cells. `regions`: name -> start of the cube along x."""
    write_control(case)
    (case / "constant").mkdir()
    names = " ".join(regions)
    (case / "constant/regionProperties").write_text(
        header("dictionary", "regionProperties") + f"regions\n(\n    fluid ({names})\n);\n")
    inner, outer = mesh()
    for name, begin in regions.items():
        poly = case / "constant" / name / "polyMesh"
        write_mesh(poly, [(x + begin, y, z) for x, y, z in POINTS], inner, outer, KINDS)
        write_cell_zones(poly, {"core": [0, 1]})
        write_fields(case / name, CENTERS)
        for time in ("1", "2"):
            (case / time).mkdir(exist_ok=True)
            (case / name / time).rename(case / time / name)
        (case / name).rmdir()
    return case


def write_face_zones(poly, zones):
    rows = [
        f"{name}\n{{\n    type faceZone;\n    faceLabels List<label>\n{listing(list(map(str, faces)))};\n"
        f"    flipMap List<bool>\n{listing(['0'] * len(faces))};\n}}"
        for name, faces in zones.items()
    ]
    (poly / "faceZones").write_text(header("regIOobject", "faceZones") + listing(rows))


def write_processor(case, rank, ranks, processor_of_cell, zones, baffle):
    """Writes one processor's mesh as decomposePar does: its cells, their points, and a patch for each neighboring processor."""
    inner, outer = mesh()
    between = [f for f in inner if processor_of_cell[f[0]] != processor_of_cell[f[1]]]
    for face in (between[i] for i in baffle):
        owner, neighbour, loop = face
        inner.remove(face)
        outer["walls"] += [(owner, loop), (neighbour, loop[:1] + loop[:0:-1])]
    mine = [c for c, p in enumerate(processor_of_cell) if p == rank]
    local = {c: i for i, c in enumerate(mine)}
    own_inner = [f for f in inner if f[0] in local and f[1] in local]
    own_outer = {name: [f for f in faces if f[0] in local] for name, faces in outer.items()}
    kinds = dict(KINDS)
    for other in range(ranks):
        # Both processors list shared faces in the same order. The owner's processor keeps the winding; the other
        # reverses it.
        shared = [(a, loop) for a, b, loop in inner if a in local and processor_of_cell[b] == other != rank]
        shared += [(b, loop[:1] + loop[:0:-1]) for a, b, loop in inner if b in local and processor_of_cell[a] == other != rank]
        if shared:
            name = f"procBoundary{rank}to{other}"
            own_outer[name] = shared
            kinds[name] = f"type processor; inGroups 1(processor); myProcNo {rank}; neighbProcNo {other};"
    used = sorted({p for *_, loop in own_inner for p in loop} | {p for fs in own_outer.values() for _, loop in fs for p in loop})
    point = {p: i for i, p in enumerate(used)}
    folder = case / f"processor{rank}"
    write_mesh(
        folder / "constant/polyMesh",
        [POINTS[p] for p in used],
        [(local[a], local[b], [point[p] for p in loop]) for a, b, loop in own_inner],
        {name: [(local[c], [point[p] for p in loop]) for c, loop in faces] for name, faces in own_outer.items()},
        kinds,
    )
    write_cell_zones(folder / "constant/polyMesh", {name: [local[c] for c in cells if c in local] for name, cells in zones.items()})
    write_fields(folder, CENTERS[mine], [name for name in own_outer if name.startswith("proc")])
    return len(used)


def write_decomposed(case, processor_of_cell, zones, baffle=()):
    """Returns the number of points of all processors. `baffle`: indices of faces between processors that become walls."""
    write_control(case)
    ranks = max(processor_of_cell) + 1
    return sum(write_processor(case, rank, ranks, processor_of_cell, zones, baffle) for rank in range(ranks))
