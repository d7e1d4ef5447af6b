# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""Signals that end the deployer while its terminal takes nothing: Ctrl-S was pressed, or its other end does not read."""
import os
import signal
import time

from deployer_case import PROMPT, DeployerCase, main

CTRL_S = "\x13"
LOAD = 'import("talking"); loadComponent("talker", "Talker"); talker.start()'


class StoppedTerminal(DeployerCase):
    def talking(self):
        program = self.open()
        program.type(LOAD, PROMPT)
        return program

    def wait_for_stop(self, program, reads):
        """The component must be stopped, whatever becomes of the output."""
        until = time.monotonic() + 10
        while not (self.directory / "stopped").exists():
            self.assertLess(time.monotonic(), until, "the component is not stopped")
            if reads:
                program.read(0.02)
            time.sleep(0.02)

    def stop_output(self, program):
        program.send(CTRL_S)
        time.sleep(0.3)  # nothing tells that the terminal has stopped

    def test_components_are_stopped_when_the_prompt_waits(self):
        for number in signal.SIGTERM, signal.SIGHUP:
            with self.subTest(number):
                (self.directory / "stopped").unlink(missing_ok=True)
                program = self.talking()
                self.stop_output(program)
                os.kill(program.pid, number)
                self.wait_for_stop(program, reads=True)
                self.assertEqual(0, program.end())

    def test_components_are_stopped_when_the_editor_writes(self):
        program = self.talking()
        self.stop_output(program)
        program.send("1 + 1")  # which it cannot show
        time.sleep(0.3)
        os.kill(program.pid, signal.SIGTERM)
        self.wait_for_stop(program, reads=True)
        self.assertEqual(0, program.end())

    def test_components_are_stopped_when_a_component_writes(self):
        program = self.talking()
        program.type('talker.talk.send("out", "hello")', PROMPT)
        self.stop_output(program)
        (self.directory / "go").touch()
        time.sleep(0.3)
        os.kill(program.pid, signal.SIGTERM)
        self.wait_for_stop(program, reads=True)
        self.assertEqual(0, program.end())
        # The prompt may come between any two parts of the line; none of them is lost.
        between = r"(\s|Deployer \[S\]>)+"
        self.assertRegex(program.screen(), f"hello{between}and{between}5{between}letters")

    def test_components_are_stopped_when_a_command_writes(self):
        program = self.talking()
        program.send('while true { talker.begin() }\r')
        program.wait_for("begun\nbegun")
        self.stop_output(program)
        os.kill(program.pid, signal.SIGTERM)
        self.wait_for_stop(program, reads=True)
        self.assertEqual(0, program.end())

    def test_components_are_stopped_when_nobody_reads(self):
        program = self.talking()
        program.type('talker.talk.send("ever", "hello")', PROMPT)
        (self.directory / "go").touch()
        time.sleep(0.5)  # the terminal is full
        os.kill(program.pid, signal.SIGTERM)
        time.sleep(1)
        (self.directory / "enough").touch()
        self.wait_for_stop(program, reads=False)
        program.end()


if __name__ == "__main__":
    main()
