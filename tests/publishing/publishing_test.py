"""The files that a public project needs. Only version.txt states the version."""

import json
import pathlib
import re
import subprocess
import sys
import unittest

PROGRAM = pathlib.Path(sys.argv.pop(2)) if len(sys.argv) > 2 else None
ROOT = pathlib.Path(sys.argv.pop(1) if len(sys.argv) > 1 else pathlib.Path(__file__).parents[2]).resolve()
# Headings that keepachangelog.com 1.1.0 allows inside a release.
KINDS = {"Added", "Changed", "Deprecated", "Removed", "Fixed", "Security"}


def text(path: str) -> str:
    return (ROOT / path).read_text(encoding="utf-8")


def project_version() -> str:
    return text("server/ciel/version.txt").strip()


def front_matter(template: str) -> str:
    match = re.match(r"---\n(.*?\n)---\n.+", template, re.S)
    return match.group(1) if match else ""


class Version(unittest.TestCase):
    def test_the_program_prints_it(self):
        printed = subprocess.run([PROGRAM, "--version"], capture_output=True, text=True, check=True).stdout
        self.assertEqual(printed.strip(), f"ciel {project_version()}")

    def test_the_newest_release_of_the_changelog_has_it(self):
        released = re.findall(r"^## \[(\d+\.\d+\.\d+)\]", text("CHANGELOG.md"), re.M)
        self.assertEqual(released[0], project_version())

    def test_no_other_file_states_it(self):
        listed = subprocess.run(["git", "-C", ROOT, "grep", "-lIwF", project_version(), "--"], capture_output=True, text=True, check=True)
        stated = {path for path in listed.stdout.split() if not path.endswith("package-lock.json")}  # of other projects
        # The changelog names its releases, an example of an answer has some version, and one file is generated.
        allowed = {"server/ciel/version.txt", "CHANGELOG.md", "protocol/openrpc.json", "protocol/python/ciel_client/version.py"}
        self.assertLessEqual(stated, allowed)

    def test_private_packages_have_none(self):
        self.assertNotIn("version", json.loads(text("webclient/package.json")).keys())
        self.assertNotIn("version", json.loads(text("webclient/package-lock.json"))["packages"][""].keys())


class License(unittest.TestCase):
    def test_three_clauses_and_whose(self):
        license_text = text("LICENSE")
        self.assertRegex(license_text, r"^BSD 3-Clause License\n\nCopyright \(c\) \d{4} The CIEL authors\n")
        self.assertEqual(re.findall(r"^(\d)\. ", license_text, re.M), ["1", "2", "3"])
        self.assertIn('THE COPYRIGHT HOLDERS AND CONTRIBUTORS "AS IS"', license_text)

    def test_each_color_map_states_its_own(self):
        for color_map in json.loads(text("protocol/colormaps.json"))["maps"]:
            self.assertTrue(color_map["license"] and color_map["source"], color_map["name"])

    def test_the_readme_names_it(self):
        self.assertTrue("[LICENSE](LICENSE)" in text("README.md"))


class Changelog(unittest.TestCase):
    def test_each_release_has_a_date_and_known_headings(self):
        releases = re.split(r"^## ", text("CHANGELOG.md"), flags=re.M)[1:]
        self.assertEqual(releases[0].splitlines()[0], "[Unreleased]")
        versions = []
        for release in releases[1:]:
            heading = re.fullmatch(r"\[(\d+)\.(\d+)\.(\d+)\] - \d{4}-\d{2}-\d{2}", release.splitlines()[0])
            self.assertIsNotNone(heading, release.splitlines()[0])
            versions.append(tuple(int(part) for part in heading.groups()))
            kinds = re.findall(r"^### (.+)$", release, re.M)
            self.assertTrue(kinds)
            self.assertLessEqual(set(kinds), KINDS)
        self.assertEqual(versions, sorted(versions, reverse=True), "newest first")


class Citation(unittest.TestCase):
    def test_names_the_paper(self):
        citation = text("CITATION.cff")
        for required in ("cff-version: 1.2.0", "message:", "title: CIEL", "authors:", "license: BSD-3-Clause"):
            self.assertIn(f"\n{required}", f"\n{citation}")
        for name in ("Lévy", "Caumon", "Conreaux", "Cavin", "inria-00101087", "year: 2001"):
            self.assertIn(name, citation)


class Community(unittest.TestCase):
    def test_contributors_are_told_how(self):
        for path in (".github/CONTRIBUTING.md", ".github/SECURITY.md", ".github/PULL_REQUEST_TEMPLATE.md"):
            with self.subTest(path):
                self.assertGreater(len(text(path)), 200)

    def test_issue_templates_have_the_front_matter_that_offers_them(self):
        templates = sorted((ROOT / ".github/ISSUE_TEMPLATE").glob("*.md"))
        self.assertGreaterEqual(len(templates), 2)
        for template in templates:
            with self.subTest(template.name):
                self.assertRegex(front_matter(template.read_text(encoding="utf-8")), r"(?s)name: .+about: .+")

    def test_files_that_are_named_exist(self):
        for path in sorted([*ROOT.glob("*.md"), *(ROOT / ".github").rglob("*.md")]):
            for target in re.findall(r"\]\((?!https?:|#)([^)#]+)", path.read_text(encoding="utf-8")):
                with self.subTest(f"{path.relative_to(ROOT)} -> {target}"):
                    self.assertTrue((path.parent / target).exists())


if __name__ == "__main__":
    unittest.main()
