#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""orocreate-pkg --update on random pairs of a user edit and a manifest edit: no byte of the user is lost, the second run
changes nothing, and what comes out compiles (a sample of it). Classes have a generated base, or register all themselves;
most packages have a .clang-format.

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
# None: the style is learnt. LineEnding must not change those that a file has.
STYLES = [None, "BasedOnStyle: Google", "BasedOnStyle: LLVM\nLineEnding: LF", "BasedOnStyle: Microsoft\nColumnLimit: 60",
          "BasedOnStyle: GNU", "BasedOnStyle: Mozilla\nLineEnding: CRLF", "BasedOnStyle: WebKit\nUseTab: Always",
          "BasedOnStyle: LLVM\nNamespaceIndentation: All\nMaxEmptyLinesToKeep: 0\nInsertNewlineAtEOF: true",
          "BasedOnStyle: Google\nAlignConsecutiveDeclarations: true\nSeparateDefinitionBlocks: Always",
          "BasedOnStyle: Chromium\nQualifierAlignment: Right\nInsertBraces: true", "DisableFormat: true", "IndentWidth: x"]
STUBS = pathlib.Path(__file__).resolve().parent / "stubs"


class Changed:
    """Names of what the update may touch in the files of the user."""
    def __init__(self):
        self.signatures, self.members, self.texts = set(), set(), set()


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

    def edit(self, changed, keeps_results):
        """Changes something, and notes what. With another result a body has to be changed by hand before it compiles."""
        names = list(self.operations)
        name = self.rng.choice(names) if names else None
        kind = self.rng.choice(["add", "remove", "type", "argument", "drop", "returns", "hook", "unhook", "component",
                                "doc", "port", "property"])
        if kind == "returns" and keeps_results:
            kind = "type"
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
            changed.signatures.add(name)
            changed.texts.add(name)
        elif kind == "returns":
            self.operations[name][0] = self.rng.choice(RETURNS)
            changed.signatures.add(name)
        elif kind == "hook":
            self.hooks.add(self.rng.choice(HOOKS))
        elif kind == "unhook" and self.hooks:
            self.hooks.discard(self.rng.choice(sorted(self.hooks)))
        elif kind == "component":
            self.components.append(self.fresh("Part"))
        elif kind == "doc":
            self.doc = self.fresh("Other words ")
            changed.texts.update(["level", *self.operations])
        elif kind == "port":
            self.port = self.rng.choice(["int", "double", "bool"])
            changed.members.add("level")
        else:
            self.property = self.rng.choice(["int", "double", "bool"])
            changed.members.add("gain")

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


def write_own_class(package, manifest):
    """A class as people write it without a generated base, which is what the manifest says."""
    results = {"void": "", "bool": "    return true;\n"}
    calls, declared, defined = [], [], []
    for name, (returns, arguments) in manifest.operations.items():
        texts = "".join(f'.arg("{argument}", "")' for argument, _ in arguments)
        calls.append(f'    addOperation("{name}", &Plant::{name}, this).doc("{manifest.doc}"){texts};')
        declared.append(f"    {returns} {name}(" + ", ".join(f"{kind} {argument}" for argument, kind in arguments) + ");")
        defined.append(f"{returns} Plant::{name}(" + ", ".join(f"{kind} /*{argument}*/" for argument, kind in arguments) +
                       ") {\n" + results.get(returns, "    return {};\n") + "}\n")
    hooks = []
    for hook in sorted(manifest.hooks, key=HOOKS.index):
        returns = "bool" if hook in ("configure", "start") else "void"
        hooks.append(f"    {returns} {hook}Hook() override;")
        defined.append(f"{returns} Plant::{hook}Hook() {{\n" + results[returns] + "}\n")
    lines = ["#ifndef TANK_PLANT_HPP", "#define TANK_PLANT_HPP", "", "#include <string>", "#include <vector>", "",
             "#include <rtt/RTT.hpp>", "", "namespace tank {", "", "class Plant : public RTT::TaskContext {", "public:",
             "    explicit Plant(const std::string& name);", "    ~Plant() override;", "", *declared, "", "protected:", *hooks, "",
             "private:", f"    RTT::OutputPort<{manifest.port}> level_;", f"    {manifest.property} gain_{{}};", "};", "",
             "}  // namespace tank", "", "#endif", ""]
    (package / "src").mkdir(parents=True)
    (package / "src/Plant.hpp").write_text("\n".join(lines))
    lines = ['#include "Plant.hpp"', "", "namespace tank {", "", "Plant::Plant(const std::string& name) : RTT::TaskContext(name) {",
             f'    addPort("level", level_).doc("{manifest.doc}");', '    addProperty("gain", gain_);', *calls, "}", "",
             "Plant::~Plant() { this->stopForGood(); }", "", *defined, "}  // namespace tank", ""]
    (package / "src/Plant.cpp").write_text("\n".join(lines))
    (package / "tank.xml").write_text(manifest.text())


def sources(package):
    return {str(path.relative_to(package)): path.read_bytes().decode()
            for path in sorted(package.glob("src/*")) if path.is_file()}


USER_COMMENT = re.compile(r"/\*(?!arg\d+\*/).*?\*/|//[^\r\n]*", re.S)


