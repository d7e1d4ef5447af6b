# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""The deployer's console on a terminal."""
import os
import re
import signal

from deployer_case import PROMPT, DeployerCase, main

UP, LEFT, HOME = "\x1b[A", "\x1b[D", "\x01"
CTRL_C, CTRL_D, CTRL_R, TAB, RUBOUT = "\x03", "\x04", "\x12", "\t", "\x7f"


class Lines(DeployerCase):
    def test_says_what_can_be_done_and_prompts(self):
        screen = self.open().screen()
        self.assertIn("'help' tells more, 'ls' shows what is here", screen)
        self.assertTrue(screen.endswith("\n" + PROMPT.rstrip()))

    def test_answers(self):
        program = self.open()
        self.assertEqual(" = 5", program.type("2 + 3", PROMPT))
        self.assertEqual("", program.type("", PROMPT))

    def test_the_prompt_tells_place_and_state(self):
        program = self.open()
        program.type('import("filling"); loadComponent("tank", "filling::Tank")', PROMPT)
        program.type("cd tank", "tank [U]> ")
        program.type("capacity = 1.5; configure()", "tank [S]> ")
        program.type("start()", "tank [R]> ")
        program.type("leave", "Watching tank [R]> ")
        program.type("enter", "tank [R]> ")
        program.type("cd ..", PROMPT)

    def test_errors_have_a_caret(self):
        self.assertEqual("console:1:1: error: [OPS134] component 'Deployer' has no operation 'impotr'; did you mean 'import'?\n"
                         'impotr("filling")\n^', self.open().type('impotr("filling")', PROMPT))

    def test_are_edited(self):
        program = self.open()
        program.send("13 + 2" + HOME + "1" + "\x05" + RUBOUT + "3" + LEFT + LEFT + RUBOUT + "-")
        program.wait_for("113 - 3")
        self.assertEqual(" = 110", program.type("", PROMPT))

    def test_letters_of_several_bytes(self):
        program = self.open()
        self.assertEqual(' = "größer"', program.type('"grö' + RUBOUT + 'ößer"', PROMPT))

    def test_letters_of_several_bytes_where_no_locale_is_set(self):
        program = self.open(LC_ALL="C")
        self.assertEqual(' = "größer"', program.type('"größer"', PROMPT))

    def test_bytes_that_are_no_letters_are_left_out(self):
        program = self.open()
        os.write(program.terminal, b'"a\xff\xc3"\r')
        program.wait_for(PROMPT + '"a"\n = "a"\n')

    def test_pasted_ones_are_taken_as_they_are(self):
        program = self.open()
        self.assertIn("\x1b[?2004h", program.written)
        program.send("\x1b[200~if true then {\r\tvar int x = 3\r}\n1 +\t2\n20 + \x1b[201~")
        program.wait(lambda: program.screen().endswith(
            f"{PROMPT}if true then {{\n>     var int x = 3\n> }}\n{PROMPT}1 +    2\n = 3\n{PROMPT}20 +"), "the answers")
        self.assertEqual(" = 23", program.type("3", PROMPT))

    def test_pasted_ones_are_not_echoed_while_others_are_executed(self):
        program = self.open()
        program.send("\x1b[200~" + "".join(f"{i} + 1\r" for i in range(100)) + "\x1b[201~")
        program.wait_for(" = 100\n" + PROMPT.rstrip())
        self.assertIn("".join(f"{PROMPT}{i} + 1\n = {i + 1}\n" for i in range(100)), program.screen())

    def test_go_on_within_braces(self):
        program = self.open()
        program.type("var int n = 1", PROMPT)
        program.type("while n < 100 {", "> ")
        program.type("  n = n * 2", "> ")
        program.type("}", PROMPT)
        self.assertEqual(" = 128", program.type("n", PROMPT))

    def test_long_ones_wrap(self):
        program = self.open()
        terms = " + ".join(["1"] * 60)
        self.assertIn(" = 60", program.type(terms, PROMPT))

    def test_after_a_change_of_the_width_the_output_fits(self):
        program = self.open()
        self.assertGreater(max(map(len, program.type("ls", PROMPT).split("\n"))), 60)
        program.resize(60)
        before = len(program.written)
        program.type("ls", PROMPT)
        written = program.written[before:].replace("\r", "").split("\n")
        self.assertIn("  Properties", written)
        self.assertLessEqual(max(map(len, written[written.index("  Properties"):-1])), 60)


    def test_after_a_change_of_the_width_the_line_is_drawn_anew(self):
        program = self.open()
        line = PROMPT + "1" * 66
        program.send("1" * 66)
        program.wait_for(line)
        program.resize(50)
        # A terminal that wraps what does not fit any more, as most do.
        program.written = program.written.replace(line, line[:50] + "\r\n" + line[50:])
        program.wait(lambda: "\x1b[1A\r\x1b[J" in program.written, "the line")
        program.wait(lambda: program.screen().endswith(f"\n\n{line[:50]}\n{line[50:]}"), "the line")

    def test_is_drawn_anew_when_the_process_goes_on(self):
        program = self.open()
        program.send("20 + 3")
        program.wait_for("20 + 3")
        os.kill(program.pid, signal.SIGSTOP)
        os.waitpid(program.pid, os.WUNTRACED)
        before = len(program.written)
        os.kill(program.pid, signal.SIGCONT)
        program.wait(lambda: PROMPT + "20 + 3" in program.written[before:], "the line")
        self.assertTrue(program.screen().endswith("\n" + PROMPT + "20 + 3"))
        self.assertEqual(" = 23", program.type("", PROMPT))


