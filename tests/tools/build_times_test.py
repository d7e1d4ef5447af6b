#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""The table of tools/build_times.py."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "tools" / "build_times.py"
LOG = """# ninja log v5
0\t1000\t1\tflow/CMakeFiles/store.dir/a.cpp.o\taa
0\t1000\t1\tflow/CMakeFiles/store.dir/a.pcm\taa
500\t3500\t1\tflow/CMakeFiles/store.dir/b.cpp.o\tbb
3500\t3700\t1\tbin/typegen\tcc
"""


NINJA = """
rule copy
  command = cp $in $out
  description = Copying $out
build one: copy a.txt
build two: copy one
build three: copy b.txt
build all: phony two three
build tests: phony
"""


def times(build, *options):
    return subprocess.run([sys.executable, SCRIPT, str(build), *options], capture_output=True, text=True, check=False)


class BuildTimes(unittest.TestCase):
    def test_steps_of_a_target_are_added_up_and_outputs_of_one_step_count_once(self):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / ".ninja_log").write_text(LOG)
            ran = times(folder)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        self.assertIn("| flow/store | 2 | 4.0 | 3.0 |", ran.stdout)
        self.assertIn("| linking | 1 | 0.2 | 0.2 |", ran.stdout)
        self.assertIn("| all | 3 | 4.2 | 3.0 |", ran.stdout)

    def test_touch_counts_what_depends_on_the_file_and_leaves_it_alone(self):
        with tempfile.TemporaryDirectory() as folder:
            build = pathlib.Path(folder)
            (build / "build.ninja").write_text(NINJA)
            for name in ("a.txt", "b.txt"):
                (build / name).write_text(name)
            subprocess.run(["ninja", "-C", folder], check=True, stdout=subprocess.DEVNULL)
            before = (build / "a.txt").stat().st_mtime_ns
            ran = times(build, "--touch", str(build / "a.txt"))
            self.assertEqual((build / "a.txt").stat().st_mtime_ns, before)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        self.assertIn("| all | 2 |", ran.stdout)

    def test_a_folder_without_a_build_is_an_error(self):
        with tempfile.TemporaryDirectory() as folder:
            ran = times(folder)
        self.assertEqual(ran.returncode, 1)
        self.assertIn("build it first", ran.stderr)


if __name__ == "__main__":
    unittest.main()
