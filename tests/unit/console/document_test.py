# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""Types what the listings "console" of docs/console.md show as typed, and compares the screens.

All listings are one session. A line "…" stands for any lines; "⇥" is the TAB key, and "^C" below a line is Ctrl-C. With UPDATE_GOLDENS=1 the page is written anew.
"""
import os
import pathlib
import re

from deployer_case import SOURCES, DeployerCase, main

PAGE = pathlib.Path(SOURCES) / "docs" / "console.md"
PROMPT = re.compile(r"^(?:(?:Watching )?\w+ \[[A-Z]\])?> ?")
LISTING = re.compile(r"^```console\n(.*?)^```$", re.M | re.S)


def steps(listing):
    """(prompt, what is typed, what is shown)"""
    found = []
    for line in listing.splitlines():
        prompt = PROMPT.match(line)
        if prompt:
            found.append((prompt.group(), line[prompt.end():], []))
        else:
            found[-1][2].append(line)
    return found


def matches(expected, actual):
    if not expected:
        return not actual
    if expected[0] == "…":
        return any(matches(expected[1:], actual[i:]) for i in range(len(actual) + 1))
    return bool(actual) and expected[0].rstrip() == actual[0] and matches(expected[1:], actual[1:])


class Page(DeployerCase):
    def lines_after(self, program, first):
        """Waits until the screen has more than `first` lines and ends with a prompt."""
        def ready():
            lines = program.screen().split("\n")
            found = PROMPT.match(lines[-1] + " ")
            return len(lines) > first and found and found.end() >= len(lines[-1])
        program.wait(ready, "the next prompt")
        return program.screen().split("\n")[first:-1]

    def complete(self, program, typed, first):
        """The words that TAB offers; none if it completes the word."""
        before = program.screen().split("\n")[-1] + " " + typed
        program.send(typed + "\t")
        program.wait(lambda: len(program.screen().split("\n")) > first or program.screen().split("\n")[-1] > before,
                     "what TAB does")
        program.wait(lambda: program.screen().split("\n")[-1].startswith(before), "the line")
        lines = program.screen().split("\n")
        shown = lines[first:-1] or [lines[-1]]
        now = len(lines)
        program.send("\x03")
        self.lines_after(program, now)
        return shown

    def test_screens_are_those_of_the_program(self):
        program = self.open(TERM="xterm")
        program.resize(110)

        def play(listing):
            text = ""
            for prompt, typed, expected in steps(listing.group(1)):
                screen = program.screen().split("\n")
                self.assertEqual(prompt.rstrip(), screen[-1])
                if typed.endswith("⇥"):
                    shown = self.complete(program, typed[:-1], len(screen))
                else:
                    program.send(typed + "\r")
                    if expected[:1] == ["^C"]:
                        program.wait_for_execution()
                        program.send("\x03")
                    shown = self.lines_after(program, len(screen))
                if not os.environ.get("UPDATE_GOLDENS"):
                    self.assertTrue(matches(expected, shown), f"after {typed!r}, expected:\n" + "\n".join(expected) +
                                    "\nshown:\n" + "\n".join(shown))
                kept = expected if "…" in expected and matches(expected, shown) else shown
                text += "".join(line + "\n" for line in [prompt + typed, *kept])
            return "```console\n" + text + "```"

        page = PAGE.read_text()
        self.assertTrue(LISTING.search(page))
        played = LISTING.sub(play, page)
        if os.environ.get("UPDATE_GOLDENS"):
            PAGE.write_text(played)


if __name__ == "__main__":
    main()
