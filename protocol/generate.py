#!/usr/bin/env python3
"""Writes the contract's code from openrpc.json, the one source. Needs nothing but Python 3.11.

generate.py --cpp FOLDER          types, conversions, method table, the document (the build calls this)
generate.py --typescript FILE     the web client's types (npm calls this)
generate.py --python FILE         the Python client's types
"""

import argparse
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from generator import cpp, model, python, typescript  # noqa: E402


def write(path: pathlib.Path, text: str) -> None:
    """Leaves an unchanged file alone, so that nothing is rebuilt for it."""
    if path.exists() and path.read_text(encoding="utf-8") == text:
        return
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--document", type=pathlib.Path, default=pathlib.Path(__file__).parent / "openrpc.json")
    parser.add_argument("--cpp", type=pathlib.Path, metavar="FOLDER")
    parser.add_argument("--typescript", type=pathlib.Path, metavar="FILE")
    parser.add_argument("--python", type=pathlib.Path, metavar="FILE")
    arguments = parser.parse_args()

    contract = model.load(arguments.document)
    if arguments.cpp:
        for name, emit in cpp.FILES.items():
            write(arguments.cpp / name, emit(contract))
    if arguments.typescript:
        write(arguments.typescript, typescript.emit(contract))
    if arguments.python:
        write(arguments.python, python.emit(contract))
    return 0


if __name__ == "__main__":
    sys.exit(main())
