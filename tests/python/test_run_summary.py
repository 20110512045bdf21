"""The closing line of tests/run: the cases that it counts as failed."""

import pathlib
import subprocess
import sys

SUMMARY = pathlib.Path(__file__).parents[1] / "suites" / "summary.py"
PASSED = '<testsuite><testcase classname="c" name="passes"/></testsuite>'
FAILED = '<testsuite><testcase classname="c" name="fails"><failure message="no"/></testcase></testsuite>'


def summary(results, *arguments):
    done = subprocess.run([sys.executable, SUMMARY, results, *arguments], capture_output=True, text=True)
    return done.returncode, done.stdout.splitlines()[-1]


def test_a_suite_that_broke_although_its_tests_passed_is_a_failure(tmp_path):
    (tmp_path / "browser.xml").write_text(PASSED)
    assert summary(tmp_path, "browser", "--broken") == (0, "1 passed, 0 failed")
    assert summary(tmp_path, "browser", "--broken", "browser") == (1, "1 passed, 1 failed")


def test_a_failed_test_is_counted_once_and_so_is_a_suite_without_a_result(tmp_path):
    (tmp_path / "browser.xml").write_text(FAILED)
    assert summary(tmp_path, "browser", "--broken", "browser") == (1, "0 passed, 1 failed")
    assert summary(tmp_path, "browser", "wasm", "--broken", "wasm") == (1, "0 passed, 2 failed")
