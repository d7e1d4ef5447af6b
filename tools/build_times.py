#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""Prints how long each part of a build took, from ninja's log: build_times.py [BUILD…], default build/dev.

A part is the folder of a target. "s" is the time of its steps added up, on however many processors they ran side by side;
a step that came from ccache counts with what it took then. "longest" is its longest step.

With --touch FILE, only the steps that a change of FILE leads to.
"""
import argparse
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile


def part_of(output):
    """generator/CMakeFiles/x.dir/y.o belongs to generator/x; what is linked, to linking; what a command makes, to its folder."""
    found = re.match(r"(.*?)/?CMakeFiles/([^/]+)\.dir/", output)
    if found:
        return "/".join(filter(None, found.groups()))
    if output.startswith(("lib/", "bin/", "archive/", "tests/bin/")):
        return "linking"
    return "/".join(output.split("/")[:-1][:3]) or "other"


def read_steps(log):
    """(output, seconds) of each step; of one that ran more than once, the last time. Outputs of one step count once."""
    steps = {}
    folder = f"{log.resolve().parent}/"
    for line in log.read_text().splitlines()[1:]:
        start, end, _, output, command = line.split("\t")
        steps[(start, end, command)] = (output.removeprefix(folder), (int(end) - int(start)) / 1000)
    return {output: seconds for output, seconds in steps.values()}


def table(steps):
    parts = {}
    for output, seconds in steps.items():
        count, total, longest = parts.get(part_of(output), (0, 0.0, 0.0))
        parts[part_of(output)] = (count + 1, total + seconds, max(longest, seconds))
    rows = ["| part | steps | s | longest |", "|---|--:|--:|--:|"]
    for name, (count, total, longest) in sorted(parts.items(), key=lambda part: -part[1][1]):
        rows.append(f"| {name} | {count} | {total:.1f} | {longest:.1f} |")
    rows.append(f"| all | {len(steps)} | {sum(steps.values()):.1f} | {max(steps.values(), default=0):.1f} |")
    return rows


def steps_after_touch(build, file):
    """Outputs that ninja would make for `all` and `tests` if the file had just been changed. The file stays as it is."""
    before = file.stat()
    # A dry run of build.ninja itself ends with the question whether CMake has to make it anew.
    with tempfile.NamedTemporaryFile("w", dir=build, suffix=".ninja") as manifest:
        manifest.write("include build.ninja\n")
        manifest.flush()
        file.touch()
        try:
            run = subprocess.run(["ninja", "-C", str(build), "-f", manifest.name, "-n", "all", "tests"],
                                 env=os.environ | {"NINJA_STATUS": "step: "}, capture_output=True, text=True, check=True)
        finally:
            os.utime(file, ns=(before.st_atime_ns, before.st_mtime_ns))
    return [line.split()[-1] for line in run.stdout.splitlines() if line.startswith("step: ")]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build", nargs="*", type=pathlib.Path, default=[pathlib.Path("build/dev")])
    parser.add_argument("--touch", type=pathlib.Path, metavar="FILE", help="only the steps that a change of FILE leads to")
    arguments = parser.parse_args()
    status = 0
    for build in map(pathlib.Path.resolve, arguments.build):
        log = build / ".ninja_log"
        if not log.exists():
            print(f"build_times.py: error: no {log}; build it first", file=sys.stderr)
            status = 1
            continue
        steps = read_steps(log)
        if arguments.touch:
            # A step that has never run, or whose description does not end with its output, counts without its time.
            steps = {output: steps.get(output, 0.0) for output in steps_after_touch(build, arguments.touch)}
        print(f"{build}\n", *table(steps), "", sep="\n")
    return status


if __name__ == "__main__":
    signal.signal(signal.SIGPIPE, signal.SIG_DFL)  # `| head` may read less than all
    sys.exit(main())
