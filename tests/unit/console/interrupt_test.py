# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""Ctrl-C, and signals that end the console, while a command is executed."""
import os
import signal
import time

from deployer_case import PROMPT, DeployerCase, main

CTRL_C = "\x03"
LOAD = 'import("talking"); loadComponent("talker", "Talker"); talker.start()'


class Case(DeployerCase):
    def talking(self):
        program = self.open()
        program.resize(140)
        program.type(LOAD, PROMPT)
        return program

    def begin(self, program, line):
        """Types it; it has begun when this returns, or is about to unless it says so itself. The number of rows up to then."""
        rows = program.screen().count("\n") + 2
        program.send(line + "\r" if '"wait' in line else f"talker.begin(); {line}\r")
        program.wait(lambda: program.screen().count("\n") >= rows and program.screen().endswith("begun\n"), "the begin")
        return rows

    def stop(self, program, line):
        """What is shown from Ctrl-C to the next prompt."""
        rows = self.begin(program, line)
        program.send(CTRL_C)
        program.wait(lambda: program.screen().count("\n") > rows and program.screen().endswith("\n" + PROMPT.rstrip()),
                     "the prompt")
        return "\n".join(program.screen().split("\n")[rows:-1])

    def assert_stopped(self, program, line, message="interrupted"):
        shown = self.stop(program, line)
        self.assertRegex(shown, r"\A\^C\nconsole:\d+:\d+: error: " + message + r"\n.*\n *\^\Z")
        self.assertEqual(" = 2", program.type("1 + 1", PROMPT))


