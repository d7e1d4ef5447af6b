#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
import unittest

from planted_tree import LICENCE, check, check_none, check_one, header

SCRIPT = "check_headers.py"


class CheckHeaders(unittest.TestCase):
    def test_correct_files_are_fine(self):
        check_none(self, SCRIPT, {
            "runtime/rtt/a.hpp": header("A_HPP"),
            "runtime/rtt/b.hpp": LICENCE + "#pragma once\n",
            "tools/run": "#!/usr/bin/env bash\n# SPDX-License-Identifier: Apache-2.0\n# Copyright Oroforge contributors\n",
            "tests/golden/model/x/input.hpp": "struct NoLicenceHere {};",
        })

    def test_build_folders_are_skipped_at_the_top_only(self):
        check_none(self, SCRIPT, {"build/a.cpp": "int a;\n", "tests/build/packages/p/a.cpp": "int a;\n"})
        status, found = check(SCRIPT, {"tests/build/a.cpp": "int a;\n"})
        self.assertEqual(status, 1)
        self.assertTrue(found[0].startswith("tests/build/a.cpp:1: error: [HDR01]"), found)

    def test_licence_is_missing(self):
        status, found = check(SCRIPT, {"runtime/rtt/a.cpp": "int a;\n"})
        self.assertEqual(status, 1)
        self.assertEqual(len(found), 2, found)
        self.assertTrue(all(line.startswith("runtime/rtt/a.cpp:1: error: [HDR01]") for line in found), found)

    def test_include_guard_is_missing(self):
        check_one(self, SCRIPT, {"runtime/rtt/a.hpp": LICENCE + "int a;\n"}, "runtime/rtt/a.hpp:1: error: [HDR02]")

    def test_same_include_guard_twice(self):
        check_one(self, SCRIPT, {"runtime/rtt/a.hpp": header("A_HPP"), "runtime/rtt/b.hpp": header("A_HPP")},
                  "runtime/rtt/b.hpp:3: error: [HDR03]")

    def test_path_of_one_machine(self):
        check_one(self, SCRIPT, {"docs/a.md": "run /" + "home/joe/dev\n"}, "docs/a.md:1: error: [HDR04]")

    def test_path_below_a_variable_is_fine(self):
        check_none(self, SCRIPT, {"docs/a.md": "see $PREFIX/" + "home/x and ../" + "work/shared\n"})

    def test_unfinished_word(self):
        check_one(self, SCRIPT, {"runtime/rtt/a.cpp": LICENCE + "int a; // TO" + "DO\n"},
                  "runtime/rtt/a.cpp:3: error: [HDR05]")

    def test_blank_at_the_end_of_a_line(self):
        check_one(self, SCRIPT, {"runtime/rtt/a.cpp": LICENCE + "int a; \n"}, "runtime/rtt/a.cpp:3: error: [HDR06]")


if __name__ == "__main__":
    unittest.main()
