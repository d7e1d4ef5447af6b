#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""The grammar for editors: JSON whose patterns compile, which knows all words of the parser and colours samples as expected.

Usage: text_mate_test.py <grammar> <parse_tokens.cpp>
"""
import json
import pathlib
import re
import sys
import unittest

GRAMMAR = json.loads(pathlib.Path(sys.argv[1]).read_text(encoding="utf-8"))
PARSER = pathlib.Path(sys.argv[2]).read_text(encoding="utf-8")


def rules(patterns):
    """The patterns with their includes resolved."""
    for rule in patterns:
        if "include" in rule:
            yield from rules(GRAMMAR["repository"][rule["include"][1:]]["patterns"])
        else:
            yield rule


def first_match(patterns, text, at):
    """(match, rule) of the leftmost match; of several, the first rule."""
    found = None
    for rule in rules(patterns):
        match = re.compile(rule.get("match") or rule["begin"], re.MULTILINE).search(text, at)
        if match and (found is None or match.start() < found[0].start()):
            found = (match, rule)
    return found


def capture_scopes(match, rule):
    if "captures" not in rule:
        return [(match.group(), rule["name"])]
    return [(match.group(int(n)), scope["name"]) for n, scope in sorted(rule["captures"].items()) if match.group(int(n))]


def block_end(rule, text, at):
    """Where the end of a begin/end rule is; its inner patterns are stepped over."""
    end = re.compile(rule["end"], re.MULTILINE)
    while True:
        stop = end.search(text, at)
        inner = first_match(rule.get("patterns", []), text, at)
        if stop and inner and inner[0].start() < stop.start():
            at = inner[0].end()
        else:
            return stop.end() if stop else len(text)


def scopes(text):
    """(letters, scope without .ops) of all that has one, in order."""
    result, at = [], 0
    while True:
        found = first_match(GRAMMAR["patterns"], text, at)
        if found is None:
            return result
        match, rule = found
        if "begin" in rule:
            at = block_end(rule, text, match.end())
            result.append((text[match.start():at], rule["name"][:-4]))
        else:
            at = max(match.end(), match.start() + 1)
            result += [(letters, scope[:-4]) for letters, scope in capture_scopes(match, rule)]


def scope_of(text, letters):
    return dict(scopes(text)).get(letters)


class TextMate(unittest.TestCase):
    def test_is_found_by_editors(self):
        self.assertEqual(GRAMMAR["scopeName"], "source.ops")
        self.assertEqual(GRAMMAR["fileTypes"], ["ops", "osd"])

    def test_patterns_compile_and_have_scopes(self):
        for rule in [r for group in GRAMMAR["repository"].values() for r in rules(group["patterns"])]:
            for key in ("match", "begin", "end"):
                re.compile(rule.get(key, ""))
            names = [rule.get("name")] + [c["name"] for c in rule.get("captures", {}).values()]
            for name in filter(None, names):
                self.assertTrue(name.endswith(".ops"), name)

    def test_knows_all_reserved_words(self):
        words = re.findall(r'"(\w+)"', re.search(r"kReserved\[\] = \{(.*?)\}", PARSER, re.DOTALL).group(1))
        self.assertEqual(len(words), 29)
        for word in words:
            self.assertNotIn(scope_of(f"{word} ;", word), (None, "variable.other"), word)

    def test_statements(self):
        self.assertEqual(scopes("var /a/B[] x = f(1, 0xFF) // c"), [
            ("var", "storage.type.declaration"), ("/a/B[]", "entity.name.type"), ("x", "variable.other"),
            ("=", "keyword.operator"), ("f", "entity.name.function.call"), ("1", "constant.numeric.integer"),
            (",", "punctuation.separator"), ("0xFF", "constant.numeric.hex"), ("// c", "comment.line.double-slash")])
        self.assertEqual(scopes("if a && !b then x.y[1.5] = 10ms"), [
            ("if", "keyword.control"), ("a", "variable.other"), ("&&", "keyword.operator"), ("!", "keyword.operator"),
            ("b", "variable.other"), ("then", "keyword.control"), ("x", "variable.other"), (".", "punctuation.separator"),
            ("y", "variable.other"), ("1.5", "constant.numeric.float"), ("=", "keyword.operator"),
            ("10ms", "constant.numeric.integer")])

    def test_comments_and_texts(self):
        self.assertEqual(scope_of("a # if \"b\"\nc", "# if \"b\""), "comment.line.number-sign")
        self.assertEqual(scope_of("a /* if\n else */ b", "/* if\n else */"), "comment.block")
        self.assertEqual(scope_of(r'f("a \"b\" # c \033[0m")', r'"a \"b\" # c \033[0m"'), "string.quoted.double")
        self.assertEqual(scope_of("'\\'' + 1", "'\\''"), "string.quoted.single")
        self.assertEqual(scope_of("f(\"open\nif a", "if"), "keyword.control")

    def test_definitions(self):
        self.assertEqual(scopes("export double f(void) {")[0], ("export", "storage.modifier"))
        self.assertEqual(scopes("program p {"), [("program", "storage.type.definition"), ("p", "entity.name.function")])
        self.assertEqual(scopes("initial state A {"), [
            ("initial", "storage.modifier"), ("state", "storage.type.state"), ("A", "entity.name.type.state")])
        self.assertEqual(scopes("RootMachine T m"), [
            ("RootMachine", "storage.type.machine"), ("T", "entity.name.type"), ("m", "variable.other")])
        self.assertEqual(scope_of("entry {", "entry"), "keyword.control.state")
        self.assertEqual(scope_of("transition ev(x) select B", "select"), "keyword.control.state")

    def test_keywords_of_other_places_are_names(self):
        self.assertEqual(scope_of("run = 1", "run"), "variable.other")
        self.assertEqual(scope_of("program.start()", "program"), "variable.other")
        self.assertEqual(scope_of("a.done", "done"), "variable.other")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
