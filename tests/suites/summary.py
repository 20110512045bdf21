"""Adds up the JUnit files of the suites and prints the closing line: summary.py RESULTS SUITE... [--broken SUITE...]

A suite without a result counts as one failure. So does a broken suite, which ended with an error, if all its tests passed:
an error outside of tests, for example in a cleanup hook, leaves no test case."""

import argparse
import pathlib
import re
import sys
import xml.etree.ElementTree as ElementTree


# Failure messages may contain terminal color codes, which are invalid in XML.
NOT_XML = re.compile(r"[\x00-\x08\x0b\x0c\x0e-\x1f]|&#x1b;|&#27;", re.IGNORECASE)


def outcome(case: ElementTree.Element) -> str:
    if case.find("failure") is not None or case.find("error") is not None:
        return "failed"
    if case.find("skipped") is not None or case.get("status") in ("disabled", "notrun"):
        return "skipped"
    return "passed"


def main(results: pathlib.Path, suites: list[str], broken: list[str]) -> int:
    counts = {"passed": 0, "failed": 0, "skipped": 0}
    for suite in suites:
        files = sorted(results.glob(f"{suite}*.xml"))
        cases = []
        for file in files:
            try:
                cases += list(ElementTree.fromstring(NOT_XML.sub("", file.read_text())).iter("testcase"))
            except ElementTree.ParseError as error:
                print(f"{file.name}: {error}")
        if not cases:
            print(f"FAILED {suite}: no test reported a result")
            counts["failed"] += 1
        kinds = [outcome(case) for case in cases]
        if cases and suite in broken and "failed" not in kinds:
            print(f"FAILED {suite}: it ended with an error, though no test did; see above")
            counts["failed"] += 1
        for case, kind in zip(cases, kinds):
            counts[kind] += 1
            name = f"{suite}: {case.get('classname', '')} {case.get('name', '')}"
            if kind == "failed":
                print(f"FAILED {name}")
            if kind == "skipped":
                why = case.find("skipped")
                message = "" if why is None else (why.get("message") or (why.text or "").strip())
                print(f"skipped {name} {message}".rstrip())
    skipped = f", {counts['skipped']} skipped" if counts["skipped"] else ""
    print(f"{counts['passed']} passed, {counts['failed']} failed{skipped}")
    return 1 if counts["failed"] or not counts["passed"] else 0


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("results", type=pathlib.Path)
    parser.add_argument("suites", nargs="+")
    parser.add_argument("--broken", nargs="*", default=[])
    options = parser.parse_args()
    sys.exit(main(options.results, options.suites, options.broken))
