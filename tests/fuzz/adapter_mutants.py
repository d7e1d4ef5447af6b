#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""Lets typegen read damaged adapter files: that of a golden case, with attributes exchanged, renamed, left out, and text broken.

It must not crash or hang, must say what is wrong whenever it fails, write nothing then, and what it writes on success must
compile. The mutants follow from the seeds alone.

usage: adapter_mutants.py TYPEGEN CASE_DIR COMPILER [FLAG...]
environment: TYPEGEN_MUTANTS  how many, default 200
             TYPEGEN_SEED     of the first, default 1
             TYPEGEN_KEEP     folder for the inputs that failed; by default none is kept
"""
import concurrent.futures
import os
import pathlib
import random
import re
import shutil
import sys
import tempfile

import typegen_mutants

ATTRIBUTE = re.compile(r'(\w+)="([^"]*)"')
ELEMENT = re.compile(r"  +<(\w+)[^>]*?/>\n|  <(\w+) .*?</\2>\n", re.DOTALL)
ACCESSORS = ["x()", "heading", "heading.label()", "degrees()", "label()", "[0]", "[index]", "(row, column)", "get(index)",
             "length()", "reset(size)", "setDegrees(value)", "setValid(value)", "isValid()", "width()", "2", "$N", "$T", "size",
             "setCell(row, column, value)", "cell(row, column)", "at_[0]", "turns_", "()", "operator()", "get(index).length()",
             "heading.degrees().x", "label().size()", "label()[0]", "label()[index]", "label().c_str()", "label().begin()",
             "label().clear()", "label().resize(size)", "label().size", "get(0)", "[1][2]", "~Angle()", "Angle()"]
WORDS = ["name", "get", "set", "size", "rows", "columns", "element", "resize", "class", "arguments", "alias", "unit", "nmae"]
SUCCESSES_COMPILED = 0.6


def exchange(text, dice):
    """Well-formed XML with other words in it."""
    for _ in range(dice.choice((1, 1, 1, 2))):
        attributes = list(ATTRIBUTE.finditer(text))
        one, other = dice.choice(attributes), dice.choice(attributes)
        kind = dice.randrange(6)
        if kind == 0:
            new = f'{one[1]}="{dice.choice(ACCESSORS)}"'
        elif kind == 1:
            new = f'{one[1]}="{other[2]}"'
        elif kind == 2:
            new = f'{dice.choice(WORDS)}="{one[2]}"'
        elif kind == 3:
            new = ""
        elif kind == 4:
            new = f'{one[0]} {other[0]}'
        else:
            elements = list(ELEMENT.finditer(text))
            gone = dice.choice(elements)
            text = text[:gone.start()] + text[gone.end():] if dice.random() < 0.5 else \
                text[:gone.end()] + dice.choice(elements)[0] + text[gone.end():]
            continue
        text = text[:one.start()] + new + text[one.end():]
    return text


def join(folder):
    """All sources in one, without the instances that users link against: these do not depend on accessors, and take long."""
    lines = []
    for source in sorted((folder / "generated_output").glob("types_*.cpp")):
        lines += [line for line in source.read_text().splitlines(True) if not line.startswith("template class ")]
        source.unlink()
    (folder / "generated_output" / "types_all.cpp").write_text("".join(lines))
    for other in (folder / "generated_output").rglob("Plugin.cpp"):
        other.unlink()
    for header in (folder / "generated_output").rglob("Types.hpp"):
        text = header.read_text()
        header.write_text("".join(line for line in text.splitlines(True) if not line.startswith("extern template")))


def try_one(number, seed, case, typegen, compiler):
    dice = random.Random(seed + number)
    with tempfile.TemporaryDirectory(prefix="adapter-mutant-") as place:
        folder = pathlib.Path(place) / "case"
        shutil.copytree(case, folder, ignore=shutil.ignore_patterns("expected"))
        victim = folder / "library.xml"
        change = dice.choice((typegen_mutants.damage, exchange, exchange, exchange, exchange, exchange))
        victim.write_bytes(change(victim.read_text(), dice).encode("utf-8", "surrogateescape"))
        words = (folder / "args").read_text().splitlines()
        wrong, succeeded = typegen_mutants.complaint(typegen, compiler, folder, words, dice, compiled=0)
        if succeeded and not wrong and dice.random() < SUCCESSES_COMPILED:
            join(folder)
            wrong = typegen_mutants.compile_complaint([*compiler, "-Igenerated_output"], folder, words)
        if wrong and os.environ.get("TYPEGEN_KEEP"):
            shutil.copytree(folder, pathlib.Path(os.environ["TYPEGEN_KEEP"]) / f"{seed + number}", dirs_exist_ok=True)
        return f"seed {seed + number}: {wrong}" if wrong else "", succeeded


def main():
    typegen, case, compiler = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3:]
    count, seed = int(os.environ.get("TYPEGEN_MUTANTS", "200")), int(os.environ.get("TYPEGEN_SEED", "1"))
    with concurrent.futures.ThreadPoolExecutor(max_workers=os.cpu_count()) as pool:
        results = list(pool.map(lambda i: try_one(i, seed, case, typegen, compiler), range(count)))
    wrong = [text for text, _ in results if text]
    print("\n".join(wrong))
    print(f"{count} mutants: {sum(ok for _, ok in results)} accepted, {len(wrong)} wrong")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
