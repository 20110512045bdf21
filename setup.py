"""Builds the extension by the kernel's own CMakeLists.txt, whose flags keep the results the same to the bit."""

import os
import pathlib
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).parent.resolve()
PACKAGE = "server/ciel/bindings/python/ciel_mesh"
BUILD = ROOT / "build/python"  # beside the server's own build


class CMakeBuild(build_ext):
    def build_extension(self, ext):
        target = pathlib.Path(self.get_ext_fullpath(ext.name)).resolve().parent
        build = pathlib.Path(self.build_temp).resolve()
        settings = [
            f"-DCIEL_PYTHON_DIR={target}",
            f"-DPython3_EXECUTABLE={sys.executable}",
            f"-DCIEL_PARALLEL={os.environ.get('CIEL_PARALLEL', 'threads')}",
            "-DCMAKE_BUILD_TYPE=Release",
            "-DCIEL_PYTHON=ON",
        ]
        subprocess.run(["cmake", "-S", str(ROOT / "server/ciel"), "-B", str(build), *settings], check=True)
        jobs = str(len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1)
        subprocess.run(["cmake", "--build", str(build), "--target", "ciel_python", "-j", jobs], check=True)


BUILD.mkdir(parents=True, exist_ok=True)
setup(
    options={"build": {"build_base": str(BUILD)}, "egg_info": {"egg_base": str(BUILD)}},
    packages=["ciel_mesh"],
    package_dir={"ciel_mesh": PACKAGE},
    package_data={"ciel_mesh": ["py.typed", "*.pyi"]},
    ext_modules=[Extension("ciel_mesh._kernel", sources=[])],
    cmdclass={"build_ext": CMakeBuild},
)