def without_entitled(text, changed):
    """The text without what the update may change: type and arguments of an operation whose signature changed, but not the
    user's comments between them; in classes that register themselves types of members, and doc() and arg() of calls."""
    for name in changed.signatures:
        def bare(match):
            return "".join(match.group(2, 3, 4)) + "(" + "".join(USER_COMMENT.findall(match.group(5))) + ")"
        text = re.sub(r"([\w:<>]+)(\s+)((?:Plant::)?" + name + r")(\s*)\(((?:[^()]|/\*.*?\*/)*)\)", bare, text)
    for member in changed.members:
        text = re.sub(r"(?:int|double|bool)(>?\s+" + member + r"_\b)", r"\1", text)
    for name in changed.texts:
        def silent(match):
            return re.sub(r'\s*\.(?:doc|arg)\("[^)]*"\)', "", match.group(0))
        text = re.sub(r'\badd\w+\s*\(\s*"' + name + r'"[^;]*;', silent, text)
    return text


def lost_or_mixed(before, after, changed):
    """What is wrong: a line of the user, with every byte of it, that is not there any more; or something between the lines
    that is no whole declaration or definition, as one that took the user's brace for its own."""
    rest = iter(without_entitled(after, changed).splitlines(keepends=True))
    added = ""
    for line in without_entitled(before, changed).splitlines(keepends=True):
        for other in rest:
            if line == other or (not line.endswith("\n") and line == other.rstrip("\r\n")):
                break
            added += other
        else:
            return f"this line got lost: {line!r}"
    added += "".join(rest)
    code = re.sub(r"//[^\n]*|/\*.*?\*/", "", added, flags=re.S)
    for opening, closing in ("{}", "()"):
        if code.count(opening) != code.count(closing):
            return f"what was added is torn:\n{added}"
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


def make_package(folder, manifest, program, own):
    package = pathlib.Path(folder) / "tank"
    if own:
        write_own_class(package, manifest)
        before = sources(package)
        status, _, errors = run([program, "--update", "-I", str(STUBS)], package)
        if status or sources(package) != before:
            raise Failure(f"a class that is as its manifest says is not left alone: {errors}")
        return package
    (pathlib.Path(folder) / "tank.xml").write_text(manifest.text())
    status, _, errors = run([program, "--from", "tank.xml"], folder)
    if status:
        raise Failure(errors)
    return package


def one_case(seed, program, compiler, includes, compiles):
    rng = random.Random(seed)
    own = rng.random() < 0.4
    with tempfile.TemporaryDirectory(prefix="oro_update_") as folder:
        manifest = Manifest(rng)
        package = make_package(folder, manifest, program, own)
        style = rng.choice(STYLES)
        (package / ".clang-format").unlink(missing_ok=True)
        if style:
            (package / ".clang-format").write_text(style + "\n")
        edits = rng.sample(USER_EDITS, rng.randint(1, 4))
        for edit in sorted(edits, key=USER_EDITS.index):
            edit(package, rng)
        before = sources(package)
        changed = Changed()
        for _ in range(rng.randint(1, 3)):
            manifest.edit(changed, compiles)
        (package / "tank.xml").write_text(manifest.text())
        told = f"{'own registration, ' if own else ''}style {style!r}, user edits: {[edit.__name__ for edit in edits]}"
        update = [program, "--update", "-I", str(STUBS)]
        status, _, errors = run(update, package)
        after = sources(package)
        if status:
            # What the user wrote beside an argument that goes is for the user to decide about.
            refused = "error: [OC032]" in errors and "there is a comment beside argument" in errors
            if not refused or after != before:
                raise Failure(f"{told}\n{errors}")
            return
        for name, text in before.items():
            wrong = lost_or_mixed(text, after[name], changed)
            if wrong:
                raise Failure(f"{told}\n{name}: {wrong}\n{after[name]}")
            if "\r\n" in text and re.search(r"[^\r]\n", after[name]):
                raise Failure(f"{told}\n{name}: line ends are mixed")
        status, out, errors = run(update, package)
        if status or "nothing to do" not in out or sources(package) != after:
            raise Failure(f"{told}\nthe second run: {out}{errors}")
        check_follows(package, manifest, "".join(after.values()), own, told)
        if compiles:
            # What was removed from the manifest stays, with an 'override' that does not compile any more.
            for path in package.glob("src/Plant.hpp"):
                path.write_text(path.read_bytes().decode().replace(" override", ""))
            compile_all(package, program, compiler, includes)


def check_follows(package, manifest, text, own, told):
    missing = [name for name in manifest.operations if not re.search(r"\b" + name + r"\s*\(", text)]
    if own:
        for name, (_, arguments) in manifest.operations.items():
            call = re.search(r'addOperation\s*\(\s*"' + name + r'"[^;]*;', text)
            names = re.findall(r'\.arg\s*\("(\w+)"', call.group(0)) if call else None
            doc = r'\.doc\s*\("' + manifest.doc + r'"\)'
            if names != [argument for argument, _ in arguments] or not re.search(doc, call.group(0)):
                missing.append(call.group(0) if call else f"the registration of {name}")
        for kind, member in ((f"RTT::OutputPort<{manifest.port}>", "level_"), (manifest.property, "gain_")):
            if not re.search(re.escape(kind) + r"\s+" + member, text):
                missing.append(f"{kind} {member}")
    if missing:
        raise Failure(f"{told}\n{package.name}: not as the manifest has it: {missing}\n{text}")


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
