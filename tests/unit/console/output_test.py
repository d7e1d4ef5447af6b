# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""What components write while a line is typed: it stands above the line."""
from deployer_case import PROMPT, DeployerCase, main

CTRL_R, LEFT, TAB = "\x12", "\x1b[D", "\t"


class OutputOfOthers(DeployerCase):
    def talking(self, how, text, *arguments, **environment):
        """A console whose talker is going to write that."""
        program = self.open(*arguments, **environment)
        program.type('import("talking"); loadComponent("talker", "Talker"); talker.start()', PROMPT)
        program.type(f'var SendHandle h; h = talker.talk.send("{how}", "{text}");', PROMPT)
        return program

    def go(self):
        (self.directory / "go").touch()

    def done(self, program):
        program.wait(lambda: not (self.directory / "go").exists(), "the end of the talk")

    def type_and_talk(self, program, keys, typed, expected):
        """Types the keys, lets the talker write, and waits for the rows of the screen from the prompt on."""
        before = program.screen().count("\n")
        program.send(keys)
        program.wait(lambda: program.screen().split("\n")[before:] == typed, f"the line {typed}")
        self.go()
        program.wait(lambda: program.screen().split("\n")[before:] == expected, "\n".join(expected))
        self.done(program)

    def test_a_log_line_stands_above_the_line_that_is_typed(self):
        program = self.talking("log", "something is wrong")
        before = program.screen().count("\n")
        program.send("20 + ")
        program.wait_for(PROMPT + "20 +")
        self.go()
        program.wait(lambda: program.screen().count("\n") > before, "the log line")
        program.wait(lambda: program.screen().endswith("\n" + PROMPT + "20 +"), "the line")
        shown = program.screen().split("\n")[before:]
        self.assertEqual(2, len(shown), shown)
        self.assertRegex(shown[0], r"^\d+\.\d+ .*ERROR.*something is wrong$")
        program.send("3\r")
        program.wait_for(PROMPT + "20 + 3\n = 23\n" + PROMPT.rstrip())

    def test_so_does_what_is_printed(self):
        for how in "out", "err":
            program = self.talking(how, "hello")
            self.type_and_talk(program, "20 + ", [PROMPT + "20 +"], ["hello and 5 letters", PROMPT + "20 +"])

    def test_the_cursor_stays_where_it_was(self):
        program = self.talking("out", "hello")
        self.type_and_talk(program, "20 + 3" + LEFT * 5, [PROMPT + "20 + 3"], ["hello and 5 letters", PROMPT + "20 + 3"])
        program.send("1")
        program.wait_for(PROMPT + "210 + 3")
        self.assertEqual(" = 213", program.type("", PROMPT))

    def test_lines_of_several_rows_are_left_whole(self):
        line = PROMPT + "1" * 100 + "2" * 100
        rows = [line[:100], line[100:200], line[200:]]
        for left in 0, 50, 150:
            program = self.talking("out", "hello")
            self.type_and_talk(program, line[len(PROMPT):] + LEFT * left, rows, ["hello and 5 letters", *rows])

    def test_colours_of_the_prompt_take_no_room(self):
        program = self.talking("out", "hello", NO_COLOR="")
        row = PROMPT + "1" * 85
        self.type_and_talk(program, "1" * 85, [row], ["hello and 5 letters", row])

    def test_text_without_an_end_of_line_goes_on_where_it_ended(self):
        program = self.talking("letters", "one after the other")
        self.type_and_talk(program, "20 + ", [PROMPT + "20 +"], ["one after the other", PROMPT + "20 +"])
        self.assertEqual(" = 23", program.type("3", PROMPT))

    def test_text_without_an_end_of_line_stands_before_the_next_prompt(self):
        program = self.talking("begin", "no end")
        self.go()
        program.send("h.collect()\r")
        program.wait_for(" = SendSuccess\n" + PROMPT.rstrip())
        self.assertIn("no end", program.screen())

    def test_many_lines_and_many_keys(self):
        program = self.talking("flood", "number")
        before = program.screen().count("\n")
        self.go()
        for key in "100 + 20 + 3":
            program.send(key)
            program.read(0.005)
        self.done(program)
        program.wait(lambda: program.screen().endswith("\n" + PROMPT + "100 + 20 + 3"), "the line")
        self.assertEqual([f"number {i}" for i in range(300)] + [PROMPT + "100 + 20 + 3"],
                         program.screen().split("\n")[before:])
        self.assertEqual(" = 123", program.type("", PROMPT))

    def test_during_a_search(self):
        program = self.talking("out", "hello")
        program.type("20 + 3", PROMPT)
        self.type_and_talk(program, CTRL_R + "20", [PROMPT + "20 + 3", "bck:20"],
                           ["hello and 5 letters", PROMPT + "20 + 3", "bck:20"])
        program.send("\r")
        program.wait(lambda: program.screen().count(" = 23") == 2, "the answer")

    def test_nothing_is_lost_when_the_process_dies(self):
        program = self.talking("die", "last words")
        program.send("20 + ")
        program.wait_for(PROMPT + "20 +")
        self.go()
        self.assertEqual(7, program.end())
        self.assertIn("\nlast words\n", program.screen() + "\n")

    def test_a_child_process_leaves_the_line_alone(self):
        program = self.talking("fork", "hello")
        program.send("20 +")  # once the last letter is there nothing is left to draw
        program.wait_for(PROMPT + "20 +")
        self.go()
        self.done(program)
        program.wait_for(PROMPT + "20 +hello\n")  # with its end of line, which comes for itself
        self.assertEqual(" = 23", program.type("3", PROMPT))

    def test_a_terminal_that_cannot_erase_shows_it_below(self):
        program = self.talking("out", "hello", TERM="dumb")
        program.send("20 + ")
        program.wait_for("20 +")
        self.go()
        program.wait_for("hello and 5 letters\n")
        program.send("3\r")
        program.wait_for(" = 23")

    def test_without_the_log_on_the_console_nothing_disturbs(self):
        program = self.talking("log", "something is wrong", "--no-consolelog")
        program.send("20 +")
        program.wait_for(PROMPT + "20 +")
        before = len(program.written)
        self.go()
        self.done(program)
        program.read(0.2)
        self.assertEqual("", program.written[before:])
        self.assertEqual(" = 23", program.type(" 3", PROMPT))

    def test_without_a_terminal_it_is_only_written(self):
        (self.directory / "go").touch()
        out, err = self.run_with('import("talking"); loadComponent("talker", "Talker"); talker.start()\n'
                                 'talker.talk("out", "hello")\n')
        self.assertEqual(" = true\nhello and 5 letters\n = (void)\n", out)
        self.assertEqual("", err)


if __name__ == "__main__":
    main()
