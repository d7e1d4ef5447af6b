# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""oro and a real deployer."""
import json
import os
import select
import shutil
import signal
import socket
import subprocess
import time

from oro_case import ORO, OroCase, main, terminal

SCRIPT = """
import("filling")
loadComponent("tank", "filling::Tank")
loadComponent("pump", "filling::Pump")
connect("pump.flow", "tank.flow", ConnPolicy())
setActivity("tank", 0.02, 0, ORO_SCHED_OTHER)
tank.capacity = 1.5
tank.configure()
tank.start()
"""


class Deployed(OroCase):
    def setUp(self):
        super().setUp()
        self.deployer = self.deploy(SCRIPT)

    def test_list_shows_it(self):
        out, _ = self.oro("list")
        self.assertRegex(out, rf"Deployer  {self.deployer.pid}  \d{{4}}-\d\d-\d\d \d\d:\d\d:\d\d  2 +1 \w+, 1 \w+\n")
        found = json.loads(self.oro("list", "--format=json")[0])[0]
        self.assertEqual(out, self.oro("-d", found["socket"], "list")[0])
        self.assertEqual((self.deployer.pid, "gnulinux", ["app.ops"]), (found["pid"], found["target"], found["files"]))

    def test_what_is_there_is_shown(self):
        out, _ = self.oro("tree")
        self.assertIn("tank  filling::Tank  Running  2 properties, ", out)
        self.assertIn("Component Deployer  OCL::DeploymentComponent", self.oro("show", "Deployer")[0])
        out, _ = self.oro("show", "tank")
        self.assertIn("Component tank  filling::Tank  Running\n", out)
        self.assertIn("    capacity  double  = 1.5      m3  What it holds.\n", out)
        self.assertIn("    bool fill(double level)\n      Fills it up to a level. False if that is more than it holds.\n"
                      "      level  in m3\n", out)
        self.assertIn("in   flow   double       <- pump.flow   What comes in. [m3/s]\n", out)
        self.assertIn("\n  Operations of every component\n", out)
        self.assertIn("Property tank.label  string  = \"water\"\n  What is written on its side.\n", self.oro("show", "tank.label")[0])
        self.assertEqual("1.5\n", self.oro("get", "tank.capacity")[0])
        self.assertEqual(1.5, json.loads(self.oro("get", "tank.capacity", "--format=json")[0])["value"])
        _, err = self.oro("get", "tank.capcity", status=1)
        self.assertRegex(err, r"^oro: error: \[LIV\d+\] .*'capcity'.*did you mean 'capacity'\?")

    def test_values_are_set_and_operations_called(self):
        self.assertEqual("2\n", self.oro("set", "tank.capacity", "2")[0])
        self.assertEqual("-0.5\n", self.oro("set", "tank.capacity", "-0.5")[0])
        for number in "-inf", "-nan":
            self.assertEqual(number.replace("-nan", "nan") + "\n", self.oro("set", "tank.capacity", number)[0])
        self.assertEqual('"salt   water"\n', self.oro("set", "tank.label", "salt   water")[0])
        self.oro("set", "tank.capacity", "much", status=1)
        self.oro("set", "tank.capacity", "1.5")
        self.assertEqual("true\n", self.oro("call", "tank.fill", "0.75")[0])
        self.assertEqual("false\n", self.oro("call", "tank.fill", "2.0")[0])
        self.assertEqual("", self.oro("call", "tank.empty")[0])
        self.oro("call", "tank.fill", status=1)
        self.oro("call", "tank.fill", "full", status=1)

    def test_states_change(self):
        self.assertEqual("tank  Stopped\n", self.oro("stop", "tank")[0])
        self.assertEqual("tank  PreOperational\n", self.oro("cleanup", "tank")[0])
        self.assertIn("component 'tank' refuses to start; it is PreOperational", self.oro("start", "tank", status=1)[1])
        self.assertEqual("tank  Stopped\n", self.oro("configure", "tank")[0])
        self.assertEqual("tank  Running\n", self.oro("start", "tank")[0])
        self.oro("start", "tnak", status=1)

    def test_samples_come(self):
        process = self.start_oro("echo", "tank.level")
        self.assertEqual("0\n", process.stdout.readline())
        self.oro("call", "tank.fill", "0.75")
        self.assertEqual("0.75\n", process.stdout.readline())
        process.send_signal(signal.SIGINT)
        self.assertEqual((0, ""), (process.wait(10), process.stderr.read()))
        _, err = self.oro("echo", "tank.levle", status=1)
        self.assertIn("did you mean 'level'?", err)
        self.oro("echo", "tank.capacity", status=1)
        self.oro("echo", "tank", status=1)

    def test_a_deployment_that_is_killed_is_an_error_and_is_not_listed(self):
        process = self.start_oro("echo", "tank.level")
        process.stdout.readline()
        self.deployer.kill()
        self.deployer.wait()
        self.assertEqual(1, process.wait(10))
        self.assertEqual(f"oro: error: deployment 'Deployer' (pid {self.deployer.pid}) has ended\n", process.stderr.read())
        self.assertEqual("", self.oro("list")[0])
        self.assertEqual([], list((self.directory / "oroforge").iterdir()))

    def test_a_stopped_process_is_reported_and_others_are_listed(self):
        self.fake(lambda c, r: c.answer(r, {"components": []}), name="other")
        self.deployer.send_signal(signal.SIGSTOP)
        try:
            out, _ = self.oro("list")
            self.assertRegex(out, rf"Deployer  {self.deployer.pid} +stopped process\n")
            self.assertRegex(out, rf"other  +{os.getpid()} +0")
            _, err = self.oro("get", "tank.capacity", "-d", "Deployer", "--timeout", "0.3", status=1)
            self.assertIn(f"'kill -CONT {self.deployer.pid}' lets it go on", err)
        finally:
            self.deployer.send_signal(signal.SIGCONT)
        self.assertEqual("1.5\n", self.oro("get", "tank.capacity", "-d", "Deployer")[0])

    def test_connections_and_times(self):
        self.assertIn("pump.flow  ->  tank.flow  double  data", self.oro("graph")[0])
        out, _ = self.oro("graph", "--dot")
        self.assertRegex(out, r'"pump" -> "tank" \[taillabel="flow", headlabel="flow"')
        self.assertRegex(self.oro("top", "--interval", "0.2")[0], r"(?m)^tank +Running +20 ms ")

    def test_top_is_drawn_again_until_ctrl_c(self):
        program = self.open_oro("top", "--interval", "0.1")
        program.wait(lambda: program.written.count("COMPONENT") > 2, "the next picture")
        self.assertEqual(1, program.screen().count("COMPONENT"))
        program.send("\x03")
        self.assertEqual(0, program.end())

    def test_the_log_is_followed(self):
        process = self.start_oro("log", "-f", "--level", "Info")
        # The first of these lines may come before it follows.
        self.wait(lambda: self.oro("set", "tank.capacity", "2") and select.select([process.stdout], [], [], 0.1)[0], "a line")
        line = process.stdout.readline()
        while "tank.capacity" not in line:
            self.assertTrue(line, "the log has ended")
            line = process.stdout.readline()
        self.assertRegex(line, r"^\d\d:\d\d:\d\d\.\d{3}  Info      ")
        process.send_signal(signal.SIGINT)
        self.assertEqual(0, process.wait(10))

    def test_the_log_begins_with_its_file(self):
        self.assertIn("writes no log file", self.oro("log", status=1)[1])
        self.environment["ORO_LOGFILE"] = "app.log"
        self.oro("stop")
        self.deployer.wait(15)
        self.deploy(SCRIPT)
        for number in range(5):
            self.oro("set", "tank.capacity", str(number))
        self.oro("call", "tank.fill", "-1")
        out, _ = self.oro("log", "-n", "3")
        self.assertEqual(3, out.count("\n"))
        self.assertRegex(out, r"^\d\d:\d\d:\d\d\.\d{3}  Info      ")
        lines = [json.loads(line) for line in self.oro("log", "-n", "10000", "--format=json")[0].splitlines()]
        self.assertGreater(len(lines), 20)
        self.assertTrue(any("tank.capacity" in one["text"] for one in lines))
        self.assertLess(abs(lines[-1]["time"] / 1e9 - time.time()), 60)
        few = [json.loads(line) for line in self.oro("log", "-n", "10000", "--level", "Warning", "--format=json")[0].splitlines()]
        self.assertEqual([one for one in lines if one["level"] not in ("Info", "Debug")], few)
        self.oro("log", "--level", "loud", status=1)
        self.oro("log", "-n", "many", status=2)
        process = self.start_oro("log", "-f", "-n", "2", "--format=json")
        old = [json.loads(process.stdout.readline()) for _ in range(2)]
        self.oro("set", "tank.capacity", "7")
        new = json.loads(process.stdout.readline())
        while "= 7" not in new["text"] and "7" not in new["text"]:
            self.assertNotIn(new["text"], [one["text"] for one in old])
            new = json.loads(process.stdout.readline())
        process.send_signal(signal.SIGINT)
        self.assertEqual(0, process.wait(10))

    def test_lines_of_the_console(self):
        out, err = self.oro("console", text="tank.capacity\ncd tank\nlabel\ncapasity\n1 + 1\n", status=1)
        self.assertEqual(' = 1.5\n = "water"\n = 2\n', out)
        self.assertIn("did you mean 'capacity'?", err)
        self.assertEqual((" = 2\n", ""), self.oro("console", text="1 + 1\nquit\n3\n"))

    def test_output_of_a_line_comes_as_it_is_written(self):
        program = subprocess.Popen([ORO, "console"], cwd=self.directory, env=self.own(), text=True, stdin=subprocess.PIPE,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.addCleanup(self.end, program)
        program.stdin.write(".watch tank.level 3\n1 + 1\n")
        program.stdin.close()
        program.stdin = None  # communicate() would flush it
        self.oro("call", "tank.fill", "0.25")
        seen = ""
        while "0.25" not in seen:  # the command waits for a third sample
            seen = program.stdout.readline()
            self.assertTrue(seen)
        self.assertIsNone(program.poll())
        self.oro("call", "tank.fill", "0.5")
        self.oro("call", "tank.fill", "0.75")
        rest = program.stdout.read()
        self.assertIn(" = 2\n", rest)
        self.assertLess(rest.index("0.5"), rest.index(" = 2"))
        self.assertEqual(0, program.wait(10))

    def test_the_console_on_a_terminal(self):
        program = self.open_oro("console", NO_COLOR="1")
        prompt = "Deployer [S]> "
        program.wait_for_prompt(prompt)
        self.assertEqual(" = 1.5", program.type("tank.capacity", prompt))
        program.send("tank.cap\t\r")
        program.wait(lambda: program.screen().count("> tank.capacity\n = 1.5\nDeployer") == 2, "the completed line")
        program.wait_for_prompt(prompt)
        program.send("forgotten\x03")
        program.wait_for("forgotten^C")
        program.wait_for_prompt(prompt)
        self.assertEqual(" = 3", program.type("1 + 2", prompt))
        program.send("while true { }\r")
        program.wait(lambda: "while true { }\n" in program.screen(), "the execution")
        self.wait(lambda: self.interrupted(program), "the end of the loop")
        program.send("cd tank\r")
        program.wait_for_prompt("tank [R]> ")
        program.send("\x04")
        self.assertEqual(0, program.end())
        self.assertIn("tank.capacity", (self.directory / ".oro_history").read_text())
        self.oro("get", "tank.capacity")

    def interrupted(self, program):
        program.send("\x03")
        program.read(0.3)
        return "interrupted" in program.screen()

    def test_the_console_ends_with_the_deployment(self):
        program = self.open_oro("console", NO_COLOR="1")
        program.wait_for_prompt("Deployer [S]> ")
        program.send("half a li")
        self.deployer.kill()
        program.wait_for("has ended")
        self.assertEqual(1, program.end())

    def test_stop_ends_the_deployment(self):
        out, _ = self.oro("stop", "--timeout", "15")
        self.assertEqual("deployment 'Deployer' has ended\n", out)
        self.deployer.wait(15)
        self.assertIn("no deployment", self.oro("list")[1])

    def test_stop_reports_a_deployment_that_does_not_end(self):
        self.addCleanup(self.deployer.kill)
        self.oro("call", "Deployer.loadService", "tank", "os")
        _, err = self.oro("call", "tank.os.sleep", "4", "--wait", "0.1", status=1)
        self.assertIn("LIV004", err)
        _, err = self.oro("stop", "--timeout", "1", status=1)
        self.assertIn("deployment 'Deployer' takes longer than --timeout to end", err)
        self.assertIsNone(self.deployer.poll())

    def test_shells_complete_names(self):
        def words(*typed):
            return [line.split("\t")[0] for line in self.oro("__complete", *typed)[0].splitlines()]
        self.assertEqual(["tank"], words("start", "ta"))
        self.assertEqual(["tank."], words("get", "ta"))
        self.assertEqual(["tank.capacity"], words("get", "tank.ca"))
        self.assertEqual(["tank.level"], words("echo", "tank."))
        self.assertEqual(["tank.fill"], words("-d", "Deployer", "call", "tank.f"))
        self.assertEqual([], words("-d", "nobody", "call", "tank.f"))
        self.assertEqual(["Deployer"], words("-d", ""))
        self.oro("call", "loadComponent", "$(touch x) y", "TaskContext")
        for typed, inserted in ("echo tank.le", "tank.level"), ("start \\$", r"\$\(touch\ x\)\ y"):
            script = f'eval "$({ORO} completion bash)"; oro() {{ {ORO} "$@"; }}; COMP_WORDS=(oro {typed}); COMP_CWORD=2; ' \
                     '_oro; echo "${COMPREPLY[*]}"'
            shell = subprocess.run(["bash", "-c", script], env=self.own(), text=True, capture_output=True, timeout=10,
                                   check=True)
            self.assertEqual(inserted + "\n", shell.stdout)

    def own_shell(self, name):
        program = shutil.which(name)
        if not program:
            self.skipTest(f"{name} is not installed")
        return program, {**self.environment, "PATH": f"{os.path.dirname(ORO)}:{os.environ['PATH']}"}

    def test_fish_completes_names(self):
        fish, environment = self.own_shell("fish")
        script = 'oro completion fish | source; complete -C "oro echo tank.le"; complete -C "oro get ta"; complete -C "oro sta"'
        shell = subprocess.run([fish, "-c", script], env=self.own(**environment), text=True, capture_output=True, timeout=20,
                               check=True)
        self.assertEqual("tank.level\tWhat is in it. [m3]\ntank.\tRunning\nstart\tstarts a component\n", shell.stdout)

    def test_zsh_completes_names(self):
        zsh, environment = self.own_shell("zsh")
        with terminal.Program([zsh, "-f", "-i"], self.directory, environment, 100) as shell:
            shell.send('PS1="> "; autoload -U compinit; compinit -u -D; eval "$(oro completion zsh)"; echo be""gun\r')
            shell.wait_for("begun\n>")
            for typed, completed in ("oro echo tank.le", "oro echo tank.level "), ("oro get ta", "oro get tank."):
                shell.send(f"{typed}\t")
                shell.wait_for(f"> {completed}".rstrip())
                shell.send("\x15")
                shell.wait_for_prompt("> ")


class SlowReader(OroCase):
    """A client that sends many requests before it reads an answer."""

    def connect(self):
        client = socket.socket(socket.AF_UNIX)
        self.addCleanup(client.close)
        client.connect(str(next((self.directory / "oroforge").glob("*.sock"))))
        client.sendall(b"GET / HTTP/1.1\r\nHost: localhost\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                       b"Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\nSec-WebSocket-Version: 13\r\n"
                       b"Sec-WebSocket-Protocol: oro.v1\r\n\r\n")
        stream = client.makefile("rb")
        while stream.readline() != b"\r\n":
            pass
        return client, stream

    def read(self, stream):
        size = stream.read(2)[1]
        if size >= 126:
            size = int.from_bytes(stream.read(2 if size == 126 else 8), "big")
        return json.loads(stream.read(size))

    def test_answers_that_wait_have_a_limit(self):
        self.deploy(SCRIPT + 'tank.label = "' + "x" * 300000 + '"\n')
        client, stream = self.connect()
        count = 60
        for number in range(count):
            request = json.dumps({"op": "oro.get", "id": number, "path": "tank.label", "timeout": 20}).encode()
            client.sendall(bytes([0x81, 0x80 | len(request), 0, 0, 0, 0]) + request)
        self.oro("tree")  # others are served
        time.sleep(2)
        answers = [self.read(stream) for _ in range(count)]
        self.assertEqual(set(range(count)), {one["id"] for one in answers})
        left_out = [one for one in answers if one["op"] == "oro.error"]
        self.assertEqual({"LIV010"}, {one["code"] for one in left_out})
        self.assertGreater(count - len(left_out), 10)


class OnTheNetwork(OroCase):
    def test_an_address_with_its_token(self):
        self.deploy(SCRIPT, "--web=127.0.0.1:0")
        url = next(line for line in self.said if "token=" in line).split()[-1]
        self.assertIn("tank", self.oro("tree", "--url", url)[0])
        bare, token = url.split("?token=")
        self.assertIn("tank", self.oro("tree", "--url", bare, ORO_TOKEN=token)[0])
        _, err = self.oro("tree", "--url", bare, status=1)
        self.assertIn("refuses the connection (HTTP 401); give the token", err)
        self.oro("set", "tank.capacity", "3", "--url", url, status=1)
        self.oro("tree", "--url", url, "-d", "Deployer", status=2)
        self.oro("tree", "--url", "ws://127.0.0.1:1", status=3)


main()
