# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""Test cases that run rttlua: test.py RTTLUA COMPONENTS …"""
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "console"))

import terminal

RTTLUA, COMPONENTS, *MORE = sys.argv[1:]
PROMPT, MORE_PROMPT = "> ", ">> "


class LuaCase(unittest.TestCase):
    maxDiff = None

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.directory = pathlib.Path(folder.name)
        self.home = self.directory / "home"
        self.home.mkdir()
        self.environment = {"RTT_COMPONENT_PATH": COMPONENTS, "ORO_LOGFILE": "/dev/null", "HOME": str(self.home),
                            "LC_ALL": "C.UTF-8"}

    def write(self, name, text):
        (self.directory / name).write_text(text)
        return name

    def variables(self, more):
        own = {k: v for k, v in os.environ.items() if not k.startswith(("ORO_", "LUA_"))}
        return {**own, **self.environment, **more}

    def start(self, *words, program=RTTLUA, **environment):
        started = subprocess.Popen([program, *words], cwd=self.directory, env=self.variables(environment), text=True,
                                   stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.addCleanup(started.communicate)
        self.addCleanup(started.kill)
        return started

    def run_lua(self, *words, text="", program=RTTLUA, **environment):
        """Exit status, standard output and standard error."""
        done = subprocess.run([program, *words], cwd=self.directory, env=self.variables(environment), text=True,
                              input=text, capture_output=True, timeout=30, check=False)
        return done.returncode, done.stdout, done.stderr

    def open(self, *words, prompt=PROMPT, **environment):
        """On a terminal, after its first prompt."""
        program = terminal.Program([RTTLUA, *words], self.directory, {**self.environment, **environment})
        self.addCleanup(program.__exit__)
        program.wait_for_prompt(prompt)
        return program


def main():
    signal.signal(signal.SIGHUP, signal.SIG_DFL)  # which nohup has ignored, if it is what the tests are run by
    unittest.main(argv=sys.argv[:1])
