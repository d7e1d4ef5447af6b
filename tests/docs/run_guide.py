#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""Does what a page of the user guide says: run_guide.py PREFIX PAGE, with a toolchain installed in PREFIX.

Comments of the page, which its readers do not see, tell what the next listing is:
    <!-- file NAME -->          a file of this name
    <!-- run -->                commands; <!-- run: 255 --> with this exit status
    <!-- output -->             what the last commands wrote. A line "…" stands for any number of lines
    <!-- shown -->              only to be looked at; each one needs a reason behind the word
All others of languages xml, sh and cpp are an error: a listing that nobody tries goes wrong one day.
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

LISTING = re.compile(r"(?:^<!-- (?P<what>[^\n]*?) -->\n+)?^```(?P<language>\w*)\n(?P<text>.*?)^```$", re.M | re.S)
TRIED = ("xml", "sh", "cpp", "ops", "cpf")


def matches(expected, actual):
    """Whether the lines are there in this order, without others in between but where "…" stands."""
    if not expected:
        return not actual
    if expected[0] == "…":
        return any(matches(expected[1:], actual[i:]) for i in range(len(actual) + 1))
    return bool(actual) and expected[0].rstrip() == actual[0].rstrip() and matches(expected[1:], actual[1:])


class Guide:
    def __init__(self, prefix, page, folder):
        self.page, self.folder = page, folder
        self.output = ""
        self.failures = []
        own = {"PATH": f"{prefix}/bin:{os.environ['PATH']}", "OROCOS_TARGET": "gnulinux", "CMAKE_PREFIX_PATH": prefix,
               "RTT_COMPONENT_PATH": f"{prefix}/lib/orocos", "HOME": str(folder)}
        dropped = ("LD_LIBRARY_PATH", "PKG_CONFIG_PATH", "ORO_LOGLEVEL", "ORO_LOGFILE")
        self.environment = {k: v for k, v in os.environ.items() if k not in dropped} | own

    def fail(self, line, text):
        self.failures.append(f"{self.page}:{line}: {text}")

    def run(self, line, commands, status):
        process = subprocess.run(["bash", "-euo", "pipefail", "-c", commands], cwd=self.folder, env=self.environment,
                                 stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                                 timeout=300, check=False)
        self.output = process.stdout
        if process.returncode != status:
            self.fail(line, f"exit status {process.returncode}, expected {status}:\n{commands}\n{self.output}")

    def take(self, line, what, language, text):
        word, _, rest = what.partition(" ")
        if word == "file":
            target = self.folder / rest
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_text(text)
        elif word in ("run", "run:"):
            self.run(line, text, int(rest or 0))
        elif word == "output":
            if not matches(text.splitlines(), self.output.splitlines()):
                self.fail(line, f"the output is another:\n{self.output}")
        elif word == "shown" and rest:
            pass
        elif language in TRIED:
            self.fail(line, f"a listing of {language} that nobody tries")


def main():
    prefix, page = sys.argv[1:3]
    text = pathlib.Path(page).read_text()
    with tempfile.TemporaryDirectory() as folder:
        guide = Guide(os.path.abspath(prefix), page, pathlib.Path(folder))
        for listing in LISTING.finditer(text):
            line = text.count("\n", 0, listing.start("text"))
            guide.take(line, listing["what"] or "", listing["language"], listing["text"])
    for failure in guide.failures:
        print(failure)
    sys.exit(1 if guide.failures else 0)


if __name__ == "__main__":
    main()
