# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""rttlua does what Debian's interpreter does: test.py RTTLUA COMPONENTS LUA RTTLUA-TLSF"""
import pathlib
import re

from lua_case import MORE, RTTLUA, LuaCase, main

LUA, TLSF = MORE
PROGRAMS = sorted((pathlib.Path(__file__).parent / "language").glob("*.lua"))
INPUT = "first line\nabcdef 12 rest\nmore\nand more"


def plain(text):
    """Without the name of the program."""
    for program in LUA, RTTLUA, TLSF:
        text = text.replace(program, "PROGRAM")
    return re.sub(r"^(rttlua|rttlua-tlsf|PROGRAM): ", "", text, flags=re.MULTILINE)


class Same(LuaCase):
    def assert_same(self, *words, text="", program=RTTLUA, **environment):
        status, *shown = self.run_lua(*words, text=text, program=LUA, **environment)
        found = self.run_lua(*words, text=text, program=program, **environment)
        self.assertEqual([plain(each) for each in shown], [plain(each) for each in found[1:]])
        # Debian's says nothing of a failure if there are no words.
        self.assertEqual(status or int(not words and shown[1].startswith(LUA + ":")), found[0])
        return found


class Programs(Same):
    def test_there_are_enough(self):
        self.assertGreaterEqual(len(PROGRAMS), 25)

    def test_do_the_same(self):
        for file in PROGRAMS:
            for program in [RTTLUA, TLSF] if file.name != "stack_overflow.lua" else [RTTLUA]:  # its memory has a limit
                with self.subTest(file.name, program=program):
                    (self.directory / file.name).write_text(file.read_text())
                    self.assert_same(file.name, "one", "two words", text=INPUT, program=program)

    def test_do_the_same_from_standard_input(self):
        for file in PROGRAMS:
            with self.subTest(file.name):
                self.assert_same(text=file.read_text())
                self.assert_same("-", "one", "two", text=file.read_text())


class CommandLine(Same):
    def setUp(self):
        super().setUp()
        self.write("show.lua", "print('show', ...) for i = -5, 5 do io.write(tostring(arg and arg[i] or nil), ' ') end print()")
        self.write("mod.lua", "local name = ... print('module', name) loaded = true return {value = 3}")
        self.write("bad.lua", "\nerror('bad')")
        self.write("-x", "print('minus x')")

    def test_words(self):
        for words in (["show.lua"], ["show.lua", "a", "-e", "b c"], ["-e", "x = 1", "show.lua", "a"], ["--", "show.lua", "a"],
                      ["-e", "x = 1", "-e", "print(x, arg)"], ["-eprint(3)"], ["-e", "print(...)"], ["--", "-x"],
                      ["-l", "mod", "-e", "print(loaded, mod)"], ["-lmod", "-e", "print(package.loaded.mod.value)"],
                      ["-lmod", "show.lua"], ["show.lua", "--", "a"], ["-e", "os.exit(3)"], ["-e", "os.exit()"],
                      ["-e", "io.write('x') os.exit(0)"], ["-e", "pcall(os.exit, 4) print('never')"], ["-e", ""]):
            with self.subTest(words):
                self.assert_same(*words)

    def test_errors(self):
        for words in (["none.lua"], ["bad.lua"], ["-e", "error('x')"], ["-e", "x ="], ["-e", "os.exit(true)"],
                      ["-e", "error('x')", "show.lua"], ["bad.lua", "-i"], ["-i", "bad.lua"][1:], [""],
                      ["-e", "error('no place', 0)"], ["-e", "local function f() error('up', 2) end f()"]):
            with self.subTest(words):
                self.assertEqual(1, self.assert_same(*words)[0])

    def test_a_module_that_is_not_there(self):
        status, out, err = self.run_lua("-l", "no.such", "show.lua")
        self.assertEqual((1, ""), (status, out))
        self.assertTrue(err.startswith("rttlua: module 'no.such' not found:\n"), err)

    def test_options_that_are_not_there(self):
        for words, reason in (["-x"], "there is no option '-x'"), (["-i-"], "there is no option '-i-'"), \
                (["-e"], "option '-e' takes Lua code"), (["-l"], "option '-l' takes the name of a module"):
            with self.subTest(words):
                self.assertEqual(1, self.run_lua(*words, program=LUA)[0])
                status, out, err = self.run_lua(*words)
                self.assertEqual((1, ""), (status, out))
                self.assertTrue(err.startswith(f"rttlua: {reason}\nusage: rttlua [options] [script [arguments]]\n"), err)

    def test_versions(self):
        for words, output in (["-v"], ""), (["-v", "-e", "print(1)"], "1\n"):
            status, out, err = self.run_lua(*words)
            self.assertEqual((0, output), (status, out))
            self.assertRegex(err, r"\AOroforge \d+\.\d+\.\d+, Lua 5\.1\.\d, target \w+\n\Z")

    def test_init(self):
        self.write("init.lua", "print('init file', arg)")
        for init in "print('init', ...) x = 5", "@init.lua", "", "error('in init')", "@none.lua", "@bad.lua", "x = = 1":
            with self.subTest(init):
                self.assert_same("-e", "print(x)", LUA_INIT=init)

    def test_standard_input(self):
        for text in "", "print(1)", "#!/usr/bin/lua\nprint(debug.traceback('x'))\nerror('third line')", "#only", "x =", \
                "print(io.read())", "print((...))\nos.exit(9)":
            with self.subTest(text):
                self.assert_same(text=text)
                self.assert_same("-", "a", text=text)

    def test_compiled_chunks(self):
        self.assertEqual(0, self.run_lua("-e", "io.open('c.out', 'wb'):write(string.dump(loadfile('show.lua')))")[0])
        self.assert_same("c.out", "a")

    def test_interactive_without_a_terminal(self):
        for text in ("x = 1\n=x, 2\nfor i = 1, 2 do\nprint(i)\nend\nreturn 5\nx = = 1\nerror('q')\nprint 'still here'\n",
                     "print('open", "_PROMPT, _PROMPT2 = 'a ', 'b '\nx =\n3\n",
                     "print = nil\n=1\n", "os.exit(6)\nx = 1\n"):
            with self.subTest(text):
                status, out, err = self.run_lua("-i", text=text)
                expected = self.run_lua("-i", text=text, program=LUA)
                self.assertEqual(expected[0], status)
                # Debian's shows what it reads.
                lines = text.split("\n")
                shown = "\n".join(line for line in re.sub(r"(?m)^((> |>> |a |b )+)", "", expected[1]).split("\n")
                                  if line not in lines)
                self.assertEqual(shown.split(), re.sub(r"(?m)^((> |>> |a |b )+)", "", out).split(), err)

    def test_interactive_code_reads_the_next_line(self):
        self.assertEqual("> > next line\n> \n", self.run_lua("-i", text="x = io.read()\nnext line\n=x\n")[1])


if __name__ == "__main__":
    main()
