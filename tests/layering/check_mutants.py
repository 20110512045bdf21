"""Fails when a patch of tests/mutants does not apply to the sources. The suite `mutants`, which breaks them with these
patches, runs only on request."""

import pathlib
import subprocess
import sys


def problem_with(root: pathlib.Path, mutant: pathlib.Path) -> str:
    patch = mutant.read_text(encoding="utf-8").partition("\n--- ")[2]
    done = subprocess.run(["patch", "-p1", "--dry-run", "--fuzz=0", "--directory", root], input="--- " + patch,
                          text=True, capture_output=True, check=False)
    return f"{mutant}: does not apply any more; make it anew: {done.stdout}" if done.returncode != 0 else ""


def main(root: pathlib.Path) -> int:
    mutants = sorted((root / "tests/mutants").glob("*/*.patch"))
    problems = [problem for mutant in mutants if (problem := problem_with(root, mutant))]
    print("\n".join(problems) or f"{len(mutants)} mutants apply")
    return 1 if problems or not mutants else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
