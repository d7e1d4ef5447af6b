#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""Checks the words of what users read, as docs/design/style.md has it.

WRD01  a sentence that begins with "Who …" and is no question
WRD02  something "is told" instead of reported
WRD03  "that is none": a number that is none, blanks that are none
WRD04  "can not"
"""
import re
import sys

from source_tree import Report, open_tree

EXPLANATIONS = ("deployer/explain/", "generator/explain/")
PAGES = ("docs/", "examples/")
# This page shows what not to write.
EXEMPT = ("docs/design/style.md",)

RULES = (
    ("WRD01", re.compile(r"(?:^|[.:;*>|] +)(?:Who|Whoever) [a-z][^.?]*?[.,;]", re.MULTILINE),
     "say what acts: \"A thread that …\", \"Code that …\""),
    ("WRD02", re.compile(r"\b(?:is|are) told\b(?!<)"), "write \"is reported\", \"learns of\", \"gives a warning\""),
    ("WRD03", re.compile(r"\bthat (?:is|are) none\b"), "say what it is: \"a malformed number\""),
    ("WRD04", re.compile(r"\b[Cc]an not\b"), "write \"cannot\""),
)


def is_prose(path):
    is_page = path.endswith(".md") and path not in EXEMPT and (path.startswith(PAGES) or "/" not in path)
    return is_page or path.startswith(EXPLANATIONS)


def main():
    tree = open_tree(__doc__.splitlines()[0])
    report = Report()
    checked = 0
    for path in filter(is_prose, tree.files):
        checked += 1
        text = tree.text(path) or ""
        for code, pattern, advice in RULES:
            for match in pattern.finditer(text):
                found = match.group().strip(" .:;*>|\n")
                report.error(path, text.count("\n", 0, match.end()) + 1, code, f"found '{found}'; {advice}")
    return report.finish("check_words", checked)


if __name__ == "__main__":
    sys.exit(main())
