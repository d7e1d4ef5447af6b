#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""names_reachable.py COMPILER INCLUDE_DIR...: every header of reachable_names.txt makes its names known by itself."""

import concurrent.futures
import pathlib
import re
import subprocess
import sys

FLAGS = ["-std=c++17", "-fsyntax-only", "-Wall", "-Wextra", "-Werror", "-Wno-unused", "-DOROCOS_TARGET=gnulinux", "-x", "c++", "-"]


def groups():
    """(headers, code) of each group."""
    text = (pathlib.Path(__file__).parent / "reachable_names.txt").read_text(encoding="utf-8")
    for headers, code in re.findall(r"^\[([^]]*)\]\n(.*?)(?=^\[|\Z)", text, re.M | re.S):
        yield headers.split(), code


def compiles(command, header, code):
    source = f"#include <{header}>\n#line 1 \"used after {header}\"\n{code}"
    process = subprocess.run(command, input=source, stderr=subprocess.PIPE, text=True)
    return process.returncode == 0, process.stderr


def main():
    command = [sys.argv[1], *(f"-I{folder}" for folder in sys.argv[2:]), *FLAGS]
    cases = [(header, code) for headers, code in groups() for header in headers]
    failed = 0
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        for good, errors in pool.map(lambda case: compiles(command, *case), cases):
            failed += not good
            sys.stdout.write("" if good else errors)
    print(f"names_reachable: {len(cases) - failed} of {len(cases)} headers make their names known")
    return bool(failed)


if __name__ == "__main__":
    sys.exit(main())
