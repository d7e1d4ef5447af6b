# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""What users do to their classes between two changes of the manifest."""
import re


def change(path, function):
    text = path.read_bytes().decode()
    path.write_bytes(function(text).encode())


def header(package):
    return package / "src/Plant.hpp"


def source(package):
    return package / "src/Plant.cpp"


def add_include(package, _):
    change(source(package), lambda text: text.replace('#include "Plant.hpp"', '#include "Plant.hpp"\n\n#include <vector>  // keep'))


def add_helper(package, _):
    change(header(package), lambda text: text.replace("    ~Plant() override;",
           "    ~Plant() override;\n\n    /* keep { this */ int helper(int x) const { return x; }  // keep }\n"
           "                                                             // and this"))


def comment_functions(package, rng):
    def comment(text):
        lines = []
        for line in text.split("\n"):
            if re.match(r"\S.*\) \{$", line) and rng.random() < 0.6:
                lines += ["// Words of the user: }", "/* more {", "   of them */"]
            lines.append(line)
        return "\n".join(lines)
    change(source(package), comment)


def fill_bodies(package, rng):
    strange = ['    const char* text = "}) { // /*"; (void)text;  /* } */', '    auto raw = R"x(} ") {\n#if )x"; (void)raw;',
               "    char quote = '{'; (void)quote;  // }", "#if 0\n    } this is no code {\n#endif"]

    def fill(text):
        return re.sub(r"(\n\S[^\n]*\) \{\n)", lambda m: m.group(1) + rng.choice(strange) + "\n", text)
    change(source(package), fill)


def name_arguments(package, _):
    change(source(package), lambda text: re.sub(r"/\*(arg\d+)\*/", r"\1", text))


def add_conditionals(package, _):
    change(header(package), lambda text: text.replace("    ~Plant() override;",
           "    ~Plant() override;\n#ifdef TANK_EXTRA\n    void extra();\n#endif\n#if 1\n    void always() {}\n#endif"))
    change(source(package), lambda text: text.replace("Plant::~Plant() { this->stopForGood(); }",
           "Plant::~Plant() { this->stopForGood(); }\n#ifdef TANK_EXTRA\nvoid Plant::extra() {\n}\n#endif"))


def move_definition(package, rng):
    text = source(package).read_bytes().decode()
    found = list(re.finditer(r"\n\n(\S[^\n]*Plant::\w+\([^\n]*\) \{\n(?:.*?\n)?\}\n)", text, re.S))
    if not found:
        return
    one = rng.choice(found)
    source(package).write_bytes((text[:one.start(1) - 1] + text[one.end(1):]).encode())
    (package / "src/Plant_more.cpp").write_bytes(
        ('#include "Plant.hpp"\n\nnamespace tank {\n\n' + one.group(1) + "\n}\n").encode())


def space_before_brackets(package, _):
    for path in package.glob("src/Plant*"):
        change(path, lambda text: re.sub(r"\b(operation\d+|\w+Hook)\(", r"\1 (", text))


def break_arguments(package, _):
    for path in package.glob("src/Plant*"):
        change(path, lambda text: re.sub(r"(arg\d+(?:\*/)?), ", r"\1,\n        ", text))


def comment_arguments(package, rng):
    def comment(text):
        return re.sub(r"(, )(?=(?:const )?[\w:<>]+&? (?:/\*)?arg\d)",
                      lambda m: rng.choice([", /* mine */ ", " /* mine */, ", ",  // mine\n        ", ", "]), text)
    for path in package.glob("src/Plant*"):
        change(path, comment)


def break_calls(package, _):
    change(source(package), lambda text: re.sub(r"\)\.(doc|arg)\(", r")\n        .\1(", text))


def braces_below(package, _):
    for path in package.glob("src/Plant*.cpp"):
        change(path, lambda text: re.sub(r"\) \{\n", ")\n{\n", text))


def tabs(package, _):
    for path in package.glob("src/Plant*"):
        change(path, lambda text: re.sub(r"(?m)^    ", "\t", text))


def carriage_returns(package, _):
    for path in package.glob("src/Plant*"):
        change(path, lambda text: text.replace("\r\n", "\n").replace("\n", "\r\n"))


def no_last_line_end(package, _):
    for path in package.glob("src/Plant*"):
        change(path, lambda text: text.rstrip("\r\n"))


# In the order in which they are made: those that look for the scaffold's layout come first.
USER_EDITS = [add_include, add_helper, comment_functions, fill_bodies, name_arguments, add_conditionals, move_definition,
              space_before_brackets, comment_arguments, break_arguments, break_calls, braces_below, tabs, carriage_returns, no_last_line_end]
