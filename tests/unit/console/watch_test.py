# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""`.watch` and `.hz` on a terminal: drawn again in place, until a key ends them."""
from deployer_case import PROMPT, DeployerCase, main

CTRL_C = "\x03"
LOAD = 'import("filling"); loadComponent("tank", "filling::Tank"); tank.capacity = 9.0; tank.configure() && tank.start()'
# Another component fills it while the console is busy.
RISE = "program rise { while tank.fillings < 1000 { tank.fill(0.001 * tank.fillings); for (var int n = 0; n < 9; n = n + 1) { yield } } }"


class Watch(DeployerCase):
    def tank(self, **environment):
        program = self.open(**environment)
        program.type(LOAD, PROMPT)
        return program

    def begin(self, program, line, shown):
        """Types it and waits for what it shows; the number of rows before that."""
        rows = program.screen().count("\n") + 1
        program.send(line + "\r")
        program.wait(lambda: "\n".join(program.screen().split("\n")[rows:]).strip() == shown, shown)
        return rows

    def rise(self, program):
        program.type('setActivity("Deployer", 0.01, 0, ORO_SCHED_OTHER)', PROMPT)
        program.type(RISE, PROMPT)

    def test_enter_ends_it_and_makes_no_line(self):
        program = self.tank()
        rows = self.begin(program, ".watch tank.level", "tank.level  double  sample 1; Enter ends this\n    0")
        program.send("\r")
        program.wait_for_prompt(PROMPT)
        self.assertEqual(PROMPT.rstrip(), program.screen().split("\n")[rows + 2])
        self.assertEqual(" = 2", program.type("1 + 1", PROMPT))
        self.assertIn("not connected", program.type("ls tank", PROMPT).split("level ")[-1])

    def test_new_samples_take_the_place_of_old_ones(self):
        program = self.tank()
        self.rise(program)
        program.type("rise.start(); start();", "Deployer [R]> ")
        shown = program.type(".watch tank.level 4", "Deployer [R]> ").split("\n")
        self.assertEqual(2, len(shown), shown)
        self.assertEqual("tank.level  double  sample 4; Enter ends this", shown[0])
        self.assertRegex(shown[1], r"^    0\.\d+$")

    def test_a_line_that_is_typed_ends_it_and_is_executed(self):
        program = self.tank()
        self.begin(program, ".watch tank.level", "tank.level  double  sample 1; Enter ends this\n    0")
        program.send("20 + 3\r")
        program.wait_for(" = 23\n" + PROMPT.rstrip())

    def test_ctrl_c_ends_it_without_an_error(self):
        program = self.tank()
        for line, shown in ((".watch tank.level", "tank.level  double  sample 1; Enter ends this\n    0"),
                            (".hz tank.level", "counting; Enter ends this")):
            self.begin(program, line, shown)
            program.send(CTRL_C)
            program.wait_for_prompt(PROMPT)
            self.assertNotIn("error", program.screen())
        self.assertEqual(" = 2", program.type("1 + 1", PROMPT))

    def test_the_rate_is_drawn_again(self):
        program = self.tank()
        rows = self.begin(program, ".hz tank.level", "counting; Enter ends this")
        program.wait(lambda: program.screen().split("\n")[rows].startswith("0 samples"), "the rate")
        program.send("\r")
        program.wait_for_prompt(PROMPT)
        self.assertEqual("0 samples", program.screen().split("\n")[rows])

    def test_a_terminal_that_cannot_erase_gets_lines(self):
        program = self.tank(TERM="dumb")
        program.send(".hz tank.level\r")
        program.wait_for("counting; Enter ends this\n0 samples")
        program.send("\r")
        program.wait(lambda: program.screen().endswith(PROMPT.rstrip()), "the prompt")

    def test_a_pipe_gets_lines_and_needs_a_number(self):
        out, err = self.run_with(LOAD + ";\n.watch tank.level 1\n.watch tank.level\n", status=255)
        self.assertEqual("0\n", out)
        self.assertIn("stdin:3:18: error: expected a number, because no key ends the command here", err)


if __name__ == "__main__":
    main()
