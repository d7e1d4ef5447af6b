#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""Measures typegen on generated headers with 1, 50, 200 and 1,000 structs: into an empty folder, and with nothing changed.

Called with the build folder; prints the JSON of Google Benchmark, or a table with --table. With --header N it prints the
header with N structs instead, from which typekit_import_bench is built.
"""
import argparse
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time

SIZES = (1, 50, 200, 1000)
JUDGED = 200
LARGE = 1000
RUNS = 5

START = """#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>
namespace measured {
enum class Mode : std::uint8_t { Off, On, Fault };
"""

# Nine fields of all kinds; most structs hold the one before, so that the closure has something to do.
STRUCT = """/// Sample number {i}.
struct Sample{i} {{
    std::uint64_t time;  ///< @unit ns
    double position[3];
    float raw[8];
    std::array<double, 6> joints;
    std::string name;
    std::vector<double> values;
    Mode mode;
{links}}};
"""


def header_text(count):
    structs = []
    for i in range(count):
        before = f"    Sample{i - 1} previous;\n    std::vector<Sample{i - 1}> history;\n" if i % 5 else ""
        structs.append(STRUCT.format(i=i, links=before))
    return START + "".join(structs) + "}\n"


def run_once(typegen, header, output):
    """(elapsed, CPU, peak KiB) of one run."""
    begin = time.perf_counter()
    process = subprocess.Popen([typegen, "-o", str(output), "measured", str(header)])
    _, status, usage = os.wait4(process.pid, 0)
    elapsed = time.perf_counter() - begin
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        sys.exit(f"typegen_bench: error: typegen ended with status {process.returncode}")
    return elapsed, usage.ru_utime + usage.ru_stime, usage.ru_maxrss


def entry(name, measured, count):
    """The middle one of several runs, as Google Benchmark reports it."""
    elapsed, cpu, peak = sorted(measured)[len(measured) // 2]
    return {"name": name, "run_type": "iteration", "iterations": len(measured), "real_time": elapsed * 1e3,
            "cpu_time": cpu * 1e3, "time_unit": "ms", "items_per_second": count / elapsed,
            "label": f"peak {peak / 1024:.0f} MiB", "peak_kib": peak}


def measure(typegen):
    with tempfile.TemporaryDirectory() as folder:
        for count in SIZES:
            header = pathlib.Path(folder) / f"types{count}.hpp"
            header.write_text(header_text(count))
            fresh = [pathlib.Path(folder) / f"out{count}_{run}" for run in range(RUNS)]
            cold = entry(f"typegen/cold/structs:{count}", [run_once(typegen, header, out) for out in fresh], count)
            again = [run_once(typegen, header, fresh[0]) for _ in range(RUNS)]
            unchanged = entry(f"typegen/unchanged/structs:{count}", again, count)
            if count == JUDGED:
                judged = cold["real_time"]
                cold.update(ms=judged, target_ms=1000)
                unchanged.update(ms=unchanged["real_time"], target_ms=50)
                peak = dict(cold, name=f"typegen/peak memory/structs:{count}", bytes=cold["peak_kib"] * 1024,
                            target_bytes=250e6)
                del peak["ms"], peak["target_ms"]
                yield peak
            if count == LARGE:
                # The time of so many, compared with that of 200.
                cold.update(ratio=cold["real_time"] / judged, target_ratio=5)
            yield cold
            yield unchanged


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build", type=pathlib.Path, nargs="?", help="build folder, for example build/dev")
    parser.add_argument("--header", type=int, metavar="N", help="print a header with N structs")
    parser.add_argument("--table", action="store_true", help="a table instead of JSON")
    options = parser.parse_args()
    if options.header:
        print(header_text(options.header), end="")
        return
    if not options.build:
        parser.error("the build folder is missing")
    typegen = options.build / "bin" / "typegen"
    if not typegen.exists():
        sys.exit(f"typegen_bench: error: no program {typegen}; build it first")
    results = list(measure(str(typegen)))
    if options.table:
        for result in results:
            print(f"{result['name']:<32} {result['real_time']:8.1f} ms {result['cpu_time']:8.1f} ms CPU  {result['label']}")
    else:
        print(json.dumps({"context": {"executable": "typegen"}, "benchmarks": results}, indent=2))


if __name__ == "__main__":
    main()
