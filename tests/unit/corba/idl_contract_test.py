#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""Programs of others are built with the IDL of the original, so ours never changes.

idl_contract_test.py OMNIIDL FOLDER-WITH-IDL FOLDER-WITH-STUBS
"""
import difflib
import os
import pathlib
import re
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
GOLDEN = HERE.parents[1] / "golden/idl/rtt_corba/expected/contract.txt"


def contract(omniidl, folder):
    text = ""
    for file in sorted(folder.glob("*.idl")):
        command = [omniidl, "-p" + str(HERE), "-bidl_contract", str(file)]
        environment = dict(os.environ, PYTHONDONTWRITEBYTECODE="1")
        shown = subprocess.run(command, check=True, capture_output=True, text=True, env=environment).stdout
        text += f"== {file.name}\n{shown}"
    return text


def ids_without_stub(text, folder):
    """The repository ids of the contract that the generated code does not have."""
    files = [*folder.glob("*C.cc"), *folder.glob("*DynSK.cc")]
    stubs = "".join(file.read_text() for file in files)
    return [one for one in sorted(set(re.findall(r"IDL:[\w/]+:1\.0", text))) if f'"{one}' not in stubs]


def main():
    actual = contract(sys.argv[1], pathlib.Path(sys.argv[2]))
    if os.environ.get("UPDATE_GOLDENS") and not os.environ.get("CI"):
        GOLDEN.write_text(actual)
    expected = GOLDEN.read_text()
    difference = list(difflib.unified_diff(expected.splitlines(), actual.splitlines(), str(GOLDEN), "the IDL", lineterm=""))
    missing = ids_without_stub(actual, pathlib.Path(sys.argv[3]))
    print("\n".join(difference + ["the stubs have no " + one for one in missing]))
    return 1 if difference or missing else 0


if __name__ == "__main__":
    sys.exit(main())
