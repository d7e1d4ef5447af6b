#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""compile_generated.py TYPEGEN COMPILER… : what typegen makes of random headers compiles.

GENERATED_SEEDS=20 GENERATED_FIRST=… searches for longer.
"""
import glob
import os
import subprocess
import sys
import tempfile

from random_header import RandomHeader

TYPES_PER_HEADER = 30


def run(command, folder):
    """What it says, if it fails."""
    done = subprocess.run(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True)
    return done.stdout[-2000:] or f'status {done.returncode}' if done.returncode != 0 else ''


def complaint(seed, typegen, compiler):
    with tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(folder, 'types.hpp'), 'w', encoding='utf-8') as file:
            file.write(RandomHeader(seed, TYPES_PER_HEADER).text())
        wrong = run([typegen, '-o', 'out', 'random', 'types.hpp'], folder)
        sources = sorted(glob.glob(os.path.join(folder, 'out', '*.cpp')))
        if not wrong and not sources:
            wrong = 'nothing was written'
        for source in sources:
            wrong = wrong or run([*compiler, '-w', '-I.', '-Iout/types', source], folder)
        return wrong


def main():
    typegen, compiler = os.path.abspath(sys.argv[1]), sys.argv[2:]
    first, count = int(os.environ.get('GENERATED_FIRST', '1')), int(os.environ.get('GENERATED_SEEDS', '1'))
    wrong = 0
    for seed in range(first, first + count):
        said = complaint(seed, typegen, compiler)
        if said:
            print(f'seed {seed}: {said}')
            wrong += 1
    print(f'{count} headers with {TYPES_PER_HEADER} types each, {wrong} wrong')
    return 1 if wrong else 0


if __name__ == '__main__':
    sys.exit(main())
