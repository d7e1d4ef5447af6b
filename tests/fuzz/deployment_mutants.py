#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""Lets the deployer check damaged files: those of tests/unit/deployer/strangers, with bytes and elements exchanged.

It must not crash or hang; it must say what is wrong, and where, whenever it fails; and when it succeeds, it must not have
told an error. What fails a dry run fails a check. The mutants follow from the seeds alone.

usage: deployment_mutants.py DEPLOYER STRANGERS_DIR COMPONENT_PATH
environment: DEPLOYMENT_MUTANTS  how many, default 150
             DEPLOYMENT_SEED     of the first, default 1
             DEPLOYMENT_KEEP     folder for the inputs that failed; by default none is kept
"""
import concurrent.futures
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile

ATTRIBUTE = re.compile(rb'(\w+)="([^"]*)"')
VALUE = re.compile(rb"<value>([^<]*)</value>")
SIMPLE = re.compile(rb"[ \t]*<simple [^>]*>.*?</simple>[^\n]*\n?")
STRUCT = re.compile(rb"[ \t]*<struct [^>]*>.*?</struct>[^\n]*\n?", re.DOTALL)
TAG = re.compile(rb"</?\w+[^>]*>")
WORDS = [b"", b"this", b"Deployer", b"Import", b"Include", b"Default", b"ConnPolicy", b"PropertyBag", b"zoo::Robot", b"Activity",
         b"SlaveActivity", b"Master", b"Properties", b"Ports", b"Peers", b"GlobalsRepository", b"RunScript", b"AutoConf", b"type",
         b"size", b"transport", b"array", b"strings", b"string", b"long", b"double", b"boolean", b"struct", b"r", b"a", b"out"]
VALUES = [b"", b"0", b"1", b"-1", b"true", b"999999999999999999999", b"1e308", b"-1e-308", b"nan", b"0x7f", b"4294967295", b"a.b.c",
          b"../..", b"/", b".", b"a01_activities.xml", b"params/all.cpf", b"scripts/values.ops", b"&#0;", b"&lt;", b"&unknown;",
          b"\xff\xfe", b"this", b"zoo::Robot", b"2", b"3", b"4", b"%s%n", b"x" * 5000]
ERROR = re.compile(r"(: error: |\[ (ERROR|Critical|Fatal) )")
LOCATED = re.compile(r"^[^\n]*?:(\d+:)?(\d+:)? error: ", re.MULTILINE)


def exchange_bytes(text, dice):
    at = dice.randrange(len(text) + 1)
    end = min(len(text), at + dice.choice((0, 1, 1, 2, 10, 100)))
    kind = dice.randrange(4)
    if kind == 0:
        return text[:at]
    if kind == 1:
        return text[:at] + text[end:]
    if kind == 2:
        return text[:at] + bytes(dice.choice(b'<>/"&;=![]- \n\0\xc3\xef0aA') for _ in range(dice.choice((1, 1, 3)))) + text[end:]
    return text[:end] + text[at:]


def exchange_parts(text, dice):
    form = dice.choice((ATTRIBUTE, ATTRIBUTE, VALUE, VALUE, SIMPLE, STRUCT, TAG))
    found = list(form.finditer(text))
    if not found:
        return text
    one, other = dice.choice(found), dice.choice(found)
    if form is ATTRIBUTE:
        new = one[1] + b'="' + dice.choice(WORDS + [other[2]]) + b'"' if dice.random() < 0.8 else b""
    elif form is VALUE:
        new = b"<value>" + dice.choice(VALUES + [other[1]]) + b"</value>"
    else:
        new = dice.choice((b"", one[0] + one[0], other[0], b"<properties>" + one[0] + b"</properties>"))
    return text[:one.start()] + new + text[one.end():]


def mutant(text, dice):
    for _ in range(dice.choice((1, 1, 2, 4))):
        text = (exchange_parts if dice.random() < 0.7 else exchange_bytes)(text, dice)
    return text


def deploy(deployer, folder, option, file, of_script, path):
    environment = dict(os.environ, RTT_COMPONENT_PATH=path, ORO_LOGFILE="/dev/null")
    run = subprocess.run([deployer, option, "-s", file], cwd=folder, env=environment, capture_output=True, timeout=60, check=False)
    said = run.stderr.decode(errors="replace")
    if run.returncode not in (0, 255):
        return run.returncode, f"{option} ended with status {run.returncode}:\n{said}"
    # Operations that return false after telling an error do not stop a script.
    if run.returncode == 0 and not of_script and ERROR.search(said):
        return 0, f"{option} told an error and succeeded:\n{said}"
    if run.returncode == 255 and not LOCATED.search(said):
        return 255, f"{option} failed without a place:\n{said}"
    return run.returncode, ""


def test(seed, deployer, strangers, path):
    """The first thing that is wrong with what the deployer makes of a mutant; empty if all is well."""
    dice = random.Random(seed)
    files = sorted(each for each in strangers.rglob("*") if each.suffix in (".xml", ".cpf", ".ops", ".osd"))
    damaged = dice.choice(files)
    # Those are in turn used by one that names them.
    starts = sorted(each.name for each in strangers.glob("*.xml") if damaged.parent == strangers or damaged.name.encode() in each.read_bytes())
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch) / "case"
        shutil.copytree(strangers, folder)
        inside = damaged.relative_to(strangers)
        (folder / inside).write_bytes(mutant(damaged.read_bytes(), dice))
        of_script = damaged.suffix in (".ops", ".osd")
        start = damaged.name if damaged.parent == strangers else dice.choice(starts or ["d01_includes.xml"])
        try:
            dry, wrong = deploy(deployer, folder, "--dry-run", start, of_script, path)
            if not wrong:
                check, wrong = deploy(deployer, folder, "--check", start, of_script, path)
                if not wrong and dry != 0 and check == 0:
                    wrong = "a check finds nothing wrong with what fails a dry run"
        except subprocess.TimeoutExpired:
            wrong = "it hangs"
        keep = os.environ.get("DEPLOYMENT_KEEP")
        if wrong and keep:
            shutil.copytree(folder, pathlib.Path(keep) / str(seed), dirs_exist_ok=True)
    return f"mutant {seed} of {inside}, run by {start}: {wrong}" if wrong else ""


def main():
    deployer, strangers, path = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2]).absolute(), sys.argv[3]
    first, count = int(os.environ.get("DEPLOYMENT_SEED", "1")), int(os.environ.get("DEPLOYMENT_MUTANTS", "150"))
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        results = list(pool.map(lambda seed: test(seed, deployer, strangers, path), range(first, first + count)))
    failures = [each for each in results if each]
    print("\n\n".join(failures[:20]))
    print(f"{count} mutants from seed {first}, {len(failures)} failures")
    return 1 if failures or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
