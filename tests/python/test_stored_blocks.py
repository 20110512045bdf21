"""The blocks on disk, read by another program: the cells, the entries of their vertices, and their half-edges."""

import collections
import itertools
import types

import numpy
import pytest
import vtk
import zarr
from program import ciel
from stored_around import entry_lists, ring
from stored_blocks import cells_of, read_blocks
from stored_bytes import array
from stored_mates import cell_faces, polyhedral_mates, twins
from vtk_files import all_types, cones, unstructured, write

# Two cells of 264,000 corners: numbers of four bytes.
GRIDS = {"all types": all_types, "giants": lambda: unstructured(*cones(66000, 0))}


@pytest.fixture(scope="module", params=["demo", *GRIDS])
def stored(request, tmp_path_factory):
    folder = tmp_path_factory.mktemp("blocks")
    grid = None
    if request.param == "demo":
        done = ciel("demo", "--coarseness", 3, "-o", folder / "a.ciel")
    else:
        grid = GRIDS[request.param]()
        done = ciel("import", write(vtk.vtkXMLUnstructuredGridWriter(), folder / "a.vtu", grid), "-o", folder / "a.ciel")
    assert done.returncode == 0, done.stderr
    mesh = zarr.open_group(str(folder / "a.ciel"), mode="r")["meshes/0"]
    bounds, tables, blocks = read_blocks(folder / "a.ciel/meshes/0/blocks")
    cells = [cell for block in blocks for cell in cells_of(block)]
    return types.SimpleNamespace(name=request.param, grid=grid, mesh=mesh, bounds=bounds, tables=tables, blocks=blocks, cells=cells)


def from_lowest(loop):
    at = numpy.argmin(loop)
    return (*loop[at:], *loop[:at])


def boundary_of(mesh):
    """Returns the owners of the boundary faces by their loops, from the arrays of Zarr."""
    begin, vertex = mesh["faces/face_offset"][:].astype("i8"), mesh["faces/face_vertex"][:]
    count = mesh.attrs["ciel"]["counts"]["boundary_faces"]
    return {from_lowest(vertex[begin[f] : begin[f + 1]]): owner for f, owner in enumerate(mesh["faces/owner"][:count])}


def test_another_program_reads_the_cells_from_their_blocks(stored):
    beside = collections.defaultdict(list)
    for cell, _, faces in stored.cells:
        for face in faces:
            beside[from_lowest(face)].append(cell)
    assert [cell for cell, _, _ in sorted(stored.cells, key=lambda of: of[0])] == list(range(stored.mesh["cell_types"].shape[0]))
    assert set(itertools.chain(*beside)) == set(range(stored.mesh["positions"].shape[1]))
    assert all(len(cells) == 1 for cells in beside.values()), "a loop is that of one cell; the cell beyond has the opposite one"
    alone = {face: cells[0] for face, cells in beside.items() if from_lowest(face[::-1]) not in beside}
    assert alone == boundary_of(stored.mesh)


@pytest.mark.parametrize("stored", GRIDS, indirect=True)
def test_the_cells_are_those_of_the_input(stored):
    vertex, original = stored.mesh["original_vertex"][:], stored.mesh["original_cell"][:]
    types_of = (vtk.VTK_TETRA, vtk.VTK_HEXAHEDRON, vtk.VTK_WEDGE, vtk.VTK_PYRAMID, vtk.VTK_POLYHEDRON)
    for cell, kind, faces in stored.cells:
        of_input = stored.grid.GetCell(int(original[cell]))
        assert of_input.GetCellType() == types_of[kind] == stored.mesh["cell_types"][cell]
        points = of_input.GetPointIds()
        assert {*vertex[numpy.concatenate(faces)]} == {points.GetId(i) for i in range(points.GetNumberOfIds())}
    assert len({kind for _, kind, _ in stored.cells}) == (5 if stored.name == "all types" else 1)


