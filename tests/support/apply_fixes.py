#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""Applies the fixes of a JSON report (typegen --format=json) to the files that it names.

usage: apply_fixes.py REPORT
"""
import json
import sys


def offset(lines, line, column):
    """Lines and columns count from 1, columns in bytes."""
    return sum(len(text) for text in lines[:line - 1]) + column - 1


def apply(text, fixes):
    lines = text.splitlines(keepends=True)
    edits = {(offset(lines, f["line"], f["column"]), offset(lines, f["endLine"], f["endColumn"]), f["replacement"])
             for f in fixes}  # two diagnostics may want the same
    end = len(text)
    for begin, stop, replacement in sorted(edits, reverse=True):
        if stop > end:
            raise SystemExit("two fixes overlap")
        text = text[:begin] + replacement.encode() + text[stop:]
        end = begin
    return text


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        report = json.load(file)
    by_file = {}
    for diagnostic in report["diagnostics"]:
        for fix in diagnostic["fixes"]:
            by_file.setdefault(fix["file"], []).append(fix)
    for name, fixes in by_file.items():
        with open(name, "rb") as file:
            text = file.read()
        with open(name, "wb") as file:
            file.write(apply(text, fixes))
    print(f"{sum(map(len, by_file.values()))} fixes")


if __name__ == "__main__":
    main()
