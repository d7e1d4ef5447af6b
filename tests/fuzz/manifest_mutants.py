#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""Lets orocreate-pkg read damaged manifests: those of the golden cases, with types that nobody knows, words exchanged, bytes that
are no UTF-8, and ends cut off; now and then the typekit header that a manifest names is damaged, too.

It must not crash or hang, must say what is wrong, and where, whenever it fails, write nothing then, and what it writes on success
is UTF-8. The mutants follow from the seeds alone.

usage: manifest_mutants.py OROCREATE_PKG GOLDEN_DIR
environment: MANIFEST_MUTANTS  how many, default 300
             MANIFEST_SEED     of the first, default 1
             MANIFEST_KEEP     folder for the inputs that failed; by default none is kept
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

ATTRIBUTE = re.compile(r'([\w:]+)="([^"]*)"')
TYPES = ["greenhouse::Climat", "doubel", "Nothing", "std::vectr&lt;int&gt;", "std::vector&lt;Unknown&gt;", "::", "a::b::c::d", "int int",
         "const", "*", "std::vector&lt;", "&gt;&gt;", "std::vector&lt;" * 300 + "int" + "&gt;" * 300, "a&lt;" * 5000, "(" * 3000,
         "int;} struct {", "struct {int x;}", "decltype(1)", "auto", "void", "int[3]", "std", "std::", "string", "unsigned long long",
         "// int", "/*", "#include", "F\udcfcr", "\u00fcber", "int&#10;x", "&quot;", "x" * 2000, "", "bool", "float", "std::string", "std::vector&lt;double&gt;", "::std::int8_t",
         "const double&amp;", "unsigned"]
DEFAULTS = ["heta", "1e999", "-1", "\udcff", "&quot;", "{}", "({", "true", "0x", "&#10;", "\\", "std::", "%s", "*/"]
RAW = ["\udcff", "\udcc3", "\udcf4\udc90\udc80\udc80", "\x00", "\x1b", "\ufeff", "&#0;", "&#xd800;", "&amp", "<!--", "]]>", "<a>", "\r"]


def exchange(text, dice):
    for _ in range(dice.choice((1, 1, 2, 3))):
        attributes = list(ATTRIBUTE.finditer(text))
        if not attributes:
            break
        typed = [one for one in attributes if one[1] in ("type", "returns")] or attributes
        kind = dice.randrange(6)
        one = dice.choice(typed if kind < 2 else attributes)
        if kind < 2:
            new = f'{one[1]}="{dice.choice(TYPES)}"'
        elif kind < 4:  # of an attribute of the same name, so that some manifests are accepted
            new = dice.choice([other for other in attributes if other[1] == one[1]])[0]
        elif kind == 4:
            new = f'{dice.choice(attributes)[1]}="{one[2]}"'
        else:
            new = f'{one[0]} default="{dice.choice(DEFAULTS)}"'
        text = text[:one.start()] + new + text[one.end():]
    return text


def spoil(text, dice):
    at = dice.randrange(len(text) + 1)
    return text[:at] if dice.random() < 0.3 else text[:at] + dice.choice(RAW) + text[at:]


def broken_utf8(folder):
    for file in sorted(path for path in folder.rglob("*") if path.is_file()):
        try:
            file.read_bytes().decode("utf-8")
        except UnicodeDecodeError:
            return f"{file.relative_to(folder)} is no UTF-8"
    return ""


def complaint(program, folder, manifest):
    status, text = typegen_mutants.run([program, "--generate", manifest, "--output", "generated_output"], folder)
    out = folder / "generated_output"
    if status is None:
        return f"no end after {typegen_mutants.TIMEOUT} s", False
    if status not in (0, 1):
        return f"status {status}: {text[-2000:]}", False
    if status == 0:
        return broken_utf8(out) if out.exists() else "succeeded, but wrote nothing", True
    if not re.search(r"^[^\n]*: error: ", text, re.MULTILINE):
        return f"failed without an error: {text[-500:]}", False
    return "failed, but wrote files" if out.exists() else "", False


def try_one(number, seed, manifests, program):
    dice = random.Random(seed + number)
    manifest = dice.choice(manifests)
    with tempfile.TemporaryDirectory(prefix="manifest-mutant-") as place:
        folder = pathlib.Path(place) / "case"
        shutil.copytree(manifest.parent, folder, ignore=shutil.ignore_patterns("expected"))
        headers = sorted(folder.rglob("*.hpp"))
        if headers and dice.random() < 0.3:
            victim, changes = dice.choice(headers), (typegen_mutants.damage, typegen_mutants.bend, spoil)
        else:
            victim, changes = folder / manifest.name, (exchange, exchange, exchange, spoil, typegen_mutants.damage)
        text = victim.read_bytes().decode("utf-8", "surrogateescape")
        victim.write_bytes(dice.choice(changes)(text, dice).encode("utf-8", "surrogateescape"))
        wrong, succeeded = complaint(program, folder, manifest.name)
        if wrong and os.environ.get("MANIFEST_KEEP"):
            shutil.copytree(folder, pathlib.Path(os.environ["MANIFEST_KEEP"]) / f"{seed + number}", dirs_exist_ok=True)
        return f"seed {seed + number} ({manifest.parent.name}): {wrong}" if wrong else "", succeeded


def main():
    program, golden = sys.argv[1], pathlib.Path(sys.argv[2])
    count, seed = int(os.environ.get("MANIFEST_MUTANTS", "300")), int(os.environ.get("MANIFEST_SEED", "1"))
    kinds = ("component", "component", "component", "manifest_model", "manifest_view", "manifest_diagnostics")
    manifests = sorted(file for kind in kinds for file in golden.glob(kind + "/*/*.xml"))
    with concurrent.futures.ThreadPoolExecutor(max_workers=os.cpu_count()) as pool:
        results = list(pool.map(lambda i: try_one(i, seed, manifests, program), range(count)))
    wrong = [text for text, _ in results if text]
    print("\n".join(wrong))
    print(f"{count} mutants of {len(manifests)} manifests: {sum(ok for _, ok in results)} accepted, {len(wrong)} wrong")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