def test_the_tables_count_the_blocks(stored):
    blocks, positions = stored.blocks, stored.mesh["positions"][0]
    assert stored.bounds == [end(positions[:, axis]) for axis in range(3) for end in (numpy.min, numpy.max)]
    half_edges = [sum(len(of[2]) for of in cell_faces(block)) for block in blocks]
    ghosts = [[len(array(block.cells, section, width=2)) for block in blocks] for section in (3, 4)]
    users = numpy.bincount(numpy.concatenate([block.vertices for block in blocks]))
    edges = len(numpy.unique(numpy.concatenate([block.edges for block in blocks])))
    sums = [[block.counts[0] for block in blocks], [block.counts[1] - n for block, n in zip(blocks, ghosts[0])],
            [block.counts[2] - n for block, n in zip(blocks, ghosts[1])], [len(block.vertices) for block in blocks]]
    for section, counts in enumerate(sums, 2):
        assert array(stored.tables, section).tolist() == [0, *itertools.accumulate(counts)], section
    assert array(stored.tables, 6).tolist() == half_edges
    assert array(stored.tables, 7).tolist() == [(users[block.vertices] > 1).sum() for block in blocks]
    counts = stored.mesh.attrs["ciel"]["counts"]
    faces = sum(len(of) for _, _, of in stored.cells)
    assert array(stored.tables, 1).tolist() == [
        len(users), edges, (faces + len(boundary_of(stored.mesh))) / 2, sum(half_edges), len(boundary_of(stored.mesh)),
        len(stored.cells), counts["components"]]
    assert {block.cells[3][0] for block in blocks if 3 in block.cells} == {8 if stored.name == "giants" else 4}, "bytes of a pair"
    for block, vertex_ghosts, edge_ghosts in zip(blocks, *ghosts):
        for numbers, n, first in (block.vertices, vertex_ghosts, 3), (block.edges, edge_ghosts, 4):
            assert (numpy.diff(numbers) > 0).all() and (numbers[:n] < array(stored.tables, first)[block.number]).all()


