"""Reads what wire/ wrote with software that is not ours: Python's zlib for PNG, VTK's readers for surfaces."""

import pathlib
import struct
import subprocess
import sys
import tempfile
import zlib

import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy


def decode_png(data: bytes) -> bytes:
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    at, compressed, width, height = 8, b"", 0, 0
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at : at + 8])
        body = data[at + 8 : at + 8 + length]
        (checksum,) = struct.unpack(">I", data[at + 8 + length : at + 12 + length])
        assert checksum == zlib.crc32(kind + body)
        if kind == b"IHDR":
            width, height, depth, color, _, _, interlace = struct.unpack(">IIBBBBB", body)
            assert (depth, color, interlace) == (8, 2, 0)
        compressed += body if kind == b"IDAT" else b""
        at += 12 + length
    raw = zlib.decompress(compressed)
    stride = 3 * width
    rows, above = [], bytearray(stride)
    for y in range(height):
        kind, line = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1 : (y + 1) * (stride + 1)])
        for i in range(stride):
            left = line[i - 3] if i >= 3 else 0
            corner = above[i - 3] if i >= 3 else 0
            line[i] = (line[i] + prediction(kind, left, above[i], corner)) & 255
        rows.append(bytes(line))
        above = line
    return b"".join(rows)


def prediction(kind: int, left: int, up: int, corner: int) -> int:
    if kind == 4:
        estimate = left + up - corner
        distances = (abs(estimate - left), abs(estimate - up), abs(estimate - corner))
        return (left, up, corner)[distances.index(min(distances))]
    return (0, left, up, (left + up) // 2)[kind]


def check_pictures(folder: pathlib.Path) -> None:
    plain = sorted(folder.glob("*.rgb"))
    assert len(plain) == 6
    for picture in plain:
        for effort in ("interactive", "still"):
            png = picture.with_suffix(f".{effort}.png").read_bytes()
            assert decode_png(png) == picture.read_bytes(), (picture.name, effort)


def read(reader, path: pathlib.Path):
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def area(surface) -> float:
    triangles, mass = vtk.vtkTriangleFilter(), vtk.vtkMassProperties()
    triangles.SetInputData(surface)
    mass.SetInputConnection(triangles.GetOutputPort())
    return mass.GetSurfaceArea()


def check_surface(name: str, surface, polygons: int, points: int, digits: float) -> None:
    assert surface.GetNumberOfPolys() == polygons, (name, surface.GetNumberOfPolys())
    assert surface.GetNumberOfPoints() == points, (name, surface.GetNumberOfPoints())
    exact = 2 * 3 * np.sqrt(3) / 2 + 6
    if digits < 0.1:  # the tolerance is larger when the reader has only float32, which is too coarse for areas
        assert abs(area(surface) - exact) < digits, (name, area(surface))
    bounds = np.array(surface.GetBounds())
    expected = np.array([499999, 500001, 4000000 - np.sqrt(0.75), 4000000 + np.sqrt(0.75), 0.25, 1.25])
    assert np.abs(bounds - expected).max() < digits, (name, bounds)


def check_values(name: str, surface, array: str) -> None:
    places = vtk_to_numpy(surface.GetPoints().GetData())
    values = vtk_to_numpy(surface.GetPointData().GetArray(array))
    assert np.abs(values - (places[:, 0] - 500000 + 10 * (places[:, 2] - 0.25))).max() < 1e-5, name


def ply_columns(path: pathlib.Path) -> np.ndarray:
    header, body = path.read_bytes().split(b"end_header\n", 1)
    lines = header.decode().splitlines()
    count = int(next(line for line in lines if line.startswith("element vertex")).split()[2])
    types = {"double": "<f8", "float": "<f4"}
    fields = [line.split() for line in lines if line.startswith("property") and "list" not in line]
    return np.frombuffer(body, np.dtype([(name, types[kind]) for _, kind, name in fields]), count)


def check_surfaces(folder: pathlib.Path) -> None:
    for name, polygons in (("polygons", 8), ("triangles", 2 * 4 + 6 * 2)):
        vtp = read(vtk.vtkXMLPolyDataReader(), folder / f"{name}.vtp")
        check_surface(f"{name}.vtp", vtp, polygons, 12, 1e-6)
        check_values(f"{name}.vtp", vtp, 'a <b> & "c"')
        normals = vtk_to_numpy(vtp.GetPointData().GetNormals())
        assert np.allclose(np.linalg.norm(normals, axis=1), 1)

        # VTK's PLY reader converts doubles to floats, so the file's bytes are compared.
        check_surface(f"{name}.ply", read(vtk.vtkPLYReader(), folder / f"{name}.ply"), polygons, 12, 0.5)
        columns = ply_columns(folder / f"{name}.ply")
        assert columns.dtype.names == ("x", "y", "z", "nx", "ny", "nz", "a_<b>_&_\"c\"")
        places = vtk_to_numpy(vtp.GetPoints().GetData())
        assert np.array_equal(np.stack([columns["x"], columns["y"], columns["z"]], 1), places)

        # STL has float32 and no shared vertices; the reader merges equal ones.
        stl = read(vtk.vtkSTLReader(), folder / f"{name}.stl")
        assert stl.GetNumberOfPolys() == 20, stl.GetNumberOfPolys()
        assert (folder / f"{name}.stl").stat().st_size == 84 + 50 * 20


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as name:
        subprocess.run([sys.argv[1], name], check=True)
        check_pictures(pathlib.Path(name))
        check_surfaces(pathlib.Path(name))
    print("pictures and surfaces are what was written")
