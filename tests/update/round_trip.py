#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""orocreate-pkg --update on random pairs of a user edit and a manifest edit: no byte of the user is lost, the second run
changes nothing, and what comes out compiles (a sample of it).

usage: round_trip.py OROCREATE_PKG COMPILER INCLUDES COUNT SAMPLE [FIRST_SEED]
"""
import os
import pathlib
import random
import re
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True  # nothing is left in the source tree
from user_edits import USER_EDITS

TYPES = ["int", "double", "bool", "std::string", "const std::string&", "std::vector<double>", "unsigned int"]
RETURNS = ["void", "bool", "int", "std::string", "std::vector<double>"]
HOOKS = ["configure", "start", "update", "stop", "cleanup", "error", "exception"]
STUBS = pathlib.Path(__file__).resolve().parent / "stubs"


class Manifest:
    def __init__(self, rng):
        self.rng = rng
        self.count = 0
        self.operations = {}
        self.hooks = set(rng.sample(HOOKS, rng.randint(0, 4)))
        self.components = ["Plant"]
        self.port = rng.choice(["int", "double"])
        self.property = rng.choice(["int", "double"])
        self.doc = "First words"
        for _ in range(rng.randint(1, 4)):
            self.add_operation()

    def fresh(self, prefix):
        self.count += 1
        return f"{prefix}{self.count}"

    def argument(self):
        return (self.fresh("arg"), self.rng.choice(TYPES))

    def add_operation(self):
        arguments = [self.argument() for _ in range(self.rng.randint(0, 3))]
        items = list(self.operations.items())
        place = self.rng.randint(0, len(items))
        items.insert(place, (self.fresh("operation"), [self.rng.choice(RETURNS), arguments]))
        self.operations = dict(items)

    def edit(self):
        """Changes something; returns the names of operations whose signature changed."""
        names = list(self.operations)
        name = self.rng.choice(names) if names else None
        kind = self.rng.choice(["add", "remove", "type", "argument", "drop", "returns", "hook", "unhook", "component",
                                "doc", "port", "property"])
        if kind == "add" or (name is None and kind in ("remove", "type", "argument", "drop", "returns")):
            self.add_operation()
        elif kind == "remove":
            del self.operations[name]
        elif kind in ("type", "argument", "drop"):
            arguments = self.operations[name][1]
            if kind == "argument" or not arguments:
                arguments.insert(self.rng.randint(0, len(arguments)), self.argument())
            elif kind == "drop":
                arguments.pop(self.rng.randrange(len(arguments)))
            else:
                at = self.rng.randrange(len(arguments))
                arguments[at] = (arguments[at][0], self.rng.choice(TYPES))
            return {name}
        elif kind == "returns":
            self.operations[name][0] = self.rng.choice(RETURNS)
            return {name}
        elif kind == "hook":
            self.hooks.add(self.rng.choice(HOOKS))
        elif kind == "unhook" and self.hooks:
            self.hooks.discard(self.rng.choice(sorted(self.hooks)))
        elif kind == "component":
            self.components.append(self.fresh("Part"))
        elif kind == "doc":
            self.doc = self.fresh("Other words ")
        elif kind == "port":
            self.port = self.rng.choice(["int", "double", "bool"])
        else:
            self.property = self.rng.choice(["int", "double", "bool"])
        return set()

    def text(self):
        def xml(text):
            return text.replace("&", "&amp;").replace("<", "&lt;")
        lines = ['<package name="tank" version="1.0.0">']
        for component in self.components:
            lines.append(f'  <component class="tank::{component}">')
            if component == "Plant":
                lines.append(f'    <port name="level" direction="out" type="{self.port}"><doc>{self.doc}</doc></port>')
                lines.append(f'    <property name="gain" type="{self.property}"/>')
                for name, (returns, arguments) in self.operations.items():
                    lines.append(f'    <operation name="{name}" returns="{xml(returns)}"><doc>{self.doc}</doc>')
                    lines += [f'      <arg name="{a}" type="{xml(t)}"/>' for a, t in arguments]
                    lines.append("    </operation>")
                wanted = [f'{hook}="{"true" if hook in self.hooks else "false"}"' for hook in HOOKS]
                lines.append(f'    <hooks {" ".join(wanted)}/>')
            lines.append("  </component>")
        return "\n".join(lines + ["</package>", ""])


def sources(package):
    return {str(path.relative_to(package)): path.read_bytes().decode()
            for path in sorted(package.glob("src/*")) if path.is_file()}


def without_signatures(text, names):
    """Lines of the text; what the manifest may change in it is blanked out."""
    for name in names:
        text = re.sub(r"[\w:<>&]+(?:[ \t]*\r?\n?[ \t]*)(Plant::)?" + name + r"(\s*)\([^)]*\)", r"\1" + name + "()", text)
    return text.split("\n")


def is_kept(before, after, names):
    rest = iter(without_signatures(after, names))
    for line in without_signatures(before, names):
        if not any(line == other for other in rest):
            return line
    return None


class Failure(Exception):
    pass


def run(arguments, where):
    result = subprocess.run(arguments, cwd=where, capture_output=True, text=True, timeout=120, check=False)
    return result.returncode, result.stdout, result.stderr


def compile_all(package, program, compiler, includes):
    status, _, errors = run([program, "--generate", "tank.xml", "--output", "generated"], package)
    if status:
        raise Failure("--generate: " + errors)
    flags = ["-std=c++17", "-fsyntax-only", "-DRTT_COMPONENT", "-DOROCOS_TARGET=gnulinux", "-Igenerated", "-Isrc"]
    for source in sorted(package.glob("src/*.cpp")):
        status, _, errors = run([compiler, *flags, *["-isystem" + d for d in includes], str(source)], package)
        if status:
            raise Failure(f"{source.name} does not compile:\n{errors}")


def one_case(seed, program, compiler, includes, compiles):
    rng = random.Random(seed)
    with tempfile.TemporaryDirectory(prefix="oro_update_") as folder:
        manifest = Manifest(rng)
        (pathlib.Path(folder) / "tank.xml").write_text(manifest.text())
        status, _, errors = run([program, "--from", "tank.xml"], folder)
        if status:
            raise Failure(errors)
        package = pathlib.Path(folder) / "tank"
        edits = rng.sample(USER_EDITS, rng.randint(1, 4))
        for edit in sorted(edits, key=USER_EDITS.index):
            edit(package, rng)
        before = sources(package)
        changed = set()
        for _ in range(rng.randint(1, 3)):
            changed |= manifest.edit()
        (package / "tank.xml").write_text(manifest.text())
        told = f"user edits: {[edit.__name__ for edit in edits]}"
        update = [program, "--update", "-I", str(STUBS)]
        status, _, errors = run(update, package)
        if status:
            raise Failure(f"{told}\n{errors}")
        after = sources(package)
        for name, text in before.items():
            lost = is_kept(text, after[name], changed)
            if lost is not None:
                raise Failure(f"{told}\n{name}: this line got lost: {lost!r}\n{after[name]}")
            if "\r\n" in text and re.search(r"[^\r]\n", after[name]):
                raise Failure(f"{told}\n{name}: line ends are mixed")
        status, out, errors = run(update, package)
        if status or "nothing to do" not in out or sources(package) != after:
            raise Failure(f"{told}\nthe second run: {out}{errors}")
        missing = [name for name in manifest.operations if not re.search(r"\b" + name + r"\s*\(", "".join(after.values()))]
        if missing:
            raise Failure(f"{told}\nnot written: {missing}")
        if compiles:
            # What was removed from the manifest stays, with an 'override' that does not compile any more.
            for path in package.glob("src/Plant.hpp"):
                path.write_text(path.read_bytes().decode().replace(" override", ""))
            compile_all(package, program, compiler, includes)


def main():
    program, compiler, includes, count, sample = sys.argv[1:6]
    first = int(sys.argv[6]) if len(sys.argv) > 6 else random.randrange(10 ** 6)
    print(f"seeds {first} to {first + int(count) - 1}", flush=True)
    failed = []
    for i in range(int(count)):
        seed = first + i
        try:
            one_case(seed, os.path.abspath(program), compiler, [os.path.abspath(one) for one in includes.split(":")], i < int(sample))
        except Failure as failure:
            failed.append(seed)
            print(f"seed {seed}: {failure}", flush=True)
    print(f"{int(count) - len(failed)} of {count} pairs passed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
