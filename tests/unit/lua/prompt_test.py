# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""rttlua on a terminal: test.py RTTLUA COMPONENTS"""
import os
import signal
import termios

from lua_case import MORE_PROMPT, PROMPT, LuaCase, main

UP, CTRL_C, CTRL_D, CTRL_R, TAB = "\x1b[A", "\x03", "\x04", "\x12", "\t"


class Prompt(LuaCase):
    def test_tells_versions_and_executes(self):
        program = self.open()
        self.assertRegex(program.screen(), r"\AOroforge \d+\.\d+\.\d+, Lua 5\.1\.\d, target \w+\nTAB completes, .*\n> \Z"
                         .replace("> ", ">"))
        self.assertEqual("5", program.type("print(2 + 3)", PROMPT))
        self.assertEqual("1text", program.type("=1, 'text'", PROMPT))  # with a tab
        self.assertEqual("7", program.type("return 7", PROMPT))
        self.assertEqual("", program.type("x = 1", PROMPT))
        self.assertEqual("", program.type("", PROMPT))
        self.assertEqual("lua", program.type("=rtt.getTC():getName()", PROMPT))

    def test_goes_on_with_statements_that_are_not_complete(self):
        program = self.open()
        program.type("for i = 1, 2 do", MORE_PROMPT)
        program.type("print(i)", MORE_PROMPT)
        self.assertEqual("1\n2", program.type("end", PROMPT))
        program.type("_PROMPT, _PROMPT2 = 'lua: ', 'more: '", "lua: ")
        program.type("=1 +", "more: ")
        self.assertEqual("3", program.type("2", "lua: "))

    def test_errors_have_a_traceback(self):
        program = self.open()
        self.assertEqual("stdin:1: broken\nstack traceback:\n[C]: in function 'error'\nstdin:1: in main chunk\n[C]: ?",
                         program.type("error('broken')", PROMPT))  # without the tabs
        self.assertEqual("stdin:1: unexpected symbol near '='", program.type("x = = 1", PROMPT))

    def test_ends_at_ctrl_d(self):
        program = self.open()
        self.assertFalse(self.is_usual(program))
        program.send(CTRL_D)
        self.assertEqual(0, program.end())
        self.assertTrue(self.is_usual(program))

    def is_usual(self, program):
        """Of the terminal: that it edits and echoes lines itself."""
        usual = termios.ICANON | termios.ECHO | termios.ISIG
        return termios.tcgetattr(program.terminal)[3] & usual == usual

    def test_ends_within_a_statement(self):
        program = self.open()
        program.type("for i = 1, 2 do", MORE_PROMPT)
        program.send(CTRL_D)
        self.assertEqual(0, program.end())

    def test_ends_with_the_status_of_os_exit(self):
        for statement, status in ("os.exit(5)", 5), ("pcall(os.exit, 6) print('never')", 6), ("os.exit()", 0):
            with self.subTest(statement):
                program = self.open()
                program.send(statement + "\r")
                self.assertEqual(status, program.end())
                self.assertNotIn("\nnever", program.screen())

    def test_ends_at_signals(self):
        for number in signal.SIGTERM, signal.SIGHUP:
            with self.subTest(number):
                program = self.open()
                os.kill(program.pid, number)
                self.assertEqual(0, program.end())

    def test_comes_after_a_script(self):
        self.write("script.lua", "x = ... print('in the script')")
        program = self.open("-i", "script.lua", "word")
        self.assertIn("in the script\n", program.screen())
        self.assertEqual("word", program.type("=x", PROMPT))

    def test_lua_code_reads_the_terminal(self):
        program = self.open()
        program.send("x = io.read() print('got ' .. x)\r")
        program.wait_for_execution()
        program.send("typed\r")
        program.wait_for("\ntyped\ngot typed\n")

    def test_restores_the_terminal_in_a_crash(self):
        program = self.open()
        program.wait(lambda: not termios.tcgetattr(program.terminal)[3] & termios.ICANON, "the mode of the prompt")
        os.kill(program.pid, signal.SIGABRT)
        self.assertEqual(-signal.SIGABRT, program.end())
        self.assertTrue(self.is_usual(program))

    def test_stays_below_the_log(self):
        program = self.open()
        program.send("rtt.logl('Error', 'a line of the log')\r")
        program.wait_for("[rttlua] a line of the log\n>")
        self.assertEqual("2", program.type("=2", PROMPT))


