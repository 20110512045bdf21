"""Helpers of the import tests: run `ciel import`, and read a dataset with plain JSON and Zarr."""

import json
import os
import pathlib
import urllib.parse

import numpy as np
import zarr
from program import ciel

NO_NEIGHBOUR = 4294967295


def run_import(*arguments):
    """Writes all steps. test_import_late.py is about imports that write only some."""
    return ciel("import", *arguments, timeout=300, env={**os.environ, "CIEL_IMPORT_ALL": "yes"})


def ciel_info(dataset, *options):
    return ciel("info", dataset, *options, check=True).stdout


class Dataset:
    """A dataset, read with Zarr and JSON instead of CIEL's store."""

    def __init__(self, path):
        self.path = pathlib.Path(path)
        self.group = zarr.open_group(str(path), mode="r")
        self.facts = self.group.attrs["ciel"]
        self.steps = json.loads((self.path / "steps.json").read_text())["steps"]

    def mesh(self, index=0):
        return self.group[f"meshes/{index}"]

    def counts(self, index=0):
        return self.mesh(index).attrs["ciel"]["counts"]

    def cells(self, index=0):
        return self.mesh(index).attrs["ciel"]["cells"]

    @property
    def input(self):
        return self.facts["input"]

    @property
    def notes(self):
        return " ".join(self.facts["notes"])

    @property
    def times(self):
        return [step["time"] for step in self.steps]

    def array_names(self, mesh=0):
        return sorted(urllib.parse.unquote(name) for name in self.mesh(mesh)["arrays"].array_keys())

    def array(self, name, mesh=0):
        return self.mesh(mesh)[f"arrays/{urllib.parse.quote(name, safe='')}"]

    def values(self, name, step=0):
        of = self.steps[step]
        return self.array(name, of.get("mesh", 0))[of["arrays"][name].get("chunk", step)]

    def units(self, name):
        return self.array(name).attrs["ciel"].get("units", "")

    def positions(self, mesh=0, coordinates=0):
        return np.asarray(self.mesh(mesh).attrs["ciel"]["origin"]) + self.mesh(mesh)["positions"][coordinates]

    def groups(self, mesh=0):
        names = self.mesh(mesh).attrs["ciel"]["groups"]
        return {g["name"]: self.mesh(mesh)[f"groups/{i}"][:] for i, g in enumerate(names)}

    def points_of(self, faces, mesh=0):
        offset, vertex = self.mesh(mesh)["faces/face_offset"][:], self.mesh(mesh)["faces/face_vertex"][:]
        return np.unique(np.concatenate([vertex[offset[f] : offset[f + 1]] for f in faces]))

    def volume(self, mesh=0):
        """Volume by the divergence theorem over boundary faces. Correct only when all faces are matched and wound outwards."""
        m = self.mesh(mesh)
        # Around the middle, so that large coordinates do not cancel.
        position = np.asarray(m["positions"][0], float)
        position -= position.mean(axis=0)
        offset, vertex, neighbour = (m[f"faces/{name}"][:] for name in ("face_offset", "face_vertex", "neighbour"))
        total = 0.0
        for face in np.flatnonzero(neighbour == NO_NEIGHBOUR):
            loop = position[vertex[offset[face] : offset[face + 1]]]
            for i in range(1, len(loop) - 1):
                total += np.dot(loop[0], np.cross(loop[i], loop[i + 1])) / 6
        return total


def imported(tmp_path, *arguments, code=0):
    """Imports into tmp_path and returns the dataset. Fails with the program's output on another exit code."""
    output = tmp_path / "out.ciel"
    done = run_import(*arguments, "-o", output)
    assert done.returncode == code, done.stdout + done.stderr
    return Dataset(output)
