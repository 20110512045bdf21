"""Points, cells and values that VTK's own readers give for a file: all parts with volume, numbered consecutively."""

import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy

# Flags and ids, which are no fields (server/import/values/fields.cpp).
BOOKKEEPING = {
    "vtkGhostType", "vtkOriginalPointIds", "vtkOriginalCellIds", "IBlank", "GlobalNodeId", "GlobalElementId", "PedigreeNodeId",
    "PedigreeElementId", "ObjectId", "vtkBlockColors", "vtkCompositeIndex", "vtkValidPointMask",
}


def has_volume(data):
    return any(data.GetCell(i).GetCellDimension() == 3 for i in range(min(data.GetNumberOfCells(), 1000)))


def leaves(data):
    """The leaves of a tree in order, without parts that repeat cells of other parts under a name."""
    if data is None:
        return
    if data.IsA("vtkDataSet"):
        if has_volume(data):
            yield data
    elif data.IsA("vtkMultiBlockDataSet"):
        for i in range(data.GetNumberOfBlocks()):
            if not data.HasMetaData(i) or data.GetMetaData(i).Get(vtk.vtkCompositeDataSet.NAME()) not in ("zones", "Element Sets"):
                yield from leaves(data.GetBlock(i))
    elif data.IsA("vtkPartitionedDataSetCollection"):
        for i in range(data.GetNumberOfPartitionedDataSets()):
            yield from leaves(data.GetPartitionedDataSet(i))
    else:
        for i in range(data.GetNumberOfPartitions()):
            yield from leaves(data.GetPartitionAsDataObject(i))


class Truth:
    """The merged leaves of a reader at one time (None: its only time). Arrays that a leaf does not have are NaN there."""

    def __init__(self, reader, time=None):
        if time is None:
            reader.Update()
        else:
            reader.UpdateTimeStep(time)
        self.leaves = list(leaves(reader.GetOutputDataObject(0)))
        self.points = np.concatenate([self._points(leaf) for leaf in self.leaves])

    @staticmethod
    def _points(leaf):
        if leaf.IsA("vtkPointSet"):
            return vtk_to_numpy(leaf.GetPoints().GetData()).astype(float)
        return np.array([leaf.GetPoint(i) for i in range(leaf.GetNumberOfPoints())])

    def corners(self, cell):
        """Point ids of a cell. Cells and points are numbered over all leaves."""
        first = 0
        for leaf in self.leaves:
            if cell < leaf.GetNumberOfCells():
                ids = leaf.GetCell(cell).GetPointIds()
                return {first + ids.GetId(i) for i in range(ids.GetNumberOfIds())}
            cell -= leaf.GetNumberOfCells()
            first += leaf.GetNumberOfPoints()
        raise IndexError

    def cell_count(self):
        return sum(leaf.GetNumberOfCells() for leaf in self.leaves)

    def fields(self, of):
        """Maps names to values, [n, components], as float32 if the reader has them so, else as float64."""
        attributes = [getattr(leaf, f"Get{of}Data")() for leaf in self.leaves]
        counts = [leaf.GetNumberOfPoints() if of == "Point" else leaf.GetNumberOfCells() for leaf in self.leaves]
        found = {}
        for data in attributes:
            for i in range(data.GetNumberOfArrays()):
                if data.GetArray(i) is not None and data.GetArrayName(i) not in BOOKKEEPING:
                    found.setdefault(data.GetArrayName(i), data.GetArray(i).GetNumberOfComponents())
        values = {}
        for name, components in found.items():
            parts = []
            for data, count in zip(attributes, counts):
                array = data.GetArray(name)
                part = np.full((count, components), np.nan) if array is None else vtk_to_numpy(array).reshape(count, -1)
                parts.append(part if part.dtype == np.float32 else part.astype("f8"))
            values[name] = np.concatenate(parts)
        return values


def reader_of(kind, file):
    reader = getattr(vtk, kind)()
    reader.SetFileName(str(file))
    return reader
