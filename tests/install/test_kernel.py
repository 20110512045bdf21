"""An external CMake project and pkg-config use the installed kernel."""

import os
import re
import subprocess

import pytest
from conftest import BACK_ENDS, EXAMPLES, ROOT, run

EXPECTED = {
    "contour": r"(\d+) polygons, (\d+) points, (\d+) triangles",
    "polyhedra": r"1 cell left out, the first is cell 1\n1 polygon in cell 0",
    "time_steps": r"(step \d, level +-?\d\.\d: \d+ polygons\n){9}",
}


@pytest.fixture(scope="module", params=BACK_ENDS)
def programs(request, installed, tmp_path_factory):
    build = tmp_path_factory.mktemp("examples")
    run("cmake", "-G", "Ninja", "-S", EXAMPLES, "-B", build, f"-DCMAKE_PREFIX_PATH={installed(request.param)}")
    run("cmake", "--build", build)
    return build


@pytest.mark.parametrize("name", EXPECTED)
def test_examples_run(programs, name):
    assert re.fullmatch(EXPECTED[name], run(programs / name).strip() + ("\n" if name == "time_steps" else ""))


def test_the_sphere_is_closed(programs):
    """Euler's formula: a closed triangulated sphere has half as many points as triangles, plus two."""
    _, points, triangles = map(int, re.findall(r"\d+", run(programs / "contour")))
    assert points - triangles / 2 == 2


@pytest.mark.parametrize("back_end", BACK_ENDS)
def test_pkg_config_finds_it(installed, tmp_path, back_end):
    folder = next(installed(back_end).rglob("ciel.pc")).parent
    environment = {**os.environ, "PKG_CONFIG_PATH": str(folder)}
    flags = run("pkg-config", "--cflags", "--libs", "ciel", env=environment).split()
    assert ("-pthread" in flags, "-ltbb" in flags) == (back_end != "serial", back_end == "tbb")
    run("g++", "-std=c++20", EXAMPLES / "contour.cpp", "-o", tmp_path / "contour", *flags)
    assert "polygons" in run(tmp_path / "contour")


def test_programs_are_not_linked_with_what_a_shared_library_brings(tmp_path):
    run("cmake", "-S", ROOT / "server/ciel", "-B", tmp_path, "-DBUILD_SHARED_LIBS=ON", "-DCIEL_PARALLEL=tbb")
    lines = (tmp_path / "ciel.pc").read_text().splitlines()
    assert "Requires.private: tbb" in lines and "Libs: -L${libdir} -lciel" in lines
    assert "Libs.private: -pthread -lstdc++" in lines


def test_only_public_headers_are_installed(prefix):
    headers = {path.relative_to(prefix / "include").parts[0] for path in (prefix / "include").rglob("*.hpp")}
    assert headers == {"ciel"}
    with_a_global_limit = [h.name for h in prefix.rglob("*.hpp") if "set_thread_count" in h.read_text()]
    assert with_a_global_limit == []


def test_each_public_header_compiles_alone(prefix, tmp_path):
    for header in sorted((prefix / "include/ciel").glob("*.hpp")):
        source = tmp_path / "alone.cpp"
        source.write_text(f"#include <ciel/{header.name}>\n")
        done = subprocess.run(
            ["g++", "-std=c++20", "-fsyntax-only", "-Wall", "-Wextra", "-Werror", "-Wno-psabi",
             f"-I{prefix / 'include'}", source],
            capture_output=True, text=True, check=False,
        )  # fmt: skip
        assert done.returncode == 0, f"{header.name}: {done.stderr}"


def test_another_minor_version_is_refused(prefix, tmp_path):
    (tmp_path / "CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.25)\nproject(x LANGUAGES CXX)\nfind_package(ciel 0.9 REQUIRED)\n"
    )
    done = subprocess.run(
        ["cmake", "-S", tmp_path, "-B", tmp_path / "build", f"-DCMAKE_PREFIX_PATH={prefix}"],
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.returncode != 0 and "0.9" in done.stderr


def test_a_compiler_without_vector_extensions_compiles_the_gradients(tmp_path):
    """The compiler lacks a function of the extensions, so it compiles only plain vectors."""
    compiler = tmp_path / "other-c++"
    compiler.write_text('#!/bin/sh\nexec g++ -D__builtin_shufflevector=no_such_function "$@"\n')
    compiler.chmod(0o755)
    build = tmp_path / "build"
    said = run("cmake", "-G", "Ninja", "-S", ROOT / "server/ciel", "-B", build, "-DCIEL_PARALLEL=serial",
               f"-DCMAKE_CXX_COMPILER={compiler}", "-DCMAKE_CXX_COMPILER_LAUNCHER=")  # fmt: skip
    assert f"{compiler} has no vector extensions" in said
    objects = [f"CMakeFiles/ciel_kernel.dir/src/fields/{unit}.cpp.o" for unit in ("gradients_everywhere", "many_gradients")]
    run("ninja", "-C", build, *objects)
