#!/usr/bin/env python3
"""Writes the code of the contract from openrpc.json and frame_header.json. Needs nothing but Python 3.11.

generate.py --cpp FOLDER          types, conversions, method table, scene, frame header, the document (the build calls this)
generate.py --typescript FOLDER   the web client's types and frame header (npm calls this)
generate.py --python FOLDER       the Python client's types, methods, frame header and version
generate.py --markdown            the table of the frame header in frame.md
"""

import argparse
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from generator import cpp, cpp_scene, frame_header, model, python, python_calls, typescript  # noqa: E402

PROTOCOL = pathlib.Path(__file__).resolve().parent


def write(path: pathlib.Path, text: str) -> None:
    """Writes a file. Leaves a file that already has this text untouched, so that it causes no rebuild."""
    if path.exists() and path.read_text(encoding="utf-8") == text:
        return
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cpp", type=pathlib.Path, metavar="FOLDER")
    parser.add_argument("--typescript", type=pathlib.Path, metavar="FOLDER")
    parser.add_argument("--python", type=pathlib.Path, metavar="FOLDER")
    parser.add_argument("--markdown", action="store_true")
    arguments = parser.parse_args()

    contract = model.load(PROTOCOL / "openrpc.json")
    header = frame_header.load(PROTOCOL / "frame_header.json")
    if arguments.cpp:
        for name, emit in (cpp.FILES | cpp_scene.FILES).items():
            write(arguments.cpp / name, emit(contract))
        write(arguments.cpp / "frame_header.hpp", frame_header.emit_cpp(header))
    if arguments.typescript:
        write(arguments.typescript / "protocol.ts", typescript.emit(contract))
        write(arguments.typescript / "frame_header.ts", frame_header.emit_typescript(header))
    if arguments.python:
        write(arguments.python / "schemas.py", python.emit_schemas(contract))
        write(arguments.python / "types.py", python.emit(contract))
        write(arguments.python / "calls.py", python_calls.emit(contract, is_async=False))
        write(arguments.python / "async_calls.py", python_calls.emit(contract, is_async=True))
        write(arguments.python / "frame_header.py", frame_header.emit_python(header))
        write(arguments.python / "version.py", python.emit_version((PROTOCOL.parent / "server/ciel/version.txt").read_text()))
    if arguments.markdown:
        text = (PROTOCOL / "frame.md").read_text(encoding="utf-8")
        table = "\n" + frame_header.emit_table(header)
        write(PROTOCOL / "frame.md", re.sub(r"\n\| offset \|(?:.*\n)(?:\|.*\n)+", lambda _: table, text, count=1))
    return 0


if __name__ == "__main__":
    sys.exit(main())
