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

JUDGED = """import json
median = {"run_type": "aggregate", "aggregate_name": "median", "real_time": 50.0, "cpu_time": 31.0, "target_ns": 30.0}
print(json.dumps({"benchmarks": [
    dict(median, name="write/min_time:0.050/repeats:9_median", run_name="write/min_time:0.050/repeats:9"),
    dict(median, name="write/min_time:0.050/repeats:9_mean", run_name="write/min_time:0.050/repeats:9",
         aggregate_name="mean"),
    {"name": "trip/manual_time", "real_time": 9.0, "cpu_time": 9.0, "ratio": 1.125, "target_ratio": 1.25},
    {"name": "memory", "real_time": 9.0, "cpu_time": 9.0, "bytes": 979.9, "target_bytes": 1024.0},
    {"name": "connect", "real_time": 9.0, "cpu_time": 9.0, "ns": 3001.0, "target_ns": 3000.0},
    {"name": "compile", "real_time": 2.0, "cpu_time": 0.9, "time_unit": "s", "target_ms": 1000.0}]}))
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

    def test_targets_are_judged_by_the_quantity_they_name(self):
        status, table, written = bench({"a_bench.py": JUDGED})
        self.assertEqual(status, 0)
        self.assertRegex(table, r"write +50 ns +31 ns +31 ns +30 ns +MISSED")
        self.assertRegex(table, r"trip +9 ns +1\.12x +1\.25x +met")
        self.assertRegex(table, r"memory +9 ns +9 ns +980 bytes +1024 bytes +met")
        self.assertRegex(table, r"connect +9 ns +9 ns +3 us +3 us +MISSED")
        self.assertRegex(table, r"compile +2 s +900 ms +900 ms +1 s +met")
        self.assertIn("3 of 5 targets met", table)
        self.assertEqual([e["name"] for e in written["benchmarks"]], ["write", "trip", "memory", "connect", "compile"])

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
