#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""Measures what the compiler needs for the code that typegen writes, and how large it becomes: g++ -O2, C++17.

Called with the build folder; prints the JSON of Google Benchmark. The types are those of typegen_bench.py. Times are CPU time;
the targets are those of an idle machine.
"""
import argparse
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor

sys.dont_write_bytecode = True  # in a folder of sources
from typegen_bench import header_text  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parent.parent
RUNS = 5
MANY = 200

COMPONENT = """#include <measured/typekit/Types.hpp>
#include <rtt/Component.hpp>
#include <rtt/RTT.hpp>
class Measured : public RTT::TaskContext {
public:
    explicit Measured(const std::string& name) : RTT::TaskContext(name) {
        addPort("in", in_);
        addPort("out", out_);
        addProperty("sample", sample_);
    }
    void updateHook() override {
        if (in_.read(sample_) == RTT::NewData) out_.write(sample_);
    }

private:
    RTT::InputPort<measured::Sample0> in_;
    RTT::OutputPort<measured::Sample0> out_;
    measured::Sample0 sample_;
};
ORO_CREATE_COMPONENT(Measured)
"""


class Typekit:
    """The generated sources for so many structs, and how they are compiled."""

    def __init__(self, build, folder, count):
        self.folder = pathlib.Path(folder)
        header = self.folder / "include/measured/measured.hpp"
        header.parent.mkdir(parents=True)
        header.write_text(header_text(count))
        subprocess.run([build / "bin/typegen", "-o", self.folder, "measured", header], check=True)
        includes = (self.folder / "include", self.folder / "types", ROOT / "runtime", build.resolve() / "include")
        self.command = ["g++", "-std=c++17", "-O2", "-fPIC", "-DOROCOS_TARGET=gnulinux", "-DBOOST_BIND_GLOBAL_PLACEHOLDERS",
                        *(f"-I{i}" for i in includes)]
        # Those without types are compiled in no time.
        self.sources = [s for s in sorted(self.folder.glob("types_*.cpp")) if "static_assert" in s.read_text()]

    def compile(self, source):
        """(elapsed, CPU, peak KiB)"""
        begin = time.perf_counter()
        process = subprocess.Popen([*self.command, "-c", source, "-o", source.with_suffix(".o")])
        # wait4() adds what g++ has waited for: the compiler and the assembler.
        _, status, usage = os.wait4(process.pid, 0)
        if status != 0:
            sys.exit(f"typekit_bench: error: g++ cannot compile {source}")
        return time.perf_counter() - begin, usage.ru_utime + usage.ru_stime, usage.ru_maxrss

    def add(self, name, text):
        source = self.folder / name
        source.write_text(text)
        return source


def size_of(objects):
    """Bytes of text and data."""
    lines = subprocess.run(["size", *objects], stdout=subprocess.PIPE, text=True, check=True).stdout.splitlines()[1:]
    return sum(int(line.split()[0]) + int(line.split()[1]) for line in lines)


def entry(name, elapsed, cpu, **more):
    return {"name": name, "run_type": "iteration", "iterations": 1, "real_time": elapsed * 1e3, "cpu_time": cpu * 1e3,
            "time_unit": "ms", **more}


def middle(runs):
    return sorted(runs, key=lambda run: run[1])[len(runs) // 2]


def measure_one(build, folder):
    typekit = Typekit(build, folder, 1)
    source = next(s for s in typekit.sources if "makeStructType<::measured::Sample0>" in s.read_text())
    elapsed, cpu, peak = middle([typekit.compile(source) for _ in range(RUNS)])
    yield entry("typekit/compile, one struct", elapsed, cpu, ms=cpu * 1e3, target_ms=1000)
    yield entry("typekit/compile, one struct, peak memory", elapsed, cpu, bytes=peak * 1024, target_bytes=200e6)
    component = typekit.add("component.cpp", COMPONENT)
    elapsed, cpu, _ = middle([typekit.compile(component) for _ in range(RUNS)])
    yield entry("typekit/compile, component with three uses", elapsed, cpu, ms=cpu * 1e3, target_ms=1500)


def without_instances(text):
    """The instances for users are declared still, so nothing makes them."""
    return re.sub(r"^template class .*\n", "", text, flags=re.M)


def measure_many(build, folder):
    typekit = Typekit(build, folder, MANY)
    bare = [typekit.add("bare_" + s.name, without_instances(s.read_text())) for s in typekit.sources]
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        runs = list(pool.map(typekit.compile, typekit.sources))
        list(pool.map(typekit.compile, bare))
    elapsed, cpu = sum(run[0] for run in runs), sum(run[1] for run in runs)
    yield entry(f"typekit/compile, {MANY} structs, all files", elapsed, cpu, ms=cpu * 1e3, target_ms=100e3)
    # With the vectors that the structs hold: each is a type of its own.
    types = sum(s.read_text().count("addType(") for s in typekit.sources)
    for name, sources, target in (("tables and thunks", bare, 12 * 1024), ("with instances", typekit.sources, 40 * 1024)):
        size = size_of([s.with_suffix(".o") for s in sources]) / types
        yield entry(f"typekit/size of a type, {name}", elapsed, cpu, bytes=size, target_bytes=target,
                    label=f"{types} types")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build", type=pathlib.Path, help="build folder, for example build/dev")
    options = parser.parse_args()
    if not (options.build / "bin/typegen").exists():
        sys.exit(f"typekit_bench: error: no program {options.build / 'bin/typegen'}; build it first")
    results = []
    for measure in (measure_one, measure_many):
        with tempfile.TemporaryDirectory() as folder:
            results += measure(options.build, folder)
    print(json.dumps({"context": {"executable": "g++"}, "benchmarks": results}, indent=2))


if __name__ == "__main__":
    main()
