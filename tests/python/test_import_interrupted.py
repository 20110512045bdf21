"""An import or an append that is killed, or that fills the disk, loses nothing and leaves nothing half-made."""

import contextlib
import json
import os
import pathlib
import shutil
import signal
import subprocess
import time

import numpy as np
import pytest
import vtk
from import_support import ciel_info
from program import CIEL, ciel
from serve_process import PATIENCE, Server, until
from test_import_late import write_pvd
from vtk_files import add_array, hexahedra, linear, unstructured, write

KILLS, ROOMS = 24, 15  # moments of a kill, amounts of free space on the disk
PARENT, BOTH, CHILD = slice(1), slice(None), slice(1, None)  # of ciel and its child ciel-import
LATE = "import --all"


def write_series(folder, n, steps):
    folder.mkdir()
    points, cells = hexahedra(n)
    grid = unstructured([(vtk.VTK_HEXAHEDRON, nodes) for nodes in cells.tolist()], points)
    for step in range(steps):
        add_array(grid.GetPointData(), "f", linear(points) + step)
        add_array(grid.GetCellData(), "c", np.arange(len(cells)) + step)
        write(vtk.vtkXMLUnstructuredGridWriter(), folder / f"{step}.vtu", grid)
    np.save(folder / "f.npy", linear(points))
    return write_pvd(folder / "run.pvd", [f"{step}.vtu" for step in range(steps)])


@pytest.fixture(scope="module")
def inputs(tmp_path_factory):
    """`two.ciel` has two steps. `three.ciel` has three; the one between is late."""
    folder = tmp_path_factory.mktemp("inputs")
    for name, n, steps in (("two", 6, 2), ("three", 20, 3)):
        ciel("import", write_series(folder / name, n, steps), "-o", folder / f"{name}.ciel", check=True)
    # 51^3 hexahedra have 1,061,208 corners: DiskVector (server/store/files/disk_vector.hpp) keeps them in a file.
    write_series(folder / "large", 51, 1)
    return folder


COMMANDS = {  # arguments, the dataset at OUT before, the times of its steps afterwards
    "import": ("import {inputs}/three/run.pvd -o {out}", None, [0, 1, 2]),
    "import --force": ("import {inputs}/three/run.pvd -o {out} --force", "two.ciel", [0, 1, 2]),
    "append": ("append {out} --time 3 --array f={inputs}/three/f.npy --array g={inputs}/three/f.npy", "three.ciel", [0, 1, 2, 3]),
    LATE: ("import {out} --all", "three.ciel", [0, 1, 2]),
    "import of large lists": ("import {inputs}/large/run.pvd -o {out}", None, [0]),
}


def state(dataset):
    """Returns the times and the number of chunks; None without a dataset. Verifies all checksums."""
    if not dataset.exists():
        return None
    facts = json.loads(ciel_info(dataset, "--json"))
    return facts["times"], facts["checksums"]["verified"]


class Command:
    def __init__(self, name, inputs, out):
        arguments, initial, times = COMMANDS[name]
        self.arguments = [argument.format(inputs=inputs, out=out) for argument in arguments.split()]
        self.is_late, self.out, self.initial = name == LATE, out, initial and inputs / initial
        self.prepare()
        self.before, free, begin = state(out), shutil.disk_usage(out.parent).free, time.monotonic()
        self.run()
        self.seconds, self.bytes, self.after = time.monotonic() - begin, free - shutil.disk_usage(out.parent).free, state(out)
        assert self.after[0] == times

    def prepare(self):
        shutil.rmtree(self.out, ignore_errors=True)
        if self.initial:
            shutil.copytree(self.initial, self.out)

    def run(self):
        done = ciel(*self.arguments)
        assert done.returncode == 0, done.stderr

    def check(self, is_done):
        """Returns whether the command has done its work. Of a late step, each array may be there without the others."""
        now = state(self.out)
        if self.is_late and not is_done:
            assert now[0] == self.after[0] and self.before[1] <= now[1] <= self.after[1]
        else:
            assert now == self.after if is_done else now in (self.before, self.after)
        return now == self.after


def left_behind(out):
    return [*out.parent.glob(f".{out.name}.writing-*"), *out.rglob("*.new-*")]


def processes_of(path):
    """Returns the ids of the processes with this path in their command lines. An ended process has no command line."""
    found = []
    for process in pathlib.Path("/proc").glob("[0-9]*"):
        with contextlib.suppress(OSError):
            if os.fsencode(path) in (process / "cmdline").read_bytes():
                found.append(int(process.name))
    return found


def killed(command, wait, victims):
    """Starts the command, waits, and kills the victims. Returns the exit code of `ciel` and its error output."""
    command.prepare()
    with subprocess.Popen([CIEL, *command.arguments], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) as process:
        wait()
        running = [process.pid, *(child for child in processes_of(command.out) if child != process.pid)]
        for target in running[victims] or running:
            with contextlib.suppress(ProcessLookupError):
                os.kill(target, signal.SIGKILL)
        errors = process.communicate(timeout=PATIENCE)[1]
    until(lambda: not processes_of(command.out))  # ciel-import ends with ciel
    return process.returncode, errors


