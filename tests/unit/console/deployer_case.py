# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""Test cases that run the deployer: test.py DEPLOYER COMPONENTS SOURCES"""
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import unittest

import terminal

DEPLOYER, COMPONENTS, SOURCES = sys.argv[1:4]
PROMPT = "Deployer [S]> "


class DeployerCase(unittest.TestCase):
    maxDiff = None

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.directory = pathlib.Path(folder.name)
        self.environment = {"RTT_COMPONENT_PATH": COMPONENTS, "ORO_LOGFILE": "/dev/null", "NO_COLOR": "1",
                            "HOME": folder.name}

    def open(self, *arguments, prompt=PROMPT, **environment):
        """On a terminal, after its first prompt."""
        program = terminal.Program([DEPLOYER, *arguments], self.directory, {**self.environment, **environment})
        self.addCleanup(program.__exit__)
        program.wait_for_prompt(prompt)
        return program

    def run_with(self, text, *arguments, status=0):
        """Without a terminal; standard output and standard error."""
        own = {k: v for k, v in os.environ.items() if not k.startswith("ORO_")}
        done = subprocess.run([DEPLOYER, *arguments], cwd=self.directory, env={**own, **self.environment}, input=text,
                              text=True, capture_output=True, timeout=20, check=False)
        self.assertEqual(status, done.returncode, done.stderr)
        return done.stdout, done.stderr


def main():
    signal.signal(signal.SIGHUP, signal.SIG_DFL)  # which nohup has ignored, if it is what the tests are run by
    unittest.main(argv=sys.argv[:1])
