import functools
import os
import pathlib
import shutil
import subprocess
import sys

import pytest

ROOT = pathlib.Path(__file__).parents[2]
EXAMPLES = ROOT / "server/ciel/examples"
# The back ends of the parallel loop and folders for libraries. Debian's is two levels deep.
BACK_ENDS = {"tbb": "lib/x86_64-linux-gnu", "threads": "lib", "serial": "lib"}
if shutil.which("ccache"):
    os.environ.setdefault("CMAKE_CXX_COMPILER_LAUNCHER", "ccache")
    os.environ.setdefault("CCACHE_BASEDIR", "/")  # paths become relative: temporary folders have new names in each run


def run(*command, **options):
    """Runs a command, which must succeed, and returns its output. A failure shows stdout and stderr."""
    done = subprocess.run([*map(str, command)], capture_output=True, text=True, check=False, **options)
    assert done.returncode == 0, f"{command}\n{done.stdout[-4000:]}\n{done.stderr[-4000:]}"
    return done.stdout


@pytest.fixture(scope="session")
def installed(tmp_path_factory):
    """Function from a back end to the folder of the kernel installed with it, which was moved after the installation."""

    @functools.cache
    def install(back_end):
        folder = tmp_path_factory.mktemp(back_end)
        run("cmake", "-G", "Ninja", "-S", ROOT / "server/ciel", "-B", folder / "build", f"-DCIEL_PARALLEL={back_end}",
            f"-DCMAKE_INSTALL_LIBDIR={BACK_ENDS[back_end]}", f"-DCMAKE_INSTALL_PREFIX={folder / 'first'}")  # fmt: skip
        run("cmake", "--build", folder / "build")
        run("cmake", "--install", folder / "build")
        shutil.rmtree(folder / "build")
        (folder / "first").rename(folder / "installed")
        return folder / "installed"

    return install


@pytest.fixture(scope="session")
def prefix(installed):
    """Folder of the kernel installed with one of the back ends."""
    return installed("threads")


def fresh_python(folder):
    """Interpreter of a new virtual environment, which has Debian's NumPy, VTK, pybind11 and setuptools."""
    run(sys.executable, "-m", "venv", "--system-site-packages", folder)
    return folder / "bin/python"


def pip_install(python, source):
    """Installs a package from a folder or a file. Nothing is downloaded: what it depends on must be there."""
    run(python, "-m", "pip", "install", "--no-build-isolation", "--no-index", source,
        env={**os.environ, "PIP_DISABLE_PIP_VERSION_CHECK": "1"})  # fmt: skip


@pytest.fixture(scope="session")
def python(tmp_path_factory):
    """Interpreter of a fresh virtual environment with the kernel's package."""
    program = fresh_python(tmp_path_factory.mktemp("python") / "venv")
    pip_install(program, ROOT)
    return program