@pytest.mark.parametrize("name", ["import", "import --force", "append", LATE])
def test_killed_at_any_moment(tmp_path, inputs, name):
    command = Command(name, inputs, tmp_path / "out.ciel")
    for attempt in range(KILLS):
        moment = 1.1 * command.seconds * attempt / (KILLS - 1)
        code, errors = killed(command, lambda moment=moment: time.sleep(moment), (PARENT, BOTH, CHILD)[attempt % 3])
        assert code in (0, 1, -signal.SIGKILL), errors
        is_complete = code == 0 or "the dataset was complete" in errors
        if code == 1:
            (line,) = errors.splitlines()
            assert line.startswith("ciel: ") and (is_complete or "killed from outside" in line)
            assert command.is_late or not left_behind(command.out)
        if not command.check(is_complete):
            command.run()
            assert state(command.out) == command.after and not left_behind(command.out)


@pytest.mark.parametrize("before", [None, "two.ciel"])
def test_an_import_killed_after_its_end_says_that_the_dataset_is_complete(tmp_path, inputs, before):
    program, out = tmp_path / "ciel", tmp_path / "out.ciel"
    shutil.copy(CIEL, program)
    fake = tmp_path / "ciel-import"  # `ciel` looks beside itself first
    fake.write_text(f"#!/bin/sh\nrm -rf '{out}'\ncp -r '{inputs}/three.ciel' '{out}'\nkill -9 $$\n")
    fake.chmod(0o755)
    if before:
        shutil.copytree(inputs / before, out)
    command = [program, "import", inputs / "three/run.pvd", "-o", out, "--force"]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 1 and "the dataset was complete; it can be used" in done.stderr
    fake.write_text("#!/bin/sh\nkill -9 $$\n")
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 1 and "nothing was written" in done.stderr


def test_a_server_serves_a_dataset_whose_import_was_killed_after_its_end(tmp_path, inputs):
    program, fake = tmp_path / "ciel", tmp_path / "ciel-import"
    shutil.copy(CIEL, program)
    fake.write_text(f"""#!/bin/sh
for argument; do case $argument in --output=*) out=${{argument#--output=}};; esac; done
cp -r '{inputs}/three.ciel' "$out"
kill -9 $$
""")
    fake.chmod(0o755)
    with Server(inputs / "three/run.pvd", "--data-dir", tmp_path / "cache", program=program) as running:
        (dataset,) = running.call("dataset.list")
        assert dataset["problem"] == "" and running.call("dataset.describe", dataset=dataset["name"])["times"] == [0, 1, 2]


@pytest.mark.parametrize("name", ["import", "append"])
def test_a_limit_of_the_file_size_is_told(tmp_path, inputs, name):
    command = Command(name, inputs, tmp_path / "out.ciel")
    command.prepare()
    done = subprocess.run(["bash", "-c", 'ulimit -f 16; exec "$0" "$@"', CIEL, *command.arguments], capture_output=True, text=True)
    command.check(is_done=False)
    assert done.returncode == 1 and "File too large" in done.stderr and not left_behind(command.out), done.stderr


def test_files_of_a_killed_reader_of_late_steps_are_removed(tmp_path, inputs):
    command = Command(LATE, inputs, tmp_path / "out.ciel")
    command.prepare()
    for name in ("late.new-4711", "meshes/0/arrays/f/1.0.new-4711"):
        (command.out / name).write_text("1")
    command.run()
    assert left_behind(command.out) == []


@contextlib.contextmanager
def small_disk(folder, kind):
    """Mounts a file system of 64 MiB. On tmpfs, DiskVector uses no files."""
    disk, image = folder / "disk", folder / "image"
    disk.mkdir()
    mount = {"tmpfs": f"mount -t tmpfs -o size=64m none {disk}",
             "ext4": f"truncate -s 64M {image} && mkfs.ext4 -q -m 0 {image} && mount -o loop {image} {disk}"}
    done = subprocess.run(f"PATH=$PATH:/usr/sbin:/sbin; {mount[kind]}", shell=True, capture_output=True, text=True)
    if done.returncode != 0:
        pytest.skip(f"no file system can be mounted here: {done.stderr}")
    try:
        yield disk
    finally:
        subprocess.run(["umount", disk], check=True)


def fill(disk, room):
    piece = 32 << 10  # small, because the last one may fail: ext4 takes some blocks for itself
    with open(disk / "filler", "wb") as filler, contextlib.suppress(OSError):
        for offset in range(0, shutil.disk_usage(disk).free - room, piece):
            os.posix_fallocate(filler.fileno(), offset, piece)


@pytest.mark.parametrize(("kind", "name"), [*(("tmpfs", name) for name in ("import", "import --force", "append", LATE)),
                                            ("ext4", "append"), ("ext4", LATE), ("ext4", "import of large lists")])
def test_a_full_disk(tmp_path, inputs, kind, name):
    with small_disk(tmp_path, kind) as disk:
        command = Command(name, inputs, disk / "out.ciel")
        for attempt in range(ROOMS):
            command.prepare()
            fill(disk, 2 * command.bytes * attempt // (ROOMS - 1))
            done = ciel(*command.arguments)
            (disk / "filler").unlink()
            command.check(is_done=done.returncode == 0)
            assert not left_behind(command.out)
            if done.returncode != 0:
                (line,) = done.stderr.splitlines()
                assert done.returncode == 1 and line.startswith("ciel: ") and "No space left on device" in line
        assert done.returncode == 0, done.stderr
