#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""ci_failures.py LOG…: what failed in the logs of the steps of .ci/run, for the end of its output, which is what is kept
of it: the failed tests with the last lines of what they printed, or, if it did not come to tests, the errors of the build
and the log's last lines. The names of all failed tests come last."""
import pathlib
import re
import sys

LINES = 30
LINES_OF_ALL_TESTS = 90
RESULT = re.compile(r" *\d+/\d+ +Test +#\d+: (.*?) \.\.+ *(.*)")
NEXT = re.compile(r" +Start +\d+: |\d+% tests passed|$")


def failed_tests(lines):
    """(name with result, output) of each."""
    failures = []
    output = None
    for line in lines:
        result = RESULT.match(line)
        if result:
            output = None
            if "***" in result[2] and "***Skipped" not in result[2]:
                output = []
                failures.append((f"{result[1]} {result[2].lstrip('*')}", output))
        elif output is not None:
            if NEXT.match(line) and line:
                output = None
            else:
                output.append(line)
    return failures


def report(log):
    """The names of the failed tests, with their results."""
    lines = log.read_text(errors="replace").splitlines()
    tests = failed_tests(lines)
    for name, output in tests:
        print(f"--- {log.stem}: {name}")
        while output and not output[-1].strip():
            output.pop()
        print("\n".join(output[-max(8, min(LINES, LINES_OF_ALL_TESTS // len(tests))):]))
    if not tests:
        errors = [line for line in lines[:-LINES] if re.search(r"\berror\b|FAILED:", line)]
        print(f"--- {log.stem}: no test failed; its errors and last lines")
        print("\n".join(errors[:LINES] + lines[-LINES:]))
    return [f"{log.stem}: {name}" for name, _ in tests]


def main():
    names = [name for log in sys.argv[1:] for name in report(pathlib.Path(log))]
    if names:
        print("\n".join(["--- all failed tests", *names]))


if __name__ == "__main__":
    main()
