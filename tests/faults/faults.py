#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""Runs the programs where something is missing: threads, file handles, room on the disk, time before they are killed.

No program may crash or hang; one that fails says why. A file is the old one or the new one afterwards, never a part of
it, and the next run leaves nothing else behind. What is done follows from the seeds alone, but for the moment of a kill.

usage: faults.py DEPLOYER COMPONENT_PATH ORO_CREATE_PKG TYPEGEN MANIFEST HEADER
environment: FAULTS_ROUNDS  how often, default 3
             FAULTS_SEED    of the first, default 1
"""
import os
import pathlib
import random
import resource
import signal
import subprocess
import sys
import tempfile
import time

DEPLOYER, COMPONENTS, ORO_CREATE_PKG, TYPEGEN, MANIFEST, HEADER = sys.argv[1:7]
ENVIRONMENT = dict(os.environ, RTT_COMPONENT_PATH=COMPONENTS, ORO_LOGLEVEL="4", OROCOS_TARGET=os.environ.get("OROCOS_TARGET", "gnulinux"))
LIMIT = 60
failures = []


def fail(what, result=None):
    failures.append(what)
    print("FAILED: " + what)
    if result is not None:
        print(f"  status {result.returncode}\n  " + (result.stdout + result.stderr).decode(errors="replace")[-1500:].replace("\n", "\n  "))


def run(words, folder, limits=(), **more):
    def restrict():
        for what, value in limits:
            resource.setrlimit(what, (value, value))
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    return subprocess.run(words, cwd=folder, env=ENVIRONMENT, stdin=subprocess.DEVNULL, capture_output="stdout" not in more,
                          timeout=LIMIT, preexec_fn=restrict, **more)


def expect_told(what, result, statuses=(0, 1, 2, 255)):
    """It ended by itself and, if it failed, said why."""
    if result.returncode not in statuses:
        fail(f"{what}: it did not end by itself", result)
    elif result.returncode != 0 and not (result.stdout + result.stderr).strip():
        fail(f"{what}: it failed and said nothing", result)


def components(number):
    one = '<struct name="c{}" type="OCL::HelloWorld"><simple name="AutoStart" type="boolean"><value>1</value></simple></struct>'
    return '<properties><simple name="Import" type="string"><value>ocl</value></simple>' + "".join(
        one.format(i) for i in range(number)) + "</properties>"


def snapshot(folder):
    return {path.relative_to(folder): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


GENERATORS = {
    "orocreate-pkg": ([ORO_CREATE_PKG, "--generate", MANIFEST, "--output", "package"], "package"),
    "typegen": ([TYPEGEN, "--output", "kit", "kit", HEADER], "kit"),
}


def few_threads(dice, folder):
    """Stacks are large, and memory for them is short."""
    (folder / "app.xml").write_text(components(30))
    memory = dice.randrange(700, 2500) << 20
    result = run([DEPLOYER, "-s", "app.xml"], folder, [(resource.RLIMIT_STACK, 64 << 20), (resource.RLIMIT_AS, memory)])
    expect_told(f"deployer with {memory >> 20} MB", result, (0, 255))


def few_handles(dice, folder):
    (folder / "app.xml").write_text(components(5))
    number = dice.randrange(4, 40)
    for name, words in {"deployer": [DEPLOYER, "-s", "app.xml"], **{k: v[0] for k, v in GENERATORS.items()}}.items():
        try:
            result = run(words, folder, [(resource.RLIMIT_NOFILE, number)])
        except subprocess.SubprocessError:
            continue  # too few to start anything
        # 127: the loader finds no library.
        expect_told(f"{name} with {number} files", result, (0, 1, 2, 127, 255))


def no_room(dice, folder):
    """Files cannot become longer than that."""
    size = dice.randrange(0, 20000)
    for name, (words, out) in GENERATORS.items():
        run(words, folder)
        whole = snapshot(folder / out)
        expect_told(f"{name} with {size} bytes", run(words, folder, [(resource.RLIMIT_FSIZE, size)]))
        if snapshot(folder / out) != whole:
            fail(f"{name} with {size} bytes: what was there is damaged")
        for path in list(whole)[::2]:
            (folder / out / path).unlink()
        result = run(words, folder, [(resource.RLIMIT_FSIZE, size)])
        expect_told(f"{name} with {size} bytes, half of the files gone", result)
        for path, text in snapshot(folder / out).items():
            if text != whole.get(path):
                fail(f"{name} with {size} bytes: {path} is damaged")


def killed(dice, folder):
    for name, (words, out) in GENERATORS.items():
        run(words, folder)
        whole = snapshot(folder / out)
        for _ in range(5):
            for path in list(whole)[dice.randrange(2)::2]:
                (folder / out / path).unlink(missing_ok=True)
            start = time.monotonic()
            program = subprocess.Popen(words, cwd=folder, env=ENVIRONMENT, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                       stderr=subprocess.DEVNULL)
            time.sleep(dice.random() * 0.4)
            program.kill()
            program.wait()
            for path, text in snapshot(folder / out).items():
                if path in whole and text != whole[path]:
                    fail(f"{name} killed after {time.monotonic() - start:.3f} s: {path} is damaged")
        result = run(words, folder)
        if result.returncode != 0:
            fail(f"{name} after it was killed", result)
        if snapshot(folder / out) != whole:
            fail(f"{name} after it was killed: {sorted(set(snapshot(folder / out)) ^ set(whole))} differ")


def full_device(_dice, folder):
    for words in ([ORO_CREATE_PKG, "--list"], [ORO_CREATE_PKG, "--explain"], [ORO_CREATE_PKG, "--describe", HEADER],
                  [TYPEGEN, "--explain"], [TYPEGEN, "--help"], [DEPLOYER, "--explain"], [DEPLOYER, "--help"], [DEPLOYER, "--version"]):
        with open("/dev/full", "wb") as full:
            result = run(words, folder, stdout=full, stderr=subprocess.PIPE)
        if result.returncode in (0, None) or result.returncode < 0:
            fail(f"{pathlib.Path(words[0]).name} {' '.join(words[1:])} to a full device ends with {result.returncode}")


def main():
    seed = int(os.environ.get("FAULTS_SEED", "1"))
    for number in range(seed, seed + int(os.environ.get("FAULTS_ROUNDS", "3"))):
        dice = random.Random(number)
        for fault in (few_threads, few_handles, no_room, killed, full_device):
            with tempfile.TemporaryDirectory() as folder:
                try:
                    fault(dice, pathlib.Path(folder))
                except subprocess.TimeoutExpired as hung:
                    fail(f"seed {number}, {fault.__name__}: {' '.join(hung.cmd)} hangs")
    print(f"{len(failures)} failures")
    return 1 if failures else 0


sys.exit(main())
