"""A volume of the blunt fin against VTK's ray caster, with the same camera, color map and opacity, unshaded."""

import json
import os
import pathlib
import shutil
import subprocess

import numpy as np
import pytest
from program import ciel

DATA = pathlib.Path(os.environ.get("CIEL_DATA", "data")) / "nasa"
SIDE = 400
ARRAY = "Density"
LOW, HIGH = 0.2, 5.0
POINTS = [[0.0, 0.0], [0.2, 0.15], [0.45, 0.5], [1.0, 0.9]]
UNIT = 2.5
POSITION, TARGET, UP, FOV = (-14.0, -24.0, 16.0), (3.0, 4.0, 2.8), (0.0, 0.0, 1.0), 30.0

def works(*arguments):
    result = ciel(*arguments)
    assert result.returncode == 0, result.stderr


# VTK ends the program when there is no display, so it runs in a separate process.
VTK = f"""
import sys
import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy

reader = vtk.vtkMultiBlockPLOT3DReader()
reader.SetXYZFileName({str(DATA / "bluntfinxyz.bin")!r})
reader.SetQFileName({str(DATA / "bluntfinq.bin")!r})
reader.SetAutoDetectFormat(1)
reader.AddFunction(100)
reader.Update()
block = reader.GetOutput().GetBlock(0)
block.GetPointData().SetActiveScalars("Density")
grid = vtk.vtkDataSetTriangleFilter()
grid.SetInputData(block)
grid.Update()

# The mapper takes opacity for extinction per length, whatever the unit distance.
points = np.array({POINTS!r})
places = np.linspace(0, 1, 2001)
extinction = -np.log(1 - np.interp(places, points[:, 0], points[:, 1]))
property = vtk.vtkVolumeProperty()
opacity = vtk.vtkPiecewiseFunction()
color = vtk.vtkPiecewiseFunction()
for place, tau in zip(places, extinction):
    opacity.AddPoint({LOW} + place * {HIGH - LOW}, tau / {UNIT})
color.AddPoint({LOW}, 0)
color.AddPoint({HIGH}, 1)
property.SetScalarOpacity(opacity)
property.SetScalarOpacityUnitDistance(1)
property.SetColor(color)
property.ShadeOff()
property.SetInterpolationTypeToLinear()

mapper = vtk.vtkUnstructuredGridVolumeRayCastMapper()
# Cells are small: one value on each piece of a ray is enough.
mapper.SetRayIntegrator(vtk.vtkUnstructuredGridHomogeneousRayIntegrator())
mapper.SetInputConnection(grid.GetOutputPort())
mapper.SetAutoAdjustSampleDistances(0)
mapper.SetImageSampleDistance(1)
volume = vtk.vtkVolume()
volume.SetMapper(mapper)
volume.SetProperty(property)
renderer = vtk.vtkRenderer()
renderer.AddVolume(volume)
camera = renderer.GetActiveCamera()
camera.SetPosition({POSITION!r})
camera.SetFocalPoint({TARGET!r})
camera.SetViewUp({UP!r})
camera.SetViewAngle({FOV})
window = vtk.vtkRenderWindow()
window.SetOffScreenRendering(1)
window.SetMultiSamples(0)
window.AddRenderer(renderer)
window.SetSize({SIDE}, {SIDE})
renderer.ResetCameraClippingRange()
window.Render()
grabbed = vtk.vtkWindowToImageFilter()
grabbed.SetInput(window)
grabbed.SetInputBufferTypeToRGB()
grabbed.ReadFrontBufferOff()
grabbed.Update()
image = grabbed.GetOutput()
np.save(sys.argv[1], vtk_to_numpy(image.GetPointData().GetScalars()).reshape({SIDE}, {SIDE}, 3)[::-1])
"""


def pixels(path):
    import vtk
    from vtk.util.numpy_support import vtk_to_numpy

    reader = vtk.vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(SIDE, SIDE, 3)[::-1].astype(float)


@pytest.fixture(scope="module")
def of_vtk(tmp_path_factory):
    if not (DATA / "bluntfinxyz.bin").exists():
        pytest.skip("needs the blunt fin, data/nasa")
    assert shutil.which("xvfb-run"), "needs xvfb"
    path = tmp_path_factory.mktemp("vtk") / "picture.npy"
    command = ["xvfb-run", "-a", "/usr/bin/python3", "-c", VTK, str(path)]
    result = subprocess.run(command, capture_output=True, text=True, timeout=200, check=False)
    assert path.exists(), result.stderr
    return np.load(path).astype(float)


@pytest.fixture(scope="module")
def fin(tmp_path_factory):
    path = tmp_path_factory.mktemp("fin") / "fin.ciel"
    works("import", DATA / "bluntfinxyz.bin", "-o", path)
    return path


@pytest.mark.parametrize("direction", ["auto", "x", "z", "screen"])
def test_the_blunt_fin_is_as_bright_as_by_vtks_ray_caster(of_vtk, fin, tmp_path, direction):
    volume = {
        "type": "volume",
        "array": ARRAY,
        "color": {"map": "grayscale", "range": [LOW, HIGH]},
        "opacity_points": POINTS,
        "unit_length": UNIT,
        "slices": 400,
        "direction": direction,
        "shaded": False,
    }
    camera = {"position": POSITION, "target": TARGET, "up": UP, "fov": FOV}
    bare = {"legend": False, "triad": False}
    scene = {"background": "#000000", "camera": camera, "annotations": bare, "layers": {"volume": volume}}
    (tmp_path / "scene.json").write_text(json.dumps(scene))
    works("render", fin, "--scene", tmp_path / "scene.json", "--size", f"{SIDE}x{SIDE}", "-o", tmp_path / "p.png")
    difference = np.abs(pixels(tmp_path / "p.png") - of_vtk)
    covered = of_vtk.max(axis=2) > 0
    assert 0.15 < covered.mean() < 0.9
    assert difference[covered].mean() / 255 < 0.02
    assert of_vtk.max() > 60, "a picture of nothing proves nothing"
    assert np.percentile(difference, 99.5) < 20