class Keys(DeployerCase):
    def test_tab_completes_a_word(self):
        program = self.open()
        program.send("unloadC" + TAB)
        program.wait_for(PROMPT + "unloadComponent")
        program.send(CTRL_C)
        program.wait_for_prompt(PROMPT)
        program.send("untr" + TAB)
        program.wait_for(PROMPT + "untrace")

    def test_tab_shows_how_a_word_could_go_on(self):
        program = self.open()
        program.send("kickO" + TAB)
        program.wait_for(PROMPT + "kickOut")
        program.send(TAB)
        program.wait_for("kickOut           kickOutAll        kickOutComponent\n" + PROMPT + "kickOut")
        program.send("All" + TAB + "\r")
        program.wait_for(" = true")

    def test_a_second_tab_shows_the_members_of_a_component(self):
        program = self.open()
        program.type('import("filling"); loadComponent("tank", "filling::Tank")', PROMPT)
        program.send("tan" + TAB + TAB)
        program.wait(lambda: re.search(r"\nCycleCounter +capacity .*\n(.*\n)*" + re.escape(PROMPT) + r"tank\.$",
                                       program.screen()), "the members")

    def test_tab_completes_members_and_files(self):
        (self.directory / "startup.ops").write_text("2 + 2\n")
        program = self.open()
        program.type('import("filling"); loadComponent("tank", "filling::Tank")', PROMPT)
        program.send("ta" + TAB + "capa" + TAB + " = 1.5\r")
        program.wait_for(PROMPT + "tank.capacity = 1.5\n = 1.5\n" + PROMPT.rstrip())
        program.send('runScript("start' + TAB)
        program.wait_for('runScript("startup.ops')

    def test_ctrl_c_forgets_the_line(self):
        program = self.open()
        program.send("kickOutAll()" + CTRL_C)
        program.wait_for(PROMPT + "kickOutAll()^C\n" + PROMPT.rstrip())
        self.assertEqual(" = 2", program.type("1 + 1", PROMPT))

    def test_ctrl_c_on_an_empty_line_does_not_leave(self):
        program = self.open()
        program.send(CTRL_C)
        program.wait_for("^C\n" + PROMPT.rstrip())
        self.assertEqual(" = 2", program.type("1 + 1", PROMPT))

    def test_ctrl_c_forgets_all_rows_of_a_line(self):
        program = self.open()
        before = program.screen().count("\n")
        line = PROMPT + "1" * 250
        program.send("1" * 250 + LEFT * 200 + CTRL_C)
        program.wait(lambda: program.screen().split("\n")[before:] ==
                     [line[:100], line[100:200], line[200:] + "^C", PROMPT.rstrip()], "the prompt")

    def test_tab_shows_words_below_a_line_of_several_rows(self):
        program = self.open()
        before = program.screen().count("\n")
        line = PROMPT + "kickOut + " + "1" * 150
        program.send(line[len(PROMPT):] + LEFT * 153 + TAB)
        rows = [line[:100], line[100:]]
        program.wait(lambda: program.screen().split("\n")[before:] ==
                     rows + ["kickOut           kickOutAll        kickOutComponent"] + rows, "the words")

    def test_ctrl_c_forgets_all_lines_of_a_piece(self):
        program = self.open()
        program.type("while true {", "> ")
        program.send(CTRL_C)
        program.wait_for_prompt(PROMPT)
        self.assertEqual(" = 2", program.type("1 + 1", PROMPT))

    def test_ctrl_d_leaves(self):
        program = self.open()
        program.send(CTRL_D)
        self.assertEqual(0, program.end())


    def test_ctrl_c_ends_a_command_that_waits_for_it(self):
        program = self.open()
        program.send("waitForInterrupt()\r")
        program.wait_for("waiting for an interrupt")
        program.send(CTRL_C)
        program.wait_for(" = (void)\n" + PROMPT.rstrip())
        self.assertEqual(" = 2", program.type("1 + 1", PROMPT))


