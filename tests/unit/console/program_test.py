# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""The deployer without a terminal: commands from standard input."""
import os
import signal
import subprocess

from deployer_case import DEPLOYER, DeployerCase, main


class WithoutTerminal(DeployerCase):
    def test_answers_and_nothing_else_are_written(self):
        out, err = self.run_with("1 + 1\nvar double x = 2.5\nx * 2.0\n")
        self.assertEqual(" = 2\n = 2.5\n = 5\n", out)
        self.assertEqual("", err)

    def test_a_statement_that_only_waits_fails(self):
        _, err = self.run_with("while true yield\n", status=255)
        self.assertIn("stdin:1:", err)
        self.assertIn("[OPS410]", err)

    def test_ends_at_the_end_of_its_input(self):
        self.assertEqual(("", ""), self.run_with(""))

    def test_quit_ends_it_before(self):
        self.assertEqual((" = 1\n", ""), self.run_with("1\nquit\n2\n"))

    def test_the_last_line_needs_no_end(self):
        self.assertEqual(" = 3\n", self.run_with("1 + 2")[0])

    def test_errors_have_the_line_of_the_input_and_do_not_end_it(self):
        out, err = self.run_with("1\n\nls nowhere\nimpotr(\"filling\")\n4\n", status=255)
        self.assertEqual(" = 1\n = 4\n", out)
        self.assertIn("stdin:3:4: error: there is no peer or service 'nowhere'\nls nowhere\n   ^\n", err)
        self.assertIn("stdin:4:1: error: [OPS134] component 'Deployer' has no operation 'impotr'; "
                      "did you mean 'import'?\nimpotr(\"filling\")\n^\n", err)

    def test_a_piece_without_its_end_is_told(self):
        _, err = self.run_with("1\nif true then {\n", status=255)
        self.assertRegex(err, r"stdin:\d+:\d+: error: ")

    def test_the_status_tells_of_lines_that_failed(self):
        for line in ("ls nowhere", "nothere()", "1 / 0", ".frob", ".provide nothing", "1 +", ".unloadProgram none",
                     'Deployer.setPeriod("x")'):
            self.assertEqual(" = 2\n", self.run_with(line + "\n1 + 1\nquit\n", status=255)[0], line)

    def test_what_gives_false_has_not_failed(self):
        self.assertEqual(" = false\n", self.run_with("stop()\n")[0])

    def test_components_are_loaded_and_commanded(self):
        out, err = self.run_with('import("filling");\nloadComponent("tank", "filling::Tank");\ntank.capacity = 2.0\n'
                                 "tank.configure()\ntank.start()\ntank.fill(1.5)\nls tank\n")
        self.assertEqual("", err)
        self.assertIn(" = 2\n = true\n = true\n = true\nComponent tank [R]\n", out)
        self.assertIn("    out  level  double  = 1.5  not connected  What is in it. [m3]\n", out)

    def test_no_history_is_written(self):
        self.run_with("1 + 1\n")
        self.assertFalse((self.directory / ".tb_history").exists())

    def test_after_a_file_that_fails_no_commands_are_read(self):
        (self.directory / "bad.ops").write_text("nothere()\n")
        out, _ = self.run_with("1 + 1\n", "-s", "bad.ops", status=255)
        self.assertEqual("", out)

    def test_files_come_before_commands(self):
        (self.directory / "app.ops").write_text('import("filling")\nloadComponent("tank", "filling::Tank")\n')
        self.assertEqual("tank  [U]\n", self.run_with("peers\n", "-s", "app.ops")[0])

    def lasting(self):
        own = {**os.environ, **self.environment}
        return subprocess.Popen([DEPLOYER], cwd=self.directory, env=own, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, text=True)

    def test_a_signal_ends_it_while_it_waits_for_input(self):
        for number in signal.SIGTERM, signal.SIGINT, signal.SIGHUP:
            with self.lasting() as program:
                program.stdin.write("1 + 1\n")
                program.stdin.flush()
                self.assertEqual(" = 2\n", program.stdout.readline())
                program.send_signal(number)
                self.assertEqual(0, program.wait(20))

    def test_a_signal_during_a_command_stops_it_and_ends_the_rest(self):
        for number in signal.SIGTERM, signal.SIGINT, signal.SIGHUP:
            with self.lasting() as program:
                program.stdin.write('import("talking"); loadComponent("talker", "Talker")\n'
                                    "talker.begin(); while true { yield }\n2 + 2\nif true then {\n")
                program.stdin.flush()
                self.assertEqual([" = true\n", "begun\n"], [program.stdout.readline() for _ in range(2)])
                program.send_signal(number)
                self.assertEqual(0, program.wait(20))
                self.assertEqual("", program.stdout.read())
                self.assertRegex(program.stderr.read(), r"\Astdin:2:\d+: error: interrupted\n"
                                 r"talker.begin\(\); while true { yield }\n +\^\n\Z")


if __name__ == "__main__":
    main()
