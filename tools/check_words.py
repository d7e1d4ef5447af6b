#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""Checks the words of pages, explanations, comments and messages, as docs/design/style.md has it.

WRD01  a sentence that begins with "Who …" and is not a question
WRD02  something "is told" instead of reported
WRD03  "that is none": a number that is none, blanks that are none
WRD04  "can not"
WRD05  a line of C++ that is longer than 120 columns
WRD06  the text of an argument of an operation that ends with a period
WRD07  the description of an operation, property, port or service that is no sentence: capital letter, period or "?"
"""
import re
import sys

from source_tree import Report, open_tree

EXPLANATIONS = ("deployer/explain/", "generator/explain/")
PAGES = ("docs/", "examples/")
# This page shows what not to write.
EXEMPT = ("docs/design/style.md",)
# Folders of C++ whose comments and literals are read. A folder is added when it has no finding.
SOURCES = ("deployer/", "generator/", "runtime/", "typekit_gen/collect/", "typekit_gen/diff/", "typekit_gen/plan/")
# Folders of components and services whose descriptions are read.
DESCRIBED = ("deployer/", "examples/", "runtime/")
CODE = (".cpp", ".hpp", ".h", ".inl")
MAX_COLUMNS = 120

RULES = (
    ("WRD01", re.compile(r"(?:^|[.:;*>|] +)(?:Who|Whoever)\s+[a-z][^.?]*?[.,;]", re.MULTILINE),
     "say what acts: \"A thread that …\", \"Code that …\""),
    ("WRD02", re.compile(r"\b(?:is|are)\s+told\b(?!<)"), "write \"is reported\", \"learns of\", \"gives a warning\""),
    ("WRD03", re.compile(r"\bthat\s+(?:is|are)\s+none\b"), "say what it is: \"a malformed number\""),
    ("WRD04", re.compile(r"\b[Cc]an\s+not\b"), "write \"cannot\""),
)

STRING = r'"(?:\\.|[^"\\\n])*"'
TOKEN = re.compile(
    r'(?P<raw>R"(?P<mark>\w*)\(.*?\)(?P=mark)")'
    rf'|(?P<literal>{STRING}(?:\s*{STRING})*)'
    r"|(?P<letter>(?<!\w)'(?:\\.|[^'\\\n])+')"
    r'|(?P<comment>//[^\n]*(?:\n[ \t]*//[^\n]*)*|/\*.*?\*/)', re.DOTALL)
# What begins or ends a line of a comment, and what joins the parts of a literal; without the line ends.
LEADER = re.compile(r"^[ \t]*(?:/{2,3}<?|/\*{1,2}<?|\*(?!/))?[ \t]*|[ \t]*\*/", re.MULTILINE)
JOINT = re.compile(r'"[ \t]*(\n?)\s*"')
ARGUMENT = re.compile(rf'\.arg\(\s*{STRING}\s*,\s*(?:{STRING}\s*)*"(?:\\.|[^"\\\n])*\."\s*\)')
# Where descriptions are: in doc("…"), behind the name in Property<T>("name", "…"), and behind name and function in rows
# of a table or a helper: "name", &Class::function, "…". One that begins or ends with an expression is read in part.
DESCRIPTION = re.compile(
    rf"(?:\bdoc\(|\bProperty<[^;\"]*>\s*\w*\s*[({{]\s*{STRING}\s*,|{STRING}\s*,[^;\"]*&\w+::\w+\)*\s*,)"
    rf"\s*(?P<text>{STRING}(?:\s*{STRING})*)(?=\s*(?P<next>.))", re.DOTALL)
# A quotation may begin it. A unit may follow it, which the console shows behind the value.
BEGIN = re.compile(r'(?:\\")?[A-Z]')
END = re.compile(r"[.?](?: \[[^\]]+\])?$")


def is_prose(path):
    is_page = path.endswith(".md") and path not in EXEMPT and (path.startswith(PAGES) or "/" not in path)
    return is_page or path.startswith(EXPLANATIONS)


def prose_of(text):
    """(line, text) of each comment, several lines of `//` being one, and of each literal."""
    for match in TOKEN.finditer(text):
        line = text.count("\n", 0, match.start()) + 1
        if match["comment"]:
            yield line, LEADER.sub("", match["comment"])
        elif match["literal"]:
            yield line, JOINT.sub(r"\1", match["literal"])[1:-1]


def check_prose(report, path, first, text):
    for code, pattern, advice in RULES:
        for match in pattern.finditer(text):
            found = " ".join(match.group().strip(" .:;*>|\n").split())
            report.error(path, first + text.count("\n", 0, match.end()), code, f"found '{found}'; {advice}")


def check_source(report, path, text):
    for line, prose in prose_of(text):
        check_prose(report, path, line, prose)
    for number, line in enumerate(text.splitlines(), 1):
        if len(line) > MAX_COLUMNS:
            report.error(path, number, "WRD05", f"{len(line)} columns, expected at most {MAX_COLUMNS}")
    for match in ARGUMENT.finditer(text):
        report.error(path, text.count("\n", 0, match.end()) + 1, "WRD06",
                     "the text of an argument ends with a period; leave it out")


def without_comments(text):
    """The same with blank comments; lines stay where they are."""
    return TOKEN.sub(lambda m: re.sub(r"[^\n]", " ", m.group()) if m["comment"] else m.group(), text)


def check_descriptions(report, path, text):
    text = without_comments(text)
    for match in DESCRIPTION.finditer(text):
        description = JOINT.sub("", match["text"])[1:-1]
        if description and not (BEGIN.match(description) and (match["next"] == "+" or END.search(description))):
            report.error(path, text.count("\n", 0, match.end("text")) + 1, "WRD07",
                         f"the description '{description}' is no sentence; begin with a capital letter, end with a period")


def main():
    tree = open_tree(__doc__.splitlines()[0])
    report = Report()
    checked = 0
    for path in tree.files:
        is_source = path.startswith(SOURCES) and path.endswith(CODE)
        is_described = path.startswith(DESCRIBED) and path.endswith(CODE)
        if not is_source and not is_described and not is_prose(path):
            continue
        checked += 1
        text = tree.text(path) or ""
        if is_described:
            check_descriptions(report, path, text)
        if is_source:
            check_source(report, path, text)
        elif is_prose(path):
            check_prose(report, path, 1, text)
    return report.finish("check_words", checked)


if __name__ == "__main__":
    sys.exit(main())
