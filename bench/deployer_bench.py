#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""Measures the deployer as a program: how long checks take, and what it needs when it has nothing to do.

Called with the build folder; prints the JSON of Google Benchmark. Times are CPU time; the targets are those of an idle
machine. What stands in deployment_bench.cpp is what deploying takes inside a process.
"""
import argparse
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

RUNS = 9
COMPONENTS = 1000

PAGE = '<?xml version="1.0" encoding="UTF-8"?>\n<!DOCTYPE properties SYSTEM "cpf.dtd">\n<properties>\n{}</properties>\n'
IMPORT = '  <simple name="Import" type="string"><value>ocl</value></simple>\n'
# Each reads what the one before it sends.
COMPONENT = """  <struct name="c{0}" type="OCL::HelloWorld">
    <struct name="Ports" type="PropertyBag">
      <simple name="the_buffer_port" type="string"><value>w{0}</value></simple>
      <simple name="the_results" type="string"><value>w{1}</value></simple>
    </struct>
    <simple name="AutoConf" type="boolean"><value>1</value></simple>
  </struct>
"""


def entry(name, elapsed, cpu, **more):
    return {"name": name, "run_type": "iteration", "iterations": 1, "real_time": elapsed * 1e3, "cpu_time": cpu * 1e3,
            "time_unit": "ms", **more}


class Deployer:
    def __init__(self, build, folder):
        self.folder = folder
        self.program = build.resolve() / "bin/deployer-gnulinux"
        if not self.program.exists():
            sys.exit(f"deployer_bench: error: no program {self.program}; build it first")
        self.environment = dict(os.environ, ORO_LOGFILE="/dev/null",
                                RTT_COMPONENT_PATH=str(build.resolve() / "lib/orocos"))

    def start(self, words, **more):
        return subprocess.Popen([self.program, *words], cwd=self.folder, env=self.environment,
                                stdout=subprocess.DEVNULL, **more)

    def check(self, words):
        """(elapsed, CPU, status) of the median of several runs"""
        runs = []
        for _ in range(RUNS):
            begin = time.perf_counter()
            process = self.start(words, stdin=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
            runs.append((time.perf_counter() - begin, usage.ru_utime + usage.ru_stime, process.returncode))
        return sorted(runs, key=lambda run: run[1])[RUNS // 2]

    def resident(self):
        """Bytes of an idle deployer, in which nothing was deployed."""
        process = self.start([], stdin=subprocess.PIPE, stderr=subprocess.DEVNULL)
        time.sleep(1)
        status = pathlib.Path(f"/proc/{process.pid}/status").read_text()
        process.send_signal(signal.SIGTERM)
        process.wait()
        return int(status.split("VmRSS:")[1].split()[0]) * 1024


def measure(build, folder):
    deployer = Deployer(build, folder)
    (folder / "empty.xml").write_text(PAGE.format(""))
    (folder / "many.xml").write_text(
        PAGE.format(IMPORT + "".join(COMPONENT.format(i, i + 1) for i in range(COMPONENTS))))
    for name, words, expected, target in (
            ("deployer/check of an empty file", ["--check", "-s", "empty.xml"], 255, 8),
            (f"deployer/dry run, {COMPONENTS} components", ["--dry-run", "-s", "many.xml"], 0, 30)):
        elapsed, cpu, status = deployer.check(words)
        if status != expected:
            sys.exit(f"deployer_bench: error: {' '.join(words)} ended with status {status}")
        yield entry(name, elapsed, cpu, ms=cpu * 1e3, target_ms=target)
    yield entry("deployer/resident memory, nothing deployed", 0, 0, bytes=deployer.resident(), target_bytes=10e6)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build", type=pathlib.Path, help="build folder, for example build/dev")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        results = list(measure(options.build, pathlib.Path(folder)))
    print(json.dumps({"context": {"executable": "deployer"}, "benchmarks": results}, indent=2))


if __name__ == "__main__":
    main()
