#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""What CI prints of the steps that failed."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "tools" / "ci_failures.py"
TESTS = """        Start   1: console.program
        Start   2: flow_test.Ports.Connect
1/4 Test   #2: flow_test.Ports.Connect ........................................................   Passed    0.02 sec
        Start   3: flow_test.Ports.Skipped
2/4 Test   #3: flow_test.Ports.Skipped  # GetParam() = LOCKED DATA ........................................................***Skipped   0.02 sec
no privilege
        Start   4: flow_test.Ports.Crash
3/4 Test   #1: console.program ................................................................***Failed   20.13 sec
many lines
AssertionError: 0 != 1

4/4 Test   #4: flow_test.Ports.Crash ..........................................................***Exception: SegFault  0.1 sec

50% tests passed, 2 tests failed out of 4
"""
BUILD = "[1/9] c++ a.o\nFAILED: a.o\na.cpp:3:1: error: no\n" + "c++ b.o\n" * 40 + "ninja: build stopped\n"


def failures(**logs):
    with tempfile.TemporaryDirectory() as folder:
        files = []
        for name, text in logs.items():
            files.append(pathlib.Path(folder) / f"{name}.log")
            files[-1].write_text(text)
        return subprocess.run([sys.executable, SCRIPT, *files], capture_output=True, text=True, check=True).stdout


class CiFailures(unittest.TestCase):
    def test_failed_tests_are_named_with_what_they_printed(self):
        self.assertEqual("--- test: console.program Failed   20.13 sec\nmany lines\nAssertionError: 0 != 1\n"
                         "--- test: flow_test.Ports.Crash Exception: SegFault  0.1 sec\n\n"
                         "--- all failed tests\ntest: console.program Failed   20.13 sec\n"
                         "test: flow_test.Ports.Crash Exception: SegFault  0.1 sec\n", failures(test=TESTS))

    def test_of_many_failures_each_has_fewer_lines(self):
        many = "".join(f"  {i}/20 Test  #{i}: a.t{i} ....***Failed    0.1 sec\n" + "line\n" * 40 for i in range(20))
        out = failures(unit=many)
        self.assertEqual(20 * 8, out.count("line\n"))
        self.assertEqual(20, out.count("\nunit: a.t"))

    def test_of_long_output_the_end_is_kept(self):
        out = failures(asan=TESTS.replace("many lines\n", "line\n" * 100))
        self.assertEqual(29, out.count("line\n"))
        self.assertIn("AssertionError", out)

    def test_a_build_that_failed_tells_its_errors_and_its_end(self):
        out = failures(tsan=BUILD)
        self.assertIn("FAILED: a.o\na.cpp:3:1: error: no\n", out)
        self.assertTrue(out.endswith("ninja: build stopped\n"))
        self.assertEqual(29, out.count("c++ b.o\n"))


if __name__ == "__main__":
    unittest.main()