class History(DeployerCase):
    def test_up_brings_lines_back(self):
        program = self.open()
        program.type("1 + 1", PROMPT)
        program.type("2 + 2", PROMPT)
        program.send(UP + UP)
        program.wait(lambda: program.screen().endswith(PROMPT + "1 + 1"), "the line")
        self.assertEqual(" = 2", program.type("", PROMPT))

    def test_ctrl_r_searches_backwards(self):
        program = self.open()
        for line in "10 + 1", "20 + 2", "30 + 3":
            program.type(line, PROMPT)
        program.send(CTRL_R + "20")
        program.wait_for("bck:20")
        program.send("\r")
        program.wait(lambda: program.screen().count(" = 22") == 2, "the answer")

    def test_an_arrow_key_ends_the_search(self):
        program = self.open()
        program.type("20 + 2", PROMPT)
        program.type("30 + 3", PROMPT)
        program.send(CTRL_R + "20 +")
        program.wait_for("bck:20 +")
        program.send("\x1b[C")
        program.wait(lambda: program.screen().rstrip().endswith(PROMPT + "20 + 2"), "the line")
        program.send("\x05" + "1")
        program.wait_for(PROMPT + "20 + 21")
        program.send("\r")
        program.wait_for(" = 41\n" + PROMPT.rstrip())

    def test_is_kept_across_sessions(self):
        first = self.open()
        first.type("40 + 2", PROMPT)
        first.send("quit\r")
        self.assertEqual(0, first.end())
        self.assertEqual("40 + 2\n", (self.directory / ".tb_history").read_text())
        second = self.open()
        second.send(UP)
        second.wait_for(PROMPT + "40 + 2")
        self.assertEqual(" = 42", second.type("", PROMPT))

    def test_survives_a_kill(self):
        program = self.open()
        program.type("40 + 2", PROMPT)
        os.kill(program.pid, signal.SIGKILL)
        self.assertEqual(-signal.SIGKILL, program.end())
        self.assertEqual("40 + 2\n", (self.directory / ".tb_history").read_text())

    def test_that_is_not_kept_is_told(self):
        program = self.open(ORO_TB_HISTFILE="/nowhere/at/all")
        self.assertIn("\n/nowhere/at/all: what is typed is not kept: No such file or directory\n", program.screen())

    def test_is_where_the_environment_says(self):
        program = self.open(ORO_TB_HISTFILE=str(self.directory / "elsewhere"))
        program.type("1", PROMPT)
        self.assertEqual("1\n", (self.directory / "elsewhere").read_text())
        self.assertFalse((self.directory / ".tb_history").exists())


class Program(DeployerCase):
    def test_after_a_file_that_fails_the_console_opens_and_the_status_stays(self):
        (self.directory / "bad.ops").write_text("nothere()\n")
        program = self.open("-s", "bad.ops")
        self.assertIn("bad.ops:1:1: error: [OPS134]", program.screen())
        self.assertEqual(" = 2", program.type("1 + 1", PROMPT))
        program.send("quit\r")
        self.assertEqual(255, program.end())

    def test_a_line_that_fails_has_no_effect_on_the_status(self):
        program = self.open()
        program.type("nothere()", PROMPT)
        program.send("quit\r")
        self.assertEqual(0, program.end())

    def test_components_run_while_it_is_open_and_are_taken_down_in_order(self):
        (self.directory / "app.ops").write_text('import("filling")\nloadComponent("tank", "filling::Tank")\n'
                                                "tank.capacity = 1.0\ntank.configure()\ntank.start()\n")
        program = self.open("-s", "app.ops", "-l", "info")
        self.assertIn("tank  [R]", program.type("peers", PROMPT))
        program.send("quit\r")
        self.assertEqual(0, program.end())

    def test_a_signal_ends_it_and_restores_the_terminal(self):
        for number in signal.SIGTERM, signal.SIGINT, signal.SIGHUP:
            program = self.open()
            program.send("half a li")
            program.wait_for("half a li")
            os.kill(program.pid, number)
            self.assertEqual(0, program.end())

    def test_colours(self):
        program = self.open(NO_COLOR="")
        self.assertIn("\x1b[1;36mDeployer\x1b[0m", program.written)
        program.type(".light", PROMPT)
        program.type("1 + 1", PROMPT)
        self.assertIn("\x1b[34mDeployer\x1b[0m", program.written)
        program.type(".nocolors", PROMPT)
        before = len(program.written)
        self.assertEqual(" = 2", program.type("1 + 1", PROMPT))
        self.assertNotIn("\x1b[1;3", program.written[before:])

    def test_no_colours_where_they_are_not_wanted(self):
        for environment in {"NO_COLOR": "1"}, {"NO_COLOR": "", "TERM": "dumb"}:
            program = self.open(**environment)
            program.type("1 + 1", PROMPT)
            self.assertNotRegex(program.written, "\x1b\\[[0-9;]*m")


if __name__ == "__main__":
    main()
