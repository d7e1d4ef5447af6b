#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""Keeps files and functions short.

LIM01  a file longer than its limit: 400 lines, 150 for a template
LIM02  a function longer than 80 lines
"""
import re
import sys

from source_tree import Report, open_tree

CODE = (".hpp", ".h", ".inl", ".cpp", ".c", ".py", ".sh", ".cmake", ".lua")
MAX_LINES = 400
MAX_TEMPLATE_LINES = 150
MAX_FUNCTION_LINES = 80
UNCHECKED = ("tests/golden/", "examples/")

# path -> lines it may have, with the reason. To be emptied, not filled.
ALLOWED = {
}

# A line that opens the body of a function: not a control statement, not a type, not a namespace.
OPENING = re.compile(r"^[ \t]*(?!template\b[^(]*>\s*(?:class|struct|union)\b)(?!(?:if|for|while|switch|do|else|catch|namespace|class|struct|union|enum|extern)\b|\})"
                     r"[^;]*\)[^;()]*\{[ \t]*(?://.*)?$")
# Literals and comments of one line.
NOT_CODE = re.compile(r'"(?:\\.|[^"\\])*"|\'(?:\\.|[^\'\\])*\'|//.*')


def limit_of(path):
    if path in ALLOWED:
        return ALLOWED[path]
    return MAX_TEMPLATE_LINES if path.startswith("templates/") else MAX_LINES


def is_code(path):
    name = path.rpartition("/")[2]
    return (path.endswith(CODE) or name in ("CMakeLists.txt", "dev", "run") or path.startswith("templates/"))


def long_functions(lines):
    """(first line, length) of functions over the limit, by counting braces outside of literals and comments."""
    for start, line in enumerate(lines):
        if not OPENING.match(line):
            continue
        depth = 0
        for end in range(start, len(lines)):
            code = NOT_CODE.sub("", lines[end])
            depth += code.count("{") - code.count("}")
            if depth <= 0:
                if end - start + 1 > MAX_FUNCTION_LINES:
                    yield start + 1, end - start + 1
                break


def main():
    tree = open_tree(__doc__.splitlines()[0])
    report = Report()
    checked = 0
    for path in tree.files:
        if path.startswith(UNCHECKED) or not is_code(path):
            continue
        checked += 1
        lines = (tree.text(path) or "").splitlines()
        limit = limit_of(path)
        if len(lines) > limit:
            report.error(path, limit + 1, "LIM01", f"{len(lines)} lines, expected at most {limit}")
        if path.endswith((".cpp", ".hpp", ".inl", ".h")):
            for line, length in long_functions(lines):
                report.error(path, line, "LIM02", f"function of {length} lines, expected at most {MAX_FUNCTION_LINES}")
    for path in ALLOWED:
        if path not in tree:
            report.error("tools/check_limits.py", 1, "LIM01", f"allow-list names {path}, which does not exist")
    return report.finish("check_limits", checked)


if __name__ == "__main__":
    sys.exit(main())
