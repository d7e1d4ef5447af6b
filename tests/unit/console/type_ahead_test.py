# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""Keys typed while a command is executed, and the terminal as it is left in every way out."""
import os
import signal
import sys
import termios

import terminal
from deployer_case import DEPLOYER, PROMPT, DeployerCase, main

CTRL_C, CTRL_Z = "\x03", "\x1a"

# Nothing stops by Ctrl-Z where nobody could wake it: a shell with one job, which it wakes. What it sees goes to a file,
# because the prompt would write over it.
SHELL = """
import ctypes, os, signal, sys, termios, time

def tell(what):
    with open("seen", "a") as file:
        file.write(what + "\\n")

def echo():
    return termios.tcgetattr(0)[3] & termios.ECHO

signal.signal(signal.SIGTTOU, signal.SIG_IGN)
job = os.fork()
if job == 0:
    os.setpgid(0, 0)
    os.tcsetpgrp(0, os.getpid())
    signal.signal(signal.SIGTTOU, signal.SIG_DFL)
    ctypes.CDLL(None).prctl(1, signal.SIGKILL)  # PR_SET_PDEATHSIG: it does not outlive the shell
    os.execv(sys.argv[1], sys.argv[1:])
while os.WIFSTOPPED(status := os.waitpid(job, os.WUNTRACED)[1]):
    os.tcsetpgrp(0, os.getpid())
    tell("stopped with echo" if echo() else "stopped without echo")
    os.tcsetpgrp(0, job)
    os.kill(job, signal.SIGCONT)
    while echo():
        time.sleep(0.01)
    tell("resumed without echo")
sys.exit(os.waitstatus_to_exitcode(status))
"""


class DuringACommand(DeployerCase):
    """The talker is busy until there is a file 'go'."""

    def blocked(self):
        """By C++ code."""
        program = self.open()
        program.resize(140)
        program.type('import("talking"); loadComponent("talker", "Talker")', PROMPT)
        program.send("talker.block()\r")
        program.wait_for("begun\n")
        return program

    def busy(self, how="nothing", program=None):
        program = program or self.open()
        program.type('import("talking"); loadComponent("talker", "Talker"); talker.start()', PROMPT)
        program.send(f'talker.talk("{how}", "hello")\r')
        program.wait_for_execution()
        program.wait(lambda: program.screen().endswith(f'talker.talk("{how}", "hello")\n'), "the end of the line")
        return program

    def open_in_shell(self):
        (self.directory / "shell.py").write_text(SHELL)
        program = terminal.Program([sys.executable, "shell.py", DEPLOYER], self.directory, self.environment)
        self.addCleanup(program.__exit__)
        program.wait_for_prompt(PROMPT)
        return program

    def seen(self):
        file = self.directory / "seen"
        return file.read_text() if file.exists() else ""

    def mode(self, terminal):
        return termios.tcgetattr(terminal)[3] & (termios.ECHO | termios.ICANON | termios.ISIG)

    def go(self):
        (self.directory / "go").touch()

    def assert_restored(self, program):
        self.assertEqual(termios.ECHO | termios.ICANON | termios.ISIG, self.mode(program.terminal))

    def test_keys_are_not_shown_but_taken_at_the_next_prompt(self):
        program = self.busy()
        rows = program.screen().split("\n")
        program.send("20 + 3\r30 +")
        program.read(0.2)
        self.assertEqual(rows, program.screen().split("\n"))
        self.go()
        program.wait(lambda: program.screen().split("\n")[len(rows) - 1:] ==
                     [" = (void)", PROMPT + "20 + 3", " = 23", PROMPT + "30 +"], "the answers")
        self.assertEqual(" = 34", program.type(" 4", PROMPT))

    def test_the_terminal_is_restored_when_the_console_is_left(self):
        program = self.busy()
        self.go()
        program.send("quit\r")
        self.assertEqual(0, program.end())
        self.assert_restored(program)

    def test_the_terminal_is_restored_by_the_last_ctrl_c(self):
        program = self.blocked()
        program.send(CTRL_C)
        program.wait_for("another Ctrl-C ends the process at once")
        program.send(CTRL_C)
        self.assertEqual(-signal.SIGINT, program.end())
        self.assert_restored(program)

    def test_the_terminal_is_restored_when_it_is_told_that_the_console_is_left(self):
        program = self.blocked()
        os.kill(program.pid, signal.SIGTERM)
        program.wait_for("the console is left once it is done, and Ctrl-C ends the process at once")
        program.wait(lambda: self.mode(program.terminal) & termios.ECHO, "the terminal as it was")
        program.send(CTRL_C)
        self.assertEqual(-signal.SIGINT, program.end())
        self.assert_restored(program)

    def test_the_terminal_is_restored_by_a_crash(self):
        for how, number in ("abort", signal.SIGABRT), ("segv", signal.SIGSEGV):
            program = self.busy(how)
            self.go()
            self.assertIn(program.end(), (-number, 1))  # 1: by AddressSanitizer, which reports faults itself
            self.assert_restored(program)
            (self.directory / "go").unlink()

    def test_the_terminal_is_restored_by_a_crash_while_a_line_is_typed(self):
        program = self.open()
        program.send("half a li")
        program.wait_for("half a li")
        os.kill(program.pid, signal.SIGABRT)
        self.assertEqual(-signal.SIGABRT, program.end())
        self.assertIn("abort() was called", program.screen())
        self.assert_restored(program)

    def test_the_terminal_is_restored_by_signals_that_nobody_handles(self):
        for number in signal.SIGUSR1, signal.SIGPIPE, signal.SIGXCPU:
            program = self.open()
            os.kill(program.pid, number)
            self.assertEqual(-number, program.end())
            self.assert_restored(program)

    def test_the_terminal_is_restored_by_two_signals_at_once(self):
        program = self.open()
        os.kill(program.pid, signal.SIGTERM)
        os.kill(program.pid, signal.SIGTERM)
        self.assertIn(program.end(), (0, -signal.SIGTERM))
        self.assert_restored(program)

    def test_the_terminal_is_left_alone_by_a_child_that_crashes(self):
        program = self.open()
        program.type('import("talking"); loadComponent("talker", "Talker"); talker.start()', PROMPT)
        program.type('var SendHandle h; h = talker.talk.send("fork", "abort");', PROMPT)
        typing = self.mode(program.terminal)
        self.go()
        program.wait_for("abort() was called")
        program.wait(lambda: not (self.directory / "go").exists(), "the end of the child")
        self.assertEqual(typing, self.mode(program.terminal))

    def test_the_terminal_is_restored_while_the_process_is_stopped(self):
        program = self.busy(program=self.open_in_shell())
        program.send(CTRL_Z)
        once = "stopped with echo\nresumed without echo\n"
        program.wait(lambda: self.seen() == once, "the shell")
        self.go()
        program.wait_for(" = (void)\n" + PROMPT.rstrip())
        self.assertEqual(" = 2", program.type("1 + 1", PROMPT))
        program.send(CTRL_Z)
        program.wait(lambda: self.seen() == 2 * once, "the shell")
        program.send("2 + 2\r")
        program.wait_for(" = 4\n" + PROMPT.rstrip())
        program.send("quit\r")
        self.assertEqual(0, program.end())


if __name__ == "__main__":
    main()
