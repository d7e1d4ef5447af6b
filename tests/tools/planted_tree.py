# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""A temporary tree with given files, and what a rule script says about it."""
import pathlib
import subprocess
import sys
import tempfile

TOOLS = pathlib.Path(__file__).resolve().parents[2] / "tools"
LICENCE = "// SPDX-License-Identifier: Apache-2.0\n// Copyright Oroforge contributors\n"


def header(name, body=""):
    """A correct header with an include guard made of `name`."""
    return f"{LICENCE}#ifndef {name}\n#define {name}\n{body}\n#endif\n"


def check(script, files):
    """(exit code, findings) of tools/`script` on a tree of {path: text}."""
    with tempfile.TemporaryDirectory() as root:
        for path, text in files.items():
            target = pathlib.Path(root) / path
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_text(text)
        run = subprocess.run([sys.executable, str(TOOLS / script), "--root", root], capture_output=True, text=True)
        return run.returncode, [line for line in run.stderr.splitlines() if ": error: " in line]


def check_one(test, script, files, finding):
    """Asserts that the tree has exactly one finding, which begins with `finding`."""
    status, found = check(script, files)
    test.assertEqual(len(found), 1, found)
    test.assertTrue(found[0].startswith(finding), f"{found[0]!r} does not begin with {finding!r}")
    test.assertEqual(status, 1)


def check_none(test, script, files):
    status, found = check(script, files)
    test.assertEqual((status, found), (0, []))