class CtrlC(LuaCase):
    def stop(self, program, line):
        """What is shown after Ctrl-C up to the next prompt."""
        rows = program.screen().count("\n") + 1
        program.send(line + "\r")
        program.wait(lambda: program.screen().count("\n") >= rows, "the execution")
        program.wait_for_execution()
        program.send(CTRL_C)
        program.wait(lambda: program.screen().count("\n") > rows and program.screen().endswith("\n" + PROMPT.rstrip()),
                     "the prompt")
        return program.screen().split("\n", rows)[rows]

    def test_drops_the_line(self):
        program = self.open()
        program.send("x = 1" + CTRL_C)
        program.wait_for("x = 1^C\n>")
        program.type("for i = 1, 2 do", MORE_PROMPT)
        program.send(CTRL_C)
        program.wait_for_prompt(PROMPT)
        self.assertEqual("nil", program.type("=x", PROMPT))

    def test_interrupts(self):
        program = self.open()
        for line in ("while true do end", "while true do pcall(function() while true do end end) end",
                     "while true do pcall(error, 1) end", "rtt.sleep(100)", "rtt.sleep(100, 0)",
                     "while true do pcall(rtt.sleep, 100) end",
                     "while true do coroutine.resume(coroutine.create(function() while true do end end)) end",
                     "while true do coroutine.wrap(function() while true do end end)() end",
                     "local t = setmetatable({}, {__index = function() while true do end end}) print(t.x)",
                     "table.sort({3, 2, 1}, function() while true do end end)"):
            with self.subTest(line):
                self.assertRegex(self.stop(program, line), r"\A\^C\n(stdin:1: )*interrupted\nstack traceback:\n")
                self.assertEqual("2", program.type("=1 + 1", PROMPT))

    def test_says_where(self):
        self.assertTrue(self.stop(self.open(), "while true do end").startswith("^C\nstdin:1: interrupted\n"))

    def test_interrupts_waiting_for_an_operation(self):
        program = self.open()
        program.type("d = rtt.getTC():getPeer('Deployer') d:import('ocl')", PROMPT)
        program.type("d:loadComponent('busy', 'OCL::LuaComponent') b = d:getPeer('busy')", PROMPT)
        shown = self.stop(program, "b:exec_str('rtt.sleep(3)')")
        self.assertRegex(shown, r"\A\^C\nstdin:1: .*interrupted while waiting for operation 'exec_str'")
        self.assertEqual("2", program.type("=1 + 1", PROMPT))

    def test_interrupts_a_script(self):
        self.write("endless.lua", "io.write('begun\\n') io.flush()\nwhile true do end\n")
        started = self.start("endless.lua")
        self.assertEqual("begun\n", started.stdout.readline())
        started.send_signal(signal.SIGINT)
        out, err = started.communicate(timeout=20)
        self.assertEqual(1, started.returncode)
        self.assertIn("rttlua: endless.lua:2: interrupted\n", err)


class Completion(LuaCase):
    def assert_completed(self, program, typed, line):
        program.send(typed + TAB)
        program.wait(lambda: program.screen().split("\n")[-1] == f"{PROMPT}{line}".rstrip(), repr(line))
        program.send(CTRL_C)
        program.wait_for_prompt(PROMPT)

    def test_completes(self):
        program = self.open()
        program.type("tc = rtt.getTC() word = {first = {inner = 1}} cp = rtt.Variable.new('ConnPolicy')", PROMPT)
        program.type("tc:addProperty(rtt.Property.new('double', 'gain_of_it'))", PROMPT)
        program.type("tc:addPort(rtt.InputPort.new('double', 'input_of_it'))", PROMPT)
        for typed, line in (("collectg", "collectgarbage("), ("1 + coro", "1 + coroutine"), ("func", "function"),
                            ("string.rev", "string.reverse("), ("word.fi", "word.first"), ("x=word.first.in", "x=word.first.inner"),
                            ("('x'..word.fi", "('x'..word.first"), ("tc:getNa", "tc:getName("), ("tc:exec_f", "tc:exec_file("),
                            ("cp.name", "cp.name_id"), ("cp:getMemberN", "cp:getMemberNames("), ('tc:getPeer("Dep', 'tc:getPeer("Deployer"'),
                            ("tc:getProperty('gai", "tc:getProperty('gain_of_it'"), ("tc:getPort('inp", "tc:getPort('input_of_it'"),
                            ("rtt.Variable.new('ConnPol", "rtt.Variable.new('ConnPolicy'"), ("tc:getOperation('exec_s", "tc:getOperation('exec_str'")):
            with self.subTest(typed):
                self.assert_completed(program, typed, line)

    def test_lists_what_is_possible(self):
        program = self.open()
        program.send("string.re" + TAB)
        program.wait_for("rep")
        program.wait_for("reverse")

    def test_is_harmless(self):
        program = self.open()
        program.type("bad = setmetatable({}, {__index = function() error('called') end})", PROMPT)
        for typed in "bad.x", "nil.x", "f().x", "none.x", "1..2", "'text", "x[1].y", "a.b.c.d:e", ":", ".", "tc:getPeer(":
            with self.subTest(typed):
                self.assert_completed(program, typed, typed)


class Lines(LuaCase):
    def test_come_back(self):
        program = self.open()
        program.type("x = 12", PROMPT)
        program.send(UP + "3\r")
        program.wait_for("x = 123\n>")
        self.assertEqual("123", program.type("=x", PROMPT))
        program.send(CTRL_D)
        program.end()
        self.assertEqual("x = 12\nx = 123\n=x\n", (self.home / ".rttlua_history").read_text())
        later = self.open()
        later.send(CTRL_R + "12")
        later.wait_for("x = 123")

    def test_are_kept_in_a_file_of_ones_own(self):
        program = self.open(ORO_LUA_HISTFILE="~/mine")
        program.type("x = 1", PROMPT)
        self.assertEqual("x = 1\n", (self.home / "mine").read_text())


if __name__ == "__main__":
    main()
