"""Runs one command as one test case and appends the outcome to a JUnit file: junit.py FILE SUITE NAME COMMAND...

Exit code 77 means that the command was skipped; its last line of output is the reason."""

import pathlib
import subprocess
import sys
import time
import xml.etree.ElementTree as ElementTree

SKIPPED = 77


def main(file: pathlib.Path, suite: str, name: str, command: list[str]) -> int:
    root = ElementTree.parse(file).getroot() if file.exists() else ElementTree.Element("testsuite", name=suite)
    started = time.monotonic()
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace", check=False)
    case = ElementTree.SubElement(root, "testcase", classname=suite, name=name, time=f"{time.monotonic() - started:.3f}")
    if done.returncode == SKIPPED:
        ElementTree.SubElement(case, "skipped", message="".join(done.stdout.splitlines()[-1:]))
    elif done.returncode != 0:
        print(done.stdout[-8000:])
        ElementTree.SubElement(case, "failure", message=f"{name} exited {done.returncode}")
    ElementTree.ElementTree(root).write(file)
    print(f"{ {0: 'ok', SKIPPED: 'skipped'}.get(done.returncode, 'FAILED')}: {name}")
    return done.returncode


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]), sys.argv[2], sys.argv[3], sys.argv[4:]))
