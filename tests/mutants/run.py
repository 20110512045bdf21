"""mutants: breaks a copy of the sources on purpose, one patch at a time, and asks the tests to notice.

tests/mutants/SUITE/NAME.patch begins with a sentence that says what is broken, then `build: TARGET...` (CMake targets, or
`page` for the web client; may be left out) and `run: COMMAND`, the narrowest part of the suite that has to fail. The same
command has to pass in the unbroken copy. `needs: COMMAND` is optional: on a machine where it fails, the mutant is
skipped. run.py ROOT RESULTS.xml [SUITE ...]
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import time
import xml.etree.ElementTree as ElementTree


class Mutant:
    def __init__(self, path: pathlib.Path):
        head, _, self.patch = path.read_text(encoding="utf-8").partition("\n--- ")
        self.patch = "--- " + self.patch
        self.suite, self.name = path.parent.name, path.stem
        fields = dict(re.findall(r"^(build|needs|run): (.+)$", head, re.M))
        self.what = head.splitlines()[0]
        self.targets, self.command = fields.get("build", "").split(), fields["run"]
        self.needs = fields.get("needs", "")


class Copy:
    """A copy of the tracked files, uncommitted changes included, with a build folder and the page's tools."""

    def __init__(self, root: pathlib.Path, folder: pathlib.Path):
        self.folder = folder
        listed = subprocess.run(["git", "-C", root, "ls-files", "-z"], capture_output=True, check=True).stdout.split(b"\0")
        names = {name.decode() for name in listed if name}
        self.remove_all_but(names)
        for name in names:
            source, target = root / name, folder / name
            if not source.exists() or (target.exists() and target.read_bytes() == source.read_bytes()):
                continue  # keeps the file's time, so that ninja does not build it again
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(source, target)
        modules = folder / "webclient/node_modules"
        if not modules.exists():
            modules.symlink_to((root / "webclient/node_modules").resolve())
        results = folder / "build/results"
        results.mkdir(parents=True, exist_ok=True)
        self.environment = {
            "CIEL_PYTHON": sys.executable,
            **os.environ,
            "CIEL_RESULTS": str(results),  # apart from the suites' results, because failures here are wanted
            "CIEL_BINARY": str(folder / "build/ciel"),
            "CIEL_IMPORT_BINARY": str(folder / "build/ciel-import"),
            "PYTHONPATH": "protocol/python",
            "PYTHONDONTWRITEBYTECODE": "1",
        }

    def remove_all_but(self, names: set[str]) -> None:
        """Removes sources that an earlier run copied and that are gone since. Keeps what is built."""
        for folder, folders, files in os.walk(self.folder):
            here = pathlib.Path(folder).relative_to(self.folder)
            folders[:] = [name for name in folders if str(here / name) not in ("build", "webclient/dist", "webclient/src/generated")]
            for file in files:
                if str(here / file) not in names:
                    (self.folder / here / file).unlink()

    def shell(self, command: str) -> subprocess.CompletedProcess:
        return subprocess.run(["bash", "-c", command], cwd=self.folder, env=self.environment, text=True, errors="replace",
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)

    def build(self, targets: list[str]) -> None:
        commands = []
        programs = [target for target in targets if target != "page"]
        if programs:
            commands.append("[[ -f build/build.ninja ]] || cmake -G Ninja -S . -B build -DCMAKE_BUILD_TYPE=Release -DCIEL_TESTS=ON")
            commands.append("ninja -C build " + " ".join(programs))
        if "page" in targets:
            commands.append("cd webclient && npm run --silent build")
        for command in commands:
            done = self.shell(command)
            if done.returncode != 0:
                raise RuntimeError(f"cannot build {' '.join(targets)}:\n{done.stdout[-3000:]}")

    def patch(self, mutant: Mutant, *options: str) -> None:
        done = subprocess.run(["patch", "-p1", "--silent", "--no-backup-if-mismatch", "--fuzz=0", *options], cwd=self.folder,
                              input=mutant.patch, text=True, capture_output=True, check=False)
        if done.returncode != 0:
            raise RuntimeError(f"the patch does not apply any more; make it anew: {done.stdout}")


def noticed(copy: Copy, mutant: Mutant) -> None:
    """Applies the mutant. Throws RuntimeError with a message if its command passes all the same, or cannot be tried."""
    copy.patch(mutant)
    try:
        copy.build(mutant.targets)
        if copy.shell(mutant.command).returncode == 0:
            raise RuntimeError(f"nothing noticed it: {mutant.what} ({mutant.command})")
    finally:
        copy.patch(mutant, "--reverse")


def problem_with(copy: Copy, mutant: Mutant, sound: dict[str, str]) -> str:
    """Returns what is wrong, or an empty string. `sound`: by command, its output if it failed in the unbroken copy."""
    try:
        if mutant.command not in sound:
            copy.build(mutant.targets)
            done = copy.shell(mutant.command)
            sound[mutant.command] = "" if done.returncode == 0 else done.stdout[-3000:]
        if sound[mutant.command]:
            return f"the command fails without the patch too:\n{sound[mutant.command]}"
        noticed(copy, mutant)
    except RuntimeError as error:
        return str(error)
    return ""


def main(root: pathlib.Path, results: pathlib.Path, suites: list[str]) -> int:
    mutants = [Mutant(path) for path in sorted((root / "tests/mutants").glob("*/*.patch"))]
    mutants = [mutant for mutant in mutants if not suites or mutant.suite in suites]
    copy = Copy(root, root / "build/mutants/tree")
    report = ElementTree.Element("testsuite", name="mutants")
    sound: dict[str, str] = {}
    lacks: dict[str, str] = {"": ""}
    for mutant in mutants:
        started = time.monotonic()
        if mutant.needs not in lacks:
            done = copy.shell(mutant.needs)
            lacks[mutant.needs] = "" if done.returncode == 0 else f"`{mutant.needs}` fails: {done.stdout[-500:]}"
        lack = lacks[mutant.needs]
        problem = "" if lack else problem_with(copy, mutant, sound)
        case = ElementTree.SubElement(report, "testcase", classname=mutant.suite, name=mutant.name,
                                      time=f"{time.monotonic() - started:.3f}")
        if problem or lack:
            ElementTree.SubElement(case, "failure" if problem else "skipped", message=problem or lack)
        said = "FAILED" if problem else "skipped" if lack else "ok"
        print(f"{said}: {mutant.suite} {mutant.name}{': ' if problem or lack else ''}{problem or lack}", flush=True)
        ElementTree.ElementTree(report).write(results)
    return any(case.find("failure") is not None for case in report)


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]), sys.argv[3:]))
