#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""Checks how files begin and what no file may say.

HDR01  the SPDX or the copyright line is missing from the first lines
HDR02  a header without include guard
HDR03  two headers with the same include guard
HDR04  an absolute path of one machine
HDR05  a word that says the work is unfinished
HDR06  tab or blank at the end of a line, or a file that does not end with a newline
"""
import re
import sys

from source_tree import Report, open_tree

SPDX = "SPDX-License-Identifier: Apache-2.0"
COPYRIGHT = "Copyright Oroforge contributors"
FIRST_LINES = 6

LICENSED = (".hpp", ".h", ".inl", ".cpp", ".c", ".py", ".sh", ".cmake", ".lua", ".h.in", ".hpp.in", ".cmake.in", ".mustache")
LICENSED_NAMES = {"CMakeLists.txt", "dev", "run", "packages.txt", ".clang-format", ".clang-tidy", ".gitignore"}
HEADERS = (".hpp", ".h")
TEXT = LICENSED + (".md", ".txt", ".xml", ".json", ".cpf", ".ops")

# Inputs and outputs of tests are what a user wrote or got, byte for byte; so are the texts the generators fill in.
# Here only the words are checked (HDR04, HDR05).
DATA = ("tests/golden/", "tests/build/packages/", "templates/")
# Headers that are meant to be included more than once.
REPEATABLE = ()

GUARD = re.compile(r"^[ \t]*#[ \t]*ifndef[ \t]+(\w+)[ \t]*\n(?:[ \t]*\n)*[ \t]*#[ \t]*define[ \t]+\1\b", re.MULTILINE)
PRAGMA_ONCE = re.compile(r"^[ \t]*#[ \t]*pragma[ \t]+once\b", re.MULTILINE)
# Assembled, so that this file does not contain what it looks for.
MACHINE_PATH = re.compile(r"(?<![\w.}$@/-])/(?:%s)/[\w.]" % "|".join(["home", "root", "work", "Users", "mnt"]))
UNFINISHED = re.compile(r"\b(?:%s)\b" % "|".join(["TO" + "DO", "FIX" + "ME", "HA" + "CK", "X" + "XX"]))


def line_of(text, offset):
    return text.count("\n", 0, offset) + 1


def check_licence(report, path, text):
    head = "\n".join(text.splitlines()[:FIRST_LINES])
    for wanted in (SPDX, COPYRIGHT):
        if wanted not in head:
            report.error(path, 1, "HDR01", f"'{wanted}' not found in the first {FIRST_LINES} lines")


def check_guard(report, path, text, guards):
    if path in REPEATABLE:
        return
    match = GUARD.search(text)
    if not match:
        if not PRAGMA_ONCE.search(text):
            report.error(path, 1, "HDR02", "found neither an include guard nor #pragma once")
        return
    name = match.group(1)
    if name in guards:
        report.error(path, line_of(text, match.start()), "HDR03", f"include guard {name} is also that of {guards[name]}")
    guards.setdefault(name, path)


def check_words(report, path, text):
    for number, line in enumerate(text.splitlines(), 1):
        match = MACHINE_PATH.search(line)
        if match:
            report.error(path, number, "HDR04", f"path of one machine: '{line[match.start():].split()[0]}'")
        match = UNFINISHED.search(line)
        if match:
            report.error(path, number, "HDR05", f"'{match.group()}': finish it, or write it into an issue")


def check_ends(report, path, text):
    for number, line in enumerate(text.split("\n"), 1):
        if line != line.rstrip():
            report.error(path, number, "HDR06", "blank at the end of the line")
    if text and not text.endswith("\n"):
        report.error(path, line_of(text, len(text)), "HDR06", "no newline at the end of the file")


def main():
    tree = open_tree(__doc__.splitlines()[0])
    report = Report()
    guards = {}
    checked = 0
    for path in tree.files:
        name = path.rpartition("/")[2]
        licensed = path.endswith(LICENSED) or name in LICENSED_NAMES
        text = tree.text(path) if licensed or path.startswith(DATA) or path.endswith(TEXT) else None
        if text is None:
            continue
        checked += 1
        check_words(report, path, text)
        if path.startswith(DATA):
            continue
        if licensed:
            check_licence(report, path, text)
        # Packages that tests and examples build are worlds of their own: two may use one guard.
        if path.endswith(HEADERS) and not path.startswith(("tests/build/", "examples/")):
            check_guard(report, path, text, guards)
        if not path.endswith(".md"):
            check_ends(report, path, text)
    return report.finish("check_headers", checked)


if __name__ == "__main__":
    sys.exit(main())
