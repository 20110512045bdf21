import os
import pathlib
import shutil
import subprocess
import sys

import pytest

ROOT = pathlib.Path(__file__).parents[2]
EXAMPLES = ROOT / "server/ciel/examples"
if shutil.which("ccache"):
    os.environ.setdefault("CMAKE_CXX_COMPILER_LAUNCHER", "ccache")


def run(*command, **options):
    """Runs a command, which must succeed, and returns its output. A failure shows stdout and stderr."""
    done = subprocess.run([*map(str, command)], capture_output=True, text=True, check=False, **options)
    assert done.returncode == 0, f"{command}\n{done.stdout[-4000:]}\n{done.stderr[-4000:]}"
    return done.stdout


@pytest.fixture(scope="session")
def prefix(tmp_path_factory):
    """Folder of the installed kernel, which has been moved after the installation."""
    folder = tmp_path_factory.mktemp("kernel")
    run("cmake", "-G", "Ninja", "-S", ROOT / "server/ciel", "-B", folder / "build",
        "-DCIEL_PARALLEL=threads", f"-DCMAKE_INSTALL_PREFIX={folder / 'first'}")  # fmt: skip
    run("cmake", "--build", folder / "build")
    run("cmake", "--install", folder / "build")
    shutil.rmtree(folder / "build")
    (folder / "first").rename(folder / "installed")
    return folder / "installed"


@pytest.fixture(scope="session")
def python(tmp_path_factory):
    """Interpreter of a fresh virtual environment with the kernel's package and Debian's NumPy and VTK."""
    folder = tmp_path_factory.mktemp("python") / "venv"
    run(sys.executable, "-m", "venv", "--system-site-packages", folder)
    program = folder / "bin/python"
    run(program, "-m", "pip", "install", "--no-build-isolation", "--no-index", "--no-deps", ROOT,
        env={**os.environ, "PIP_DISABLE_PIP_VERSION_CHECK": "1"})  # fmt: skip
    return program
