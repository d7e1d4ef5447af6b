#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
import unittest

from planted_tree import check_none, check_one

SCRIPT = "check_words.py"


class CheckWords(unittest.TestCase):
    def test_plain_sentences_and_questions_are_fine(self):
        check_none(self, SCRIPT, {
            "docs/a.md": "A thread that reads waits. The error is reported.\n\nWho may include whom?\n\n## Who may include whom\n",
            "deployer/explain/DEP001.txt": "a number out of range\n\nIt cannot be read.\n",
        })

    def test_only_prose_is_read(self):
        check_none(self, SCRIPT, {"tests/unit/a.cpp": "// Who reads is told.\n", "examples/t01/expected_output.txt": "is told\n"})
        check_none(self, SCRIPT, {"runtime/xml/a.cpp": "int Who; // the number 10'000, that's it\nbool is_told = '\"';\n"})

    def test_comments_are_read(self):
        check_one(self, SCRIPT, {"runtime/xml/a.cpp": "int a;\n/// One.\n/// Whoever reads, waits.\n"},
                  "runtime/xml/a.cpp:3: error: [WRD01]")
        check_one(self, SCRIPT, {"deployer/a.hpp": "/**\n * The error is\n * told at once.\n */\n"},
                  "deployer/a.hpp:3: error: [WRD02]")
        check_one(self, SCRIPT, {"runtime/rtt/os/a.cpp": "int b;  // a number\n        // that is none\n"},
                  "runtime/rtt/os/a.cpp:2: error: [WRD03]")

    def test_literals_are_read(self):
        check_one(self, SCRIPT, {"deployer/a.cpp": 'f("it // can "\n  "not");\n'}, "deployer/a.cpp:2: error: [WRD04]")

    def test_long_lines(self):
        check_none(self, SCRIPT, {"deployer/a.cpp": "// " + "ä" * 117 + "\n"})
        check_one(self, SCRIPT, {"deployer/a.cpp": "\n// " + "a" * 118 + "\n"}, "deployer/a.cpp:2: error: [WRD05]")

    def test_texts_of_arguments(self):
        check_none(self, SCRIPT, {"deployer/a.cpp": 'x.doc("Opens it.").arg("force", "in newton");\n'})
        check_one(self, SCRIPT, {"deployer/a.cpp": 'x.doc("Opens it.").arg("force", "in "\n "newton.");\n'},
                  "deployer/a.cpp:2: error: [WRD06]")

    def test_descriptions(self):
        check_none(self, SCRIPT, {"deployer/a.cpp": """
            doc("Moves it.");  // as in x.doc("moves it")
            x.doc("Is it there?").arg("force", "in newton");
            y.doc("The speed. [m/s]").doc("Timer " + number + " ends.").doc(text).doc("\\"Hello\\", in each cycle.");
            Property<int> p("p", "", 1);
            offer(self, "open", of(&Self::open), "Opens it.").arg("Name", "of the door");
            call("open", &Self::open);
        """, "generator/a.cpp": 'x.doc("moves it");\n'})
        check_one(self, SCRIPT, {"deployer/a.cpp": 'x.doc("Moves "\n "it");\n'}, "deployer/a.cpp:2: error: [WRD07]")
        check_one(self, SCRIPT, {"runtime/rtt/a.cpp": 'doc("moves it.");\n'}, "runtime/rtt/a.cpp:1: error: [WRD07]")
        check_one(self, SCRIPT, {"examples/t01/a.cpp": 'x.doc("of timer " + number);\n'},
                  "examples/t01/a.cpp:1: error: [WRD07]")
        check_one(self, SCRIPT, {"runtime/rtt/a.hpp": 'Property<int> p{\n"p", "How many; 0: all",\n0};\n'},
                  "runtime/rtt/a.hpp:2: error: [WRD07]")
        check_one(self, SCRIPT, {"deployer/a.cpp": 'offer(self, "open", of(&Self::open),\n"Opens it");\n'},
                  "deployer/a.cpp:2: error: [WRD07]")
        check_one(self, SCRIPT, {"runtime/rtt/a.cpp": 'Row r[] = {{"open", &Self::open, "Opens it"}};\n'},
                  "runtime/rtt/a.cpp:1: error: [WRD07]")

    def test_who_as_a_subject(self):
        check_one(self, SCRIPT, {"docs/a.md": "One line.\nIt waits. Whoever reads now, waits.\n"}, "docs/a.md:2: error: [WRD01]")

    def test_errors_are_reported(self):
        check_one(self, SCRIPT, {"README.md": "The error is told at once.\n"}, "README.md:1: error: [WRD02]")

    def test_blanks_that_are_none(self):
        check_one(self, SCRIPT, {"generator/explain/OM001.txt": "Blanks that are none.\n"},
                  "generator/explain/OM001.txt:1: error: [WRD03]")

    def test_cannot_is_one_word(self):
        check_one(self, SCRIPT, {"docs/design/a.md": "It can not.\n"}, "docs/design/a.md:1: error: [WRD04]")


if __name__ == "__main__":
    unittest.main()