class Interrupts(Case):
    def test_stop_loops(self):
        program = self.talking()
        program.type("var int n = 0; var bool never = false", PROMPT)
        for line in ("while true { yield }", "while true { }", "while !never yield", "while true { n = n + 1 }",
                     "for (n = 0; n >= 0; n = 0) { }", "while true { while n < 1000 { n = n + 1 }; n = 0 }",
                     "while !never { never = talker.inException() }"):
            with self.subTest(line):
                self.assert_stopped(program, line)

    def test_are_told_where_the_statement_is(self):
        program = self.talking()
        program.type("while true {", "> ")
        program.send("  talker.begin(); while true { }\r")
        program.wait_for_prompt("> ")
        program.send("}\r")
        program.wait_for("> }\nbegun\n")
        program.send(CTRL_C)
        program.wait_for("^C\nconsole:3:25: error: interrupted\n  talker.begin(); while true { }\n" + 24 * " " + "^\n" +
                         PROMPT.rstrip())

    def test_let_a_statement_wait_as_long_as_it_likes(self):
        program = self.open()
        program.type("var int n = 0; while n < 10100 { n = n + 1; yield }", PROMPT)
        self.assertEqual(" = 10100", program.type("n", PROMPT))

    def test_stop_waiting_for_an_operation(self):
        program = self.talking()
        self.assert_stopped(program, 'talker.talk("wait", "hello")',
                            "interrupted while waiting for operation 'talk', which goes on in its component")
        (self.directory / "go").touch()
        program.wait(lambda: not (self.directory / "go").exists(), "the component")

    def test_stop_waiting_for_what_was_sent(self):
        program = self.talking()
        program.type("var SendHandle h", PROMPT)
        self.assert_stopped(program, 'h = talker.talk.send("wait", ""); h.collect()',
                            "interrupted( while waiting for operation 'talk', which goes on in its component)?")
        (self.directory / "go").touch()
        self.assertEqual(" = SendSuccess", program.type("h.collect()", PROMPT))

    def test_stop_waiting_for_the_function_of_a_component(self):
        program = self.talking()
        program.type("cd talker", "talker [R]> ")
        program.type("var bool over = false", "talker [R]> ")
        program.type("export void forever() { while !over yield }", "talker [R]> ")
        program.type("cd ..", PROMPT)
        program.send("talker.forever()\r")
        program.wait_for("next is line 4)\n")  # a warning that it yields
        program.send(CTRL_C)
        program.wait_for("^C\nconsole:6:1: error: interrupted while waiting for function 'forever' of component 'talker', "
                         "which goes on\ntalker.forever()\n^\n" + PROMPT.rstrip())
        program.type("talker.over = true", PROMPT)

    def test_are_not_caught(self):
        program = self.talking()
        program.type("var int caught = 0", PROMPT)
        self.assert_stopped(program, 'try talker.talk("wait", "") catch { caught = 1 }',
                            "interrupted while waiting for operation 'talk', .*")
        self.assertEqual(" = 0", program.type("caught", PROMPT))
        (self.directory / "go").touch()

    def test_stop_a_script_that_is_run_and_what_follows(self):
        (self.directory / "wait.ops").write_text("1 + 1\ntalker.begin()\nwhile true {\n    yield\n}\n")
        program = self.talking()
        program.type("var int n = 0", PROMPT)
        shown = self.stop(program, 'runScript("wait.ops"); n = 1')
        self.assertRegex(shown, r"wait\.ops:[345]:\d+: error: interrupted\n")
        self.assertRegex(shown, r"console:\d+:\d+: error: interrupted\n")
        self.assertEqual(" = 0", program.type("n", PROMPT))

    def test_forget_what_was_pasted_after_it(self):
        program = self.talking()
        rows = program.screen().count("\n")
        program.send("\x1b[200~talker.begin(); while true { }\r2 + 2\r3 + 3\x1b[201~")
        program.wait_for("begun\n")
        program.send(CTRL_C)
        program.wait(lambda: program.screen().count("\n") > rows + 2 and
                     program.screen().endswith("\n" + PROMPT.rstrip()), "the prompt")
        self.assertEqual(" = 2", program.type("1 + 1", PROMPT))
        self.assertNotIn("2 + 2", program.screen())

    def test_that_come_too_often_do_not_end_the_process(self):
        program = self.talking()
        for _ in range(5):
            self.begin(program, "while true { }")
            for _ in range(20):
                program.send(CTRL_C)
            # Each of them makes the terminal forget what it has not shown yet.
            program.wait(lambda: program.screen().endswith(PROMPT.rstrip()), "the prompt")
            # The last ones may come after the prompt, and would interrupt the next statement.
            seen = None
            while seen != program.screen():
                seen = program.screen()
                time.sleep(0.5)
        program.send("1 + 1\r")  # some of them may be keys of the prompts meanwhile
        program.wait_for("\n = 2\n" + PROMPT.rstrip())

    def test_during_cpp_code_are_told_and_end_after_it(self):
        program = self.talking()
        program.type("var int n = 0", PROMPT)
        program.send("talker.block(); n = 1\r")
        program.wait_for("begun\n")
        program.send(CTRL_C)
        program.wait_for("^C\n")  # which the second one could make the terminal forget
        program.send(CTRL_C)
        program.wait_for("^C\nthis command executes C++ code, which cannot be stopped; another Ctrl-C ends the process "
                         "at once\n")
        (self.directory / "go").touch()
        program.wait_for_prompt(PROMPT)
        self.assertRegex(program.screen(), r"console:\d+:\d+: error: interrupted\n")
        self.assertEqual(" = 0", program.type("n", PROMPT))
        self.assert_stopped(program, "while true { }")

    def test_during_cpp_code_end_the_process_the_second_time(self):
        program = self.talking()
        program.send("talker.block()\r")
        program.wait_for("begun\n")
        program.send(CTRL_C)
        program.wait_for("another Ctrl-C ends the process at once\n")
        program.send(CTRL_C)
        self.assertEqual(-signal.SIGINT, program.end())


class Signals(Case):
    def test_stop_the_command_and_end_the_console(self):
        for number in signal.SIGTERM, signal.SIGHUP:
            program = self.talking()
            self.begin(program, "while true { }")
            os.kill(program.pid, number)
            self.assertEqual(0, program.end())
            self.assertRegex(program.screen(), r"console:\d+:\d+: error: interrupted\n")

    def test_during_cpp_code_are_told_and_end_the_console_after_it(self):
        program = self.talking()
        program.send("talker.block()\r")
        program.wait_for("begun\n")
        os.kill(program.pid, signal.SIGTERM)
        program.wait_for("the console is left once it is done, and Ctrl-C ends the process at once\n")
        (self.directory / "go").touch()
        self.assertEqual(0, program.end())

    def test_for_interruption_are_as_ctrl_c_during_a_command(self):
        program = self.talking()
        self.begin(program, "while true { }")
        os.kill(program.pid, signal.SIGINT)
        program.wait_for_prompt(PROMPT)
        os.kill(program.pid, signal.SIGINT)
        self.assertEqual(0, program.end())


if __name__ == "__main__":
    main()
