# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""Test cases that run oro: test.py ORO DEPLOYER COMPONENTS SOURCES"""
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

ORO, DEPLOYER, COMPONENTS, SOURCES = sys.argv[1:5]
sys.path.insert(0, str(pathlib.Path(SOURCES) / "tests/unit/console"))

import terminal  # noqa: E402
from fake_deployment import FakeDeployment  # noqa: E402


class OroCase(unittest.TestCase):
    maxDiff = None

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.directory = pathlib.Path(folder.name)
        self.environment = {"XDG_RUNTIME_DIR": folder.name, "RTT_COMPONENT_PATH": COMPONENTS, "ORO_LOGFILE": "/dev/null",
                            "HOME": folder.name, "LC_ALL": "C.UTF-8"}

    def own(self, **more):
        kept = {k: v for k, v in os.environ.items() if not k.startswith(("ORO_", "NO_COLOR"))}
        return {**kept, **self.environment, **more}

    def fake(self, handle, **options):
        deployment = FakeDeployment(self.directory, handle, **options)
        self.addCleanup(deployment.close)
        return deployment

    def oro(self, *words, status=0, text="", **environment):
        """Standard output and standard error."""
        done = subprocess.run([ORO, *words], cwd=self.directory, env=self.own(**environment), input=text, text=True,
                              capture_output=True, timeout=20, check=False)
        self.assertEqual(status, done.returncode, f"oro {words}\n{done.stdout}{done.stderr}")
        return done.stdout, done.stderr

    def start_oro(self, *words, **environment):
        process = subprocess.Popen([ORO, *words], cwd=self.directory, env=self.own(**environment), text=True,
                                   stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.addCleanup(self.end, process)
        return process

    def open_oro(self, *words, width=100, **environment):
        """On a terminal."""
        program = terminal.Program([ORO, *words], self.directory, {**self.environment, **environment}, width)
        self.addCleanup(program.__exit__)
        return program

    def end(self, process):
        if process.poll() is None:
            process.kill()
        process.communicate()

    def deploy(self, script, *options):
        """A deployer that has executed the script, and goes on."""
        (self.directory / "app.ops").write_text(script)
        process = subprocess.Popen([DEPLOYER, "-s", "app.ops", *options], cwd=self.directory, env=self.own(), text=True,
                                   stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        self.addCleanup(self.end, process)
        process.stdin.write('"ready"\n')
        process.stdin.flush()
        self.said = []
        while not self.said or "ready" not in self.said[-1]:
            self.said.append(process.stdout.readline())
            self.assertTrue(self.said[-1], f"the deployer ends: {self.said}")
        return process

    def wait(self, condition, what):
        until = time.monotonic() + 20
        while not condition():
            self.assertLess(time.monotonic(), until, f"{what} does not come")
            time.sleep(0.005)


def main():
    for number in signal.SIGHUP, signal.SIGINT:  # which nohup and shells ignore for what is in the background
        signal.signal(number, signal.SIG_DFL)
    unittest.main(argv=[sys.argv[0], *sys.argv[5:]])
