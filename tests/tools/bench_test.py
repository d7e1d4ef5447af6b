#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

RUN = pathlib.Path(__file__).resolve().parents[2] / "bench" / "run"
RESULT = """import json, sys
print(json.dumps({"context": {"num_cpus": 2}, "benchmarks": [
    {"name": "write", "real_time": 41.26, "cpu_time": 41.0, "time_unit": "ns", "items_per_second": 2.4e7},
    {"name": "deploy/1000", "real_time": 1500.0, "cpu_time": 1.0, "time_unit": "ms"}]}))
"""


def bench(scripts, *options):
    """(exit code, table, JSON or None) of bench/run with the given scripts."""
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for name, text in scripts.items():
            (root / name).write_text(text)
        out = root / "out" / "bench.json"
        run = subprocess.run([sys.executable, str(RUN), "--build", folder, "--scripts", folder, "--json", str(out), *options],
                             capture_output=True, text=True)
        return run.returncode, run.stdout, json.loads(out.read_text()) if out.exists() else None


class BenchRun(unittest.TestCase):
    def test_table_and_json_have_every_result(self):
        status, table, written = bench({"a_bench.py": RESULT})
        self.assertEqual(status, 0)
        self.assertRegex(table, r"write +41\.3 ns +41 ns +2\.4e\+07 items/s")
        self.assertRegex(table, r"deploy/1000 +1\.5 s +1 ms")
        self.assertEqual([(e["name"], e["program"]) for e in written["benchmarks"]],
                         [("write", "a_bench"), ("deploy/1000", "a_bench")])
        self.assertEqual(written["context"], {"num_cpus": 2})

    def test_failing_benchmark_fails_the_run_but_not_the_others(self):
        status, table, written = bench({"a_bench.py": "import sys; sys.exit(3)", "b_bench.py": RESULT})
        self.assertEqual(status, 1)
        self.assertIn("write", table)
        self.assertEqual(len(written["benchmarks"]), 2)

    def test_filter_leaves_programs_out(self):
        status, _, written = bench({"a_bench.py": "import sys; sys.exit(3)", "b_bench.py": RESULT}, "--filter", "^b_")
        self.assertEqual(status, 0)
        self.assertEqual(len(written["benchmarks"]), 2)

    def test_no_benchmark_is_an_error(self):
        self.assertEqual(bench({})[0], 1)


if __name__ == "__main__":
    unittest.main()
