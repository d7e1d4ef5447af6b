# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""The program helloworld on a terminal and with commands from its standard input: helloworld_test.py HELLOWORLD"""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "console"))
import terminal  # noqa: E402

HELLOWORLD = sys.argv[1]


class HelloWorld(unittest.TestCase):
    maxDiff = None

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.directory = folder.name
        self.environment = {"ORO_LOGFILE": "/dev/null", "ORO_LOGLEVEL": "4", "NO_COLOR": "1", "HOME": folder.name}

    def run_with(self, text, *arguments, status=0):
        done = subprocess.run([HELLOWORLD, *arguments], cwd=self.directory, env={**os.environ, **self.environment},
                              input=text, text=True, capture_output=True, timeout=20, check=False)
        self.assertEqual(status, done.returncode, done.stderr)
        return done.stdout, done.stderr

    def test_commands_come_from_standard_input(self):
        out, err = self.run_with('the_property\nthe_method()\nthe_constant\nconfigure()\nstart()\nisRunning()\n'
                                 'the_command("World")\nthe_command.send("you");\nquit\n1 + 1\n')
        self.assertEqual("", err)
        self.assertTrue(out.startswith(' = "Hello Property"\n = "Hello World"\n = "Hello Constant"\n'
                                       " = true\n = true\n = true\nSaying Hello 'World' in own thread.\n = true\n"), out)
        self.assertNotIn(" = 2\n", out)

    def test_the_status_tells_of_lines_that_failed(self):
        self.assertEqual(" = 2\n", self.run_with("nothere\n1 + 1\n", status=255)[0])

    def test_opens_a_console_on_the_component(self):
        with terminal.Program([HELLOWORLD], self.directory, self.environment) as program:
            program.wait_for_prompt("hello [U]> ")
            self.assertIn("the_results", program.type("ls", "hello [U]> "))
            self.assertEqual(' = "Hello World"', program.type("the_method()", "hello [U]> "))
            program.type("configure()", "hello [S]> ")
            program.type("start()", "hello [R]> ")
            program.type("flag = true;", "hello [R]> ")
            program.wait_for("Setting 'flag' back to false.")
            program.send("quit\r")
            self.assertEqual(0, program.end())

    def test_tells_what_it_is(self):
        out, err = self.run_with("", "--help")
        self.assertIn("Opens a console on the component 'hello'", out)
        self.assertEqual("", err)
        out, err = self.run_with("", "--loud", status=255)
        self.assertEqual("", out)
        self.assertIn("Usage:", err)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
