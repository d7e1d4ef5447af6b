#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""Lets typegen read damaged headers: the golden ones, with tokens deleted, doubled, swapped or replaced.

It must not crash or hang, must say what is wrong whenever it fails, write nothing then, and what it writes on success
must compile. The mutants follow from the seeds alone.

usage: typegen_mutants.py TYPEGEN GOLDEN_DIR COMPILER [FLAG...]
environment: TYPEGEN_MUTANTS  how many, default 150
             TYPEGEN_SEED     of the first, default 1
             TYPEGEN_KEEP     folder for the inputs that failed; by default none is kept
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

TIMEOUT = 20
TOKEN = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'|'
                   r'[A-Za-z_]\w*|\d[\w.]*|::|\s+|.', re.DOTALL)
SPICE = ["const", "*", "&", "[0]", "[]", "virtual", "private:", "template <class T>", "union", "struct", "int", "<", ">",
         "{", "}", "(", ")", ";", ",", "::", "#include \"gone.hpp\"\n", "static", "volatile", "= 0", ": 3", "\0", "\udcff",
         "/*", "\"", "auto", "decltype(", "operator", "using namespace std;", "mutable", "enum", "alignas(64)",
         "typename", "friend", "0x", "...", "std::vector<", "long double", "__int128", "#define int\n", "#if 0\n", "\\\n"]
TYPES = ["bool", "char", "signed char", "unsigned char", "short", "int", "unsigned", "long", "long long", "unsigned long long",
         "float", "double", "long double", "wchar_t", "char16_t", "std::string", "const int", "volatile int", "int*", "int&",
         "std::vector<int>", "std::vector<bool>", "std::vector<std::vector<double>>", "std::vector<std::string>",
         "struct { int x; }", "union { int a; float b; }", "enum { kA, kB = 7 }", "enum class : unsigned char { kC }",
         "static int", "static constexpr int", "mutable int", "alignas(32) int", "[[deprecated]] int", "auto", "void"]
BUILTIN = re.compile(r"^(bool|char|short|int|long|float|double|string|u?int(8|16|32|64)_t)$")
NUMBER = re.compile(r"^\d[\w.]*$")
WORD = re.compile(r"^[A-Za-z_]\w*$")
SUCCESSES_COMPILED = 0.3
DEPTHS = (3, 100, 300, 2000, 20000)
NESTED = [("std::vector<", "int", ">"), ("(", "1", ")"), ("{", "1", "}"), ("[", "1", "]"), ("- ", "1", ""), ("*", " p", ""),
          ("struct { ", "int x; ", "} y; "), ("namespace n { ", "", "} "), ("~", "x", ""), ("!", "x", ""), ("(int)", "1", "")]
BYTES = ["\udcff", "F\udcfcr", "\udcc3", "\udced\udca0\udc80", "\x1a", "\r", "\ufeff"]


def bend(text, dice):
    """Changes that mostly leave C++: other types, other numbers, other names, lines in another order."""
    tokens = TOKEN.findall(text)
    for _ in range(dice.choice((1, 1, 2, 4))):
        kind = dice.randrange(4)
        if kind == 0:
            places = [i for i, token in enumerate(tokens) if BUILTIN.match(token)]
            replacement = dice.choice(TYPES)
        elif kind == 1:
            places = [i for i, token in enumerate(tokens) if NUMBER.match(token)]
            replacement = dice.choice(("0", "1", "2", "7", "300", "-1", "1.5", "'c'", "true"))
        elif kind == 2:
            places = [i for i, token in enumerate(tokens) if WORD.match(token) and not BUILTIN.match(token)]
            replacement = dice.choice(("x", "value", "object", "type", "end", "_a", "b_", "RTT", "data"))
        else:
            lines = "".join(tokens).splitlines(keepends=True)
            at = dice.randrange(len(lines))
            lines.insert(dice.randrange(len(lines)), lines.pop(at) if dice.random() < 0.5 else lines[at])
            tokens = TOKEN.findall("".join(lines))
            continue
        if places:
            tokens[dice.choice(places)] = replacement
    return "".join(tokens)


def damage(text, dice):
    tokens = TOKEN.findall(text)
    for _ in range(dice.choice((1, 1, 1, 2, 3, 8))):
        words = [i for i, token in enumerate(tokens) if not token.isspace()]
        if not words:
            break
        at, other = dice.choice(words), dice.choice(words)
        kind = dice.randrange(6)
        if kind == 0:
            del tokens[at]
        elif kind == 1:
            tokens.insert(at, tokens[at] + " ")
        elif kind == 2:
            tokens[at], tokens[other] = tokens[other], tokens[at]
        elif kind == 3:
            tokens[at] = tokens[other]
        elif kind == 4:
            tokens.insert(at, " " + dice.choice(SPICE) + " ")
        else:
            del tokens[min(at, other):min(max(at, other), min(at, other) + 12)]
    return "".join(tokens)


