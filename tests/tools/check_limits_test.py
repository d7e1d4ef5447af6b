#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
import unittest

from planted_tree import check_none, check_one

SCRIPT = "check_limits.py"


class CheckLimits(unittest.TestCase):
    def test_file_at_the_limit_is_fine(self):
        check_none(self, SCRIPT, {"runtime/rtt/a.cpp": "\n" * 400, "templates/a.mustache": "\n" * 150})

    def test_long_file(self):
        check_one(self, SCRIPT, {"runtime/rtt/a.cpp": "\n" * 401}, "runtime/rtt/a.cpp:401: error: [LIM01] 401 lines")

    def test_long_template(self):
        check_one(self, SCRIPT, {"templates/a.hpp.mustache": "\n" * 151}, "templates/a.hpp.mustache:151: error: [LIM01]")

    def test_long_function(self):
        body = "    call();\n" * 79
        check_one(self, SCRIPT, {"generator/a.cpp": "namespace n {\n\nint f(int a) {\n" + body + "}\n}\n"},
                  "generator/a.cpp:3: error: [LIM02] function of 81 lines")

    def test_function_at_the_limit_is_fine(self):
        body = "    call();\n" * 78
        check_none(self, SCRIPT, {"generator/a.cpp": "int C::f(int a) const {\n" + body + "}\n"})

    def test_braces_end_a_function_wherever_they_stand(self):
        body = "    call('{', \"{\");  // {\n" * 70
        check_none(self, SCRIPT, {"generator/a.cpp": "C::C(int a)\n    : B(a) {\n" + body + "}\n"
                                                     + "int f() {\n    if (!g([&] {\n            return 1;\n        }))\n"
                                                     + body + "}\n"})

    def test_long_class_template_is_no_function(self):
        check_none(self, SCRIPT, {"generator/a.hpp": "template <class R, class... A> class C<R(A...)> : public B {\n"
                                                     + "    int a();\n" * 90 + "};\n"})

    def test_long_class_is_no_function(self):
        check_none(self, SCRIPT, {"generator/a.hpp": "class __attribute__((x)) C {\n" + "    int a();\n" * 90 + "};\n"})


if __name__ == "__main__":
    unittest.main()
