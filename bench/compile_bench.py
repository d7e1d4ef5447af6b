#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""Measures what the compiler needs for <rtt/RTT.hpp> and for components, in user time: g++ -O2, C++17.

Called with the build folder; prints the JSON of Google Benchmark, or a table with --table. All are compared with the
standard and Boost headers that the umbrella header includes, compiled in turns with it: `ratio` is what counts on a machine
that is busy or slow. The targets in milliseconds are those of an idle machine on which that floor takes about 700 ms.
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

ROOT = pathlib.Path(__file__).resolve().parent.parent
RUNS = 7

UMBRELLA = "#include <rtt/RTT.hpp>\n"

COMPONENT = """#include <rtt/RTT.hpp>
#include <rtt/Component.hpp>
struct Sample {
    int number;
    double level;
};
class Measured : public RTT::TaskContext {
public:
    explicit Measured(const std::string& name) : RTT::TaskContext(name), gain_("gain", "of the control loop") {
        addEventPort("level", level_);
        addPort("set_point", set_point_);
        addPort("valve", valve_);
        addProperty(gain_);
    }
    void updateHook() override {
        Sample sample = gain_.value();
        while (level_.read(sample) == RTT::NewData) valve_.write(sample);
        set_point_.read(sample);
    }

private:
    RTT::InputPort<Sample> level_, set_point_;
    RTT::OutputPort<Sample> valve_;
    RTT::Property<Sample> gain_;
};
ORO_CREATE_COMPONENT(Measured)
"""

OPERATIONS = """#include <rtt/RTT.hpp>
#include <rtt/Component.hpp>
class Measured : public RTT::TaskContext {
public:
    explicit Measured(const std::string& name) : RTT::TaskContext(name) {
        addOperation("reset", &Measured::reset, this, RTT::OwnThread).doc("Forgets all.");
        addOperation("limit", &Measured::limit, this, RTT::OwnThread).doc("Sets limits.").arg("low", "").arg("high", "");
        addOperation("count", &Measured::count, this).doc("Counts letters.").arg("text", "of anything");
    }

private:
    void reset() {}
    bool limit(double low, double high) { return low < high; }
    int count(const std::string& text) { return static_cast<int>(text.size()); }
};
ORO_CREATE_COMPONENT(Measured)
"""

FLOOR = "compile/floor: its standard and Boost headers"
# (name, text, milliseconds of user time at most)
MEASURED = [
    ("compile/rtt/RTT.hpp alone", UMBRELLA, 1000),
    ("compile/component, 3 ports, 1 property", COMPONENT, 1500),
    ("compile/component, 3 operations", OPERATIONS, 1500),
]


class Compiler:
    def __init__(self, build, folder):
        self.folder = pathlib.Path(folder)
        includes = (ROOT / "runtime", build.resolve() / "include")
        self.command = ["g++", "-std=c++17", "-O2", "-fPIC", "-DOROCOS_TARGET=gnulinux", "-DBOOST_BIND_GLOBAL_PLACEHOLDERS",
                        *(f"-I{i}" for i in includes)]

    def foreign_headers(self):
        """An #include line for each header outside the project that the umbrella header includes directly or not."""
        source = self.folder / "umbrella.cpp"
        source.write_text(UMBRELLA)
        listed = subprocess.run([*self.command, "-H", "-fsyntax-only", str(source)], stderr=subprocess.PIPE, text=True,
                                check=True)
        lines, depth_of_foreign = [], 0
        for dots, header in re.findall(r"^(\.+) (.*)$", listed.stderr, re.M):
            if depth_of_foreign and len(dots) > depth_of_foreign:
                continue  # included by a foreign one
            ours = str(ROOT) in header or "/rtt/" in header
            depth_of_foreign = 0 if ours else len(dots)
            if not ours:
                lines.append(f'#include "{header}"')
        return "\n".join(lines) + "\n"

    def user_time(self, name, text):
        """(elapsed, user) seconds of one compilation."""
        source = self.folder / f"{name}.cpp"
        source.write_text(text)
        begin = time.perf_counter()
        process = subprocess.Popen([*self.command, "-c", str(source), "-o", str(source.with_suffix(".o"))])
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode != 0:
            sys.exit(f"compile_bench: error: {' '.join(process.args)} ended with status {process.returncode}")
        return time.perf_counter() - begin, usage.ru_utime


def measure(build):
    with tempfile.TemporaryDirectory() as folder:
        compiler = Compiler(build, folder)
        texts = [(FLOOR, compiler.foreign_headers(), None), *MEASURED]
        times = {name: [] for name, _, _ in texts}
        for _ in range(RUNS):
            for number, (name, text, _) in enumerate(texts):
                times[name].append(compiler.user_time(f"measured{number}", text))
    floor = None
    for name, _, target in texts:
        real, user = (sorted(column)[RUNS // 2] * 1e3 for column in zip(*times[name]))
        floor = floor or user
        result = {"name": name, "run_type": "iteration", "iterations": RUNS, "real_time": real, "cpu_time": user,
                  "time_unit": "ms"}
        if target:
            result.update(ms=user, target_ms=target, label=f"{user / floor:.2f}x floor")
        yield result


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build", type=pathlib.Path, help="build folder, for example build/dev")
    parser.add_argument("--table", action="store_true", help="a table instead of JSON")
    options = parser.parse_args()
    results = list(measure(options.build))
    if options.table:
        for result in results:
            print(f"{result['name']:<48} {result['real_time']:8.0f} ms {result['cpu_time']:8.0f} ms user")
    else:
        print(json.dumps({"context": {"executable": "g++"}, "benchmarks": results}, indent=2))


if __name__ == "__main__":
    main()
