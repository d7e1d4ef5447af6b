#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""Does what a page of the user guide says: run_guide.py PREFIX PAGE, with a toolchain installed in PREFIX.

Comments of the page, which its readers do not see, tell what the next listing is:
    <!-- file NAME -->          a file of this name
    <!-- run -->                commands; <!-- run: 255 --> with this exit status. What they export stays
    <!-- typed OPTION… -->      a session at the prompt of the deployer, started with these options
    <!-- typed: COMMAND… -->    the same of another program
    <!-- output -->             what the last commands wrote. "…" is any text, a line of it any number of lines
    <!-- shown REASON -->       only to be looked at
A comment may have more lines. Those of a file are what stands around the listing, a part of it, in place of a line "…";
and readers need not see everything that is tried:
    <!-- file CMakeLists.txt
    project(arm)
    …
    -->
    <!-- try
    cmake .
    -->
Every listing has such a comment: one that nobody tries goes wrong one day. Those of ELSEWHERE are tried by another test.
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

TOKEN = re.compile(r"^<!-- (?P<what>.*?)\s*-->$|^```(?P<language>\w*)\n(?P<text>.*?)^```$|^(?P<indented> {4}\S.*?)$",
                   re.M | re.S)
PROMPT = re.compile(r"^(?:\w+ \[[A-Z]\])?> ?")
ELSEWHERE = {("console.md", "console"): "tests/unit/console/document_test.py"}
SOURCES = pathlib.Path(__file__).resolve().parent.parent.parent


def same(expected, actual):
    return re.fullmatch(".*".join(map(re.escape, expected.rstrip().split("…"))), actual.rstrip())


def matches(expected, actual):
    """Whether the lines are there in this order, without others in between but where "…" stands."""
    if not expected:
        return not actual
    if expected[0] == "…":
        return any(matches(expected[1:], actual[i:]) for i in range(len(actual) + 1))
    return bool(actual) and bool(same(expected[0], actual[0])) and matches(expected[1:], actual[1:])


class Guide:
    def __init__(self, prefix, page, folder):
        self.page, self.folder = page, folder
        self.output = ""
        self.failed = False
        own = {"PATH": f"{prefix}/bin:{os.environ['PATH']}", "OROCOS_TARGET": "gnulinux", "CMAKE_PREFIX_PATH": prefix,
               "PKG_CONFIG_PATH": f"{prefix}/lib/pkgconfig", "RTT_COMPONENT_PATH": f"{prefix}/lib/orocos",
               "HOME": str(folder), "LC_ALL": "C.UTF-8"}
        dropped = ("LD_LIBRARY_PATH", "ORO_LOGLEVEL", "ORO_LOGFILE", "CXXFLAGS", "CMAKE_GENERATOR", "MAKEFLAGS")
        self.environment = {k: v for k, v in os.environ.items() if k not in dropped} | own

    def fail(self, line, text):
        self.failed = True
        print(f"{self.page}:{line}: {text}", flush=True)

    def run(self, line, commands, status, typed=""):
        exported = self.folder / ".exported"
        shell = ["timeout", "--kill-after=5", "200", "bash", "-euo", "pipefail", "-c"]
        process = subprocess.run([*shell, f"trap 'env -0 > {exported}' EXIT\n{commands}"], cwd=self.folder,
                                 env=self.environment, input=typed, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                 text=True, check=False)
        if exported.exists():
            self.environment = dict(entry.split("=", 1) for entry in exported.read_text().split("\0")[:-1])
        self.output = process.stdout
        if process.returncode != status:
            self.fail(line, f"exit status {process.returncode}, expected {status}:\n{commands}\n{self.output}")

    def compare(self, line, expected):
        if not matches(expected, self.output.splitlines()):
            self.fail(line, f"the output is another:\n{self.output}")

    def write(self, name, text):
        target = self.folder / name
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text)

    def type(self, line, command, session):
        lines = session.splitlines()
        typed = [entry[PROMPT.match(entry).end():] for entry in lines if PROMPT.match(entry)]
        self.run(line, command, 0, "".join(f"{entry}\n" for entry in typed))
        self.compare(line, [entry for entry in lines if not PROMPT.match(entry)])

    def take(self, line, what, language, text):
        head, _, frame = what.partition("\n")
        word, _, rest = head.partition(" ")
        if frame:
            before, found, after = f"\n{frame}\n".partition("\n…\n")
            if not found or word != "file":
                self.fail(line, f"only a file has something around it, with a line … for the listing: {head}")
            text = before[1:] + "\n" * bool(before[1:]) + text + after
        if word == "file" and rest:
            self.write(rest, text)
        elif word in ("run", "run:"):
            self.run(line, text, int(rest or 0))
        elif word == "typed":
            self.type(line, f"deployer {rest}", text)
        elif word == "typed:" and rest:
            self.type(line, rest, text)
        elif word == "output":
            self.compare(line, text.splitlines())
        elif what and not (word in ("shown", "shown:") and rest):
            self.fail(line, f"not understood: <!-- {head} -->")
        elif not what and (pathlib.Path(self.page).name, language) not in ELSEWHERE:
            self.fail(line, f"a listing of {language or 'no language'} that nobody tries")

    def read(self, text):
        what, end = "", 0
        for token in TOKEN.finditer(text):
            line = text.count("\n", 0, token.start()) + 1
            if what and (token["text"] is None or text[end:token.start()].strip()):
                self.fail(line, f"no listing after <!-- {what} -->")
                what = ""
            end = token.end()
            if token["indented"]:
                self.fail(line, "an indented listing, which nobody tries; put it between ```")
            elif token["what"] and token["what"].startswith("try\n"):
                self.run(line, token["what"][4:], 0)
            elif token["what"]:
                what = token["what"]
            else:
                self.take(line, what, token["language"], token["text"])
                what = ""
        if what:
            self.fail(line, f"no listing after <!-- {what} -->")


def main():
    prefix, page = sys.argv[1:3]
    with tempfile.TemporaryDirectory() as folder:
        guide = Guide(os.path.abspath(prefix), page, pathlib.Path(folder))
        if (SOURCES / "examples").exists():
            (guide.folder / "examples").symlink_to(SOURCES / "examples")
        guide.read(pathlib.Path(page).read_text())
    sys.exit(1 if guide.failed else 0)


if __name__ == "__main__":
    main()