def test_what_is_stored_twice_agrees(stored):
    """The begins of faces as bits, the cells of faces, and the parts of the block's vertices that cells and corners have."""
    for block in stored.blocks:
        part = numpy.uint64(1) << (numpy.arange(len(block.vertices)) // (8 * -(-len(block.vertices) // 512))).astype("u8")
        for kind in range(5):
            vertices, cells = array(block.cells, 56 + kind), len(block.listed(kind))
            if len(vertices):
                group = 64 if kind == 4 else 8 * (len(vertices) // cells)
                parts = numpy.bitwise_or.reduceat(part[vertices], numpy.arange(0, len(vertices), group))
                assert (array(block.cells, 38 if kind == 4 else 72 + kind).astype("u8") == parts).all()
        begin, first, of_cells = (array(block.cells, section) for section in (32, 36, 37))
        if len(begin):
            starts = numpy.unpackbits(numpy.frombuffer(block.cells[34][1], "u1"), bitorder="little")
            assert (numpy.flatnonzero(starts) == begin[:-1]).all()
            assert (array(block.cells, 35) == numpy.searchsorted(begin[:-1], 64 * numpy.arange(len(starts) // 64))).all()
            sides = array(block.cells, 33, width=2)
            cells = numpy.arange(len(first) - 1).repeat(numpy.diff(first))
            assert (sides[of_cells // 2, of_cells % 2] == cells).all()
            inner, foreign = block.counts[5], numpy.searchsorted(begin, block.counts[4])
            assert (begin[inner], begin[foreign]) == (block.counts[3], block.counts[4])
            assert sorted(of_cells) == [*range(2 * inner), *range(2 * inner, 2 * foreign, 2), *range(2 * foreign + 1, 2 * len(sides), 2)]
            assert (sides[inner:, 0] == sides[inner:, 1]).all()


def test_an_edge_has_one_number(stored):
    rows = []
    for block in stored.blocks:
        for _, _, _, vertices, edges in cell_faces(block):
            ends = block.vertices[vertices]
            rows.append(numpy.stack([block.edges[edges], ends, numpy.roll(ends, -1)]))
    edge, *ends = numpy.concatenate(rows, axis=1)
    lowest, highest = numpy.minimum(*ends), numpy.maximum(*ends)
    known = numpy.unique(numpy.stack([edge, lowest, highest]), axis=1)
    assert (known[0] == numpy.arange(array(stored.tables, 1)[1])).all()
    assert len(numpy.unique(known[1:], axis=1)[0]) == len(known[0])


def cells_of_entries(block):
    """Returns the cells with each corner of the block: one, or the two beside the face of a polyhedron."""
    cells = []
    for kind in range(4):
        listed = block.listed(kind)
        corners = len(array(block.cells, 56 + kind)) // max(len(listed), 1)
        cells.append(numpy.stack([listed.repeat(corners)] * 2, axis=1))
    sides = array(block.cells, 33, width=2).repeat(numpy.diff(array(block.cells, 32)), axis=0)
    return block.first_cell + numpy.concatenate([*cells, block.listed(4)[sides]])


def test_the_entries_of_a_vertex_lead_to_all_its_cells(stored):
    expected = collections.defaultdict(set)
    for cell, _, faces in stored.cells:
        for vertex in numpy.concatenate(faces):
            expected[vertex].add(cell)
    around = []
    for block in stored.blocks:
        corners, cells = numpy.concatenate([array(block.cells, 56 + kind) for kind in range(5)]), cells_of_entries(block)
        lists = entry_lists(block)
        assert sorted(itertools.chain(*lists)) == list(range(len(corners))), "each corner is in one list"
        for vertex, entries in enumerate(lists):
            assert (corners[entries] == vertex).all() and sorted(entries) == entries
        around.append([set(cells[entries].ravel()) for entries in lists])
    users = numpy.bincount(numpy.concatenate([block.vertices for block in stored.blocks]))
    rings = [[of.tolist() for of in ring(block)] for block in stored.blocks]
    found = collections.defaultdict(set)
    for block, (border, _, _) in zip(stored.blocks, rings):
        assert border == numpy.flatnonzero(users[block.vertices] > 1).tolist()
        for local in numpy.flatnonzero(users[block.vertices] == 1):
            found[block.vertices[local]] = around[block.number][local]
        for place in range(len(border)):
            vertex, passed, at = block.vertices[border[place]], [], (block.number, place)
            while at not in passed:
                passed.append(at)
                at = rings[at[0]][1][at[1]], rings[at[0]][2][at[1]]
            blocks, locals_there = [b for b, _ in passed], [rings[b][0][i] for b, i in passed]
            assert at == (block.number, place) and {stored.blocks[b].vertices[i] for b, i in zip(blocks, locals_there)} == {vertex}
            assert len(set(blocks)) == users[vertex] and sum(b > a for a, b in zip(blocks, blocks[1:])) >= len(blocks) - 2
            found[vertex] = set().union(*(around[b][i] for b, i in zip(blocks, locals_there)))
    assert found == expected


def test_mates_of_polyhedra_have_the_same_edge_in_another_face_of_the_cell(stored):
    listed = 0
    for block in stored.blocks:
        ends, places = {}, {}
        for i, (kind, cell, half_edges, vertices, _) in enumerate(cell_faces(block)):
            for half_edge, begin, end in zip(half_edges, vertices, numpy.roll(vertices, -1)) if kind == 4 else ():
                ends[half_edge], places[half_edge] = (cell, begin, end), i
        mates = dict(polyhedral_mates(block))
        assert mates.keys() == ends.keys()
        for half_edge, mate in mates.items():
            cell, begin, end = ends[half_edge]
            assert ends[mate] == (cell, end, begin) and mates[mate] == half_edge and places[mate] != places[half_edge]
        listed += len(array(block.mates, 20, width=2))
    assert (listed > 0) == (stored.name != "demo"), "mates beyond 256 corners are listed"


def test_twins_have_the_same_face_in_the_cell_beyond(stored):
    loops, cells, places = [], [], {}
    for block in stored.blocks:
        numbers = []
        for _, cell, half_edges, vertices, _ in cell_faces(block):
            places |= {(block.number, half_edge): (len(loops), place) for place, half_edge in enumerate(half_edges.tolist())}
            loops.append(block.vertices[vertices])
            cells.append(block.first_cell + cell)
            numbers += half_edges.tolist()
        assert sorted(numbers) == list(range(len(numbers)))
    beyond, alone = {}, {}
    for block in stored.blocks:
        for half_edge, twin in twins(block):
            face, place = places[block.number, half_edge]
            if twin is None:
                alone[from_lowest(loops[face])] = cells[face]
                continue
            other, there = places[twin]
            beyond[face] = other
            assert (numpy.roll(loops[face], -place) == numpy.roll(numpy.roll(loops[other], -there)[::-1], 2)).all()
            assert cells[other] != cells[face]
    assert all(beyond[other] == face for face, other in beyond.items()) and len(beyond) + len(alone) == len(loops)
    assert alone == boundary_of(stored.mesh)


def test_the_boundary_faces_of_a_block_are_consecutive(stored):
    """The index has no first boundary face of a block: owners are in ascending order."""
    owner = stored.mesh["faces/owner"][: stored.mesh.attrs["ciel"]["counts"]["boundary_faces"]]
    first = numpy.searchsorted(owner, array(stored.tables, 2))
    assert numpy.diff(first).tolist() == [sum(twin is None for _, twin in twins(block)) for block in stored.blocks]