def strain(text, dice):
    """What is nested deeply, bytes that are no UTF-8, ends without a newline or in the middle of something."""
    tokens = TOKEN.findall(text)
    at = dice.randrange(len(tokens))
    kind = dice.randrange(3)
    if kind == 0:
        opening, inner, closing = dice.choice(NESTED)
        depth = dice.choice(DEPTHS)
        tokens[at] = opening * depth + inner + closing * (depth - dice.choice((0, 0, 1)))
    elif kind == 1:
        tokens.insert(at, dice.choice(("", "// ", "/** ", '"')) + dice.choice(BYTES))
    else:
        tokens = tokens[:at] if dice.random() < 0.5 else tokens[:-1]
    return "".join(tokens)


def run(command, folder):
    """Status and output; status None if it took too long."""
    try:
        done = subprocess.run(command, cwd=folder, capture_output=True, timeout=TIMEOUT, check=False)
    except subprocess.TimeoutExpired:
        return None, ""
    return done.returncode, done.stderr.decode(errors="replace") + done.stdout.decode(errors="replace")


def compiler_flags(words):
    """Those of typegen's options that a compiler has too."""
    flags = []
    for i, word in enumerate(words):
        if word.startswith(("-std=", "-I", "-D", "-U", "-isystem", "-include")):
            flags += words[i:i + 2] if word in ("-I", "-D", "-U", "-isystem", "-include") else [word]
    return flags


def compile_complaint(compiler, folder, words):
    command = [*compiler, "-I.", "-Iinclude", *compiler_flags(words)]
    includes = "".join(f'#include "{word}"\n' for word in words if (folder / word).is_file())
    (folder / "headers_alone.cpp").write_text(includes)
    if run([*command, "headers_alone.cpp"], folder)[0] != 0:
        return ""  # clang takes what this compiler does not: that is told when the package is built
    for source in sorted((folder / "generated_output").rglob("*.cpp")):
        status, text = run([*command, source], folder)
        if status != 0:
            return f"{source.name} does not compile: {text[:2000]}"
    return ""


def complaint(typegen, compiler, folder, words, dice, compiled=SUCCESSES_COMPILED):
    """What is wrong with this run; empty if nothing. Second: whether typegen succeeded."""
    status, text = run([typegen, "-o", "generated_output", *words], folder)
    out = folder / "generated_output"
    if status is None:
        return f"no end after {TIMEOUT} s", False
    if status not in (0, 1):
        return f"status {status}: {text[-2000:]}", False
    if status == 1:
        if "error: " not in text:
            return f"failed without an error: {text[-500:]}", False
        return "failed, but wrote files" if out.exists() else "", False
    if not list(out.rglob("*.cpp")):
        return "succeeded, but wrote nothing", True
    return compile_complaint(compiler, folder, words) if dice.random() < compiled else "", True


def try_one(number, seed, cases, typegen, compiler):
    dice = random.Random(seed + number)
    case = dice.choice(cases)
    with tempfile.TemporaryDirectory(prefix="typegen-mutant-") as place:
        folder = pathlib.Path(place) / "case"
        shutil.copytree(case, folder, ignore=shutil.ignore_patterns("expected"))
        headers = sorted(file for file in folder.rglob("*") if file.suffix in (".hpp", ".h"))
        victim = dice.choice(headers)
        change = dice.choice((damage, damage, bend, bend, strain))
        victim.write_bytes(change(victim.read_bytes().decode("utf-8"), dice).encode("utf-8", "surrogateescape"))
        wrong, succeeded = complaint(typegen, compiler, folder, (folder / "args").read_text().splitlines(), dice)
        if wrong and os.environ.get("TYPEGEN_KEEP"):
            shutil.copytree(folder, pathlib.Path(os.environ["TYPEGEN_KEEP"]) / f"{seed + number}", dirs_exist_ok=True)
        return f"seed {seed + number} ({case.name}, {victim.name}): {wrong}" if wrong else "", succeeded


def main():
    typegen, golden, compiler = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3:]
    count, seed = int(os.environ.get("TYPEGEN_MUTANTS", "150")), int(os.environ.get("TYPEGEN_SEED", "1"))
    kinds = ("model", "typekit", "typekit_view", "typekit", "typekit_view", "diagnostics_types")
    cases = sorted(args.parent for kind in kinds for args in golden.glob(kind + "/*/args")
                   if list(args.parent.rglob("*.hpp")))
    with concurrent.futures.ThreadPoolExecutor(max_workers=os.cpu_count()) as pool:
        results = list(pool.map(lambda i: try_one(i, seed, cases, typegen, compiler), range(count)))
    wrong = [text for text, _ in results if text]
    print("\n".join(wrong))
    print(f"{count} mutants of {len(cases)} cases: {sum(ok for _, ok in results)} accepted, {len(wrong)} wrong")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
