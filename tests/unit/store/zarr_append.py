"""Reads the box dataset of box.hpp with zarr, checks it, and appends a step the way server/store/README.md says."""

import json
import os
import sys

import numpy
import zarr

path = sys.argv[1]
group = zarr.open_group(path, mode="r+")
mesh = group["meshes/0"]
assert group.attrs["ciel"]["format_version"] == 2
assert mesh["positions"].shape == (1, 27, 3) and mesh["positions"][0, 26].tolist() == [2, 2, 2]
assert mesh["cell_types"][:].tolist() == [12] * 8
faces = mesh["faces"]  # 24 on the boundary, and one of the wall inside the mesh
assert faces["face_offset"][-1] == faces["face_vertex"].shape[0] == 25 * 4
assert (faces["owner"][:] < faces["neighbour"][:]).all()  # `none` is the largest integer
assert [g["name"] for g in mesh.attrs["ciel"]["groups"]] == ["wall", "inner/zone \u00e9"]
assert mesh["groups/0"][:].tolist() == [0, 1, 24]

arrays = {a.attrs["ciel"]["name"]: a for _, a in mesh["arrays"].arrays()}
assert set(arrays) == {"p", "U", "cell:p"}
assert arrays["U"].shape == (3, 27, 3) and arrays["U"].attrs["ciel"]["units"] == "m/s"
assert arrays["U"][2].ravel().tolist() == [i + 2000 for i in range(81)]
assert arrays["cell:p"][1].tolist() == [i + 1000 for i in range(8)]
assert arrays["p"][2].tolist() == [i + 2000 for i in range(27)]
assert numpy.isnan(arrays["p"][1]).all(), "not written at that time"

p = group["meshes/0/arrays/p"]
p.append(numpy.arange(100, 127, dtype="<f4")[None])
moved = group["meshes/0/positions"]
moved.append(moved[0][None] + 1)
with open(path + "/steps.json") as file:
    marker = json.load(file)
marker["steps"].append({"time": 1.5, "coordinates": 1, "arrays": {"p": {"chunk": p.shape[0] - 1}}})
with open(path + "/steps.json.new", "w") as file:
    json.dump(marker, file)
os.replace(path + "/steps.json.new", path + "/steps.json")
