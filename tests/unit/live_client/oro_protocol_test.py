# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""oro against deployments that do what they should not."""
import json
import os
import signal
import socket
import subprocess
import sys
import time

from fake_deployment import CLOSE, PING, frame
from oro_case import ORO, OroCase, main

SAMPLE = {"op": "oro.sample", "id": 0, "time": 1_000_000_000, "value": 0.5, "dropped": 0}


def port(client, request, samples=(), then=None):
    """Answers as a deployment with one port, tank.level."""
    if request["op"] == "oro.show":
        if request["path"] != "tank.level":
            return client.refuse(request, "LIV003", f"component 'tank' has no '{request['path']}'")
        return client.answer(request, {"kind": "port", "path": "tank.level", "connections": []})
    if request["op"] == "oro.watch":
        client.answer(request, {"type": "double"})
        for sample in samples:
            client.send({**SAMPLE, **sample, "id": request["id"]})
        return then(client) if then else None
    return client.refuse(request, "LIV002", "unknown")


class Protocol(OroCase):
    def test_without_a_deployment_the_status_is_3(self):
        _, err = self.oro("tree", status=3)
        self.assertEqual(f"oro: error: no deployment is running in '{self.directory}/oroforge'; start one with 'deployer', as the "
                         "same user, with the same XDG_RUNTIME_DIR and without --no-live\n", err)

    def test_several_deployments_are_listed(self):
        self.fake(lambda c, r: c.answer(r, {"components": []}), name="arm")
        self.fake(lambda c, r: c.answer(r, {"components": []}), name="base")
        _, err = self.oro("tree", status=3)
        self.assertIn(f"there is more than one deployment: 'arm' (pid {os.getpid()}), 'base' (pid {os.getpid()}); choose "
                      "one with --deployment or ORO_DEPLOYMENT", err)
        self.oro("tree", "-d", "base")
        self.oro("-d", "arm", "tree")
        self.oro("tree", ORO_DEPLOYMENT="arm")
        _, err = self.oro("tree", "-d", "bse", status=3)
        self.assertIn("there is no deployment 'bse'; did you mean 'base'?; running: 'arm'", err)

    def test_the_path_of_a_socket_is_a_deployment(self):
        fake = self.fake(lambda c, r: c.answer(r, {"components": []}), name="arm")
        self.oro("tree", "-d", str(fake.path), XDG_RUNTIME_DIR="/nowhere")
        self.oro("tree", "-d", str(fake.path) + "x", status=3)

    def test_an_error_of_the_deployment_has_its_code_and_status_1(self):
        self.fake(lambda c, r: c.refuse(r, "LIV003", "there is no 'arm.gian'"))
        _, err = self.oro("get", "arm.gian", status=1)
        self.assertEqual("oro: error: [LIV003] there is no 'arm.gian'\n", err)

    def test_answers_in_another_order_and_unknown_messages_are_sorted(self):
        def handle(client, request):
            client.send({"op": "serverInfo", "name": "x"})
            client.send({"op": "oro.answer", "id": request["id"] + 7, "result": {"text": "wrong"}})
            client.raw(frame(b"", PING))
            client.answer(request, {"text": "right"})
        self.fake(handle)
        self.assertEqual("right\n", self.oro("get", "a.b")[0])

    def test_what_is_no_json_object_is_an_error(self):
        for text in b"{", b"[1]", b"\"x\"", b"", b"[" * 100000, b'{"op":"oro.answer","id":1,"result":' + b"[" * 5000:
            fake = self.fake(lambda c, r, text=text: c.raw(frame(text)))
            _, err = self.oro("get", "a.b", status=1)
            self.assertIn("sends a message that is no JSON object", err, text[:20])
            fake.close()

    def test_fields_of_other_types_do_not_crash_it(self):
        junk = [None, 1, "x", [], [1], {"a": {}}, {"components": 5}, {"components": [1, None, {"name": 3}]},
                {"properties": "x", "ports": [[]], "operations": [{"arguments": 3}], "kind": "component"},
                {"kind": "operation", "arguments": [7]}, {"kind": 5, "connections": [[1]]}, {"words": [1, "a"]}]
        for result in junk:
            fake = self.fake(lambda c, r, result=result: c.answer(r, result))
            for words in (("list",), ("tree",), ("show", "a"), ("get", "a"), ("set", "a", "1"), ("call", "a"), ("graph",),
                          ("graph", "--dot"), ("top",), ("start", "a"), ("__complete", "show", "a.")):
                done = subprocess.run([ORO, *words], env=self.own(), capture_output=True, timeout=20, check=False)
                self.assertIn(done.returncode, (0, 1), (words, result, done.stderr))
                self.assertNotIn(b"not expected", done.stderr, (words, result))
            fake.close()

    def test_a_huge_frame_is_an_error(self):
        self.fake(lambda c, r: c.raw(b"\x81\x7f" + (1 << 40).to_bytes(8, "big")))
        _, err = self.oro("get", "a.b", status=1)
        self.assertIn("ended the connection: a message of more than 64 MiB", err)

    def test_broken_frames_are_errors(self):
        for data in b"\xff\xff\xff\xff", frame(b"\xff\xfe"), b"\x83\x00", b"\x81\x85abcd":
            fake = self.fake(lambda c, r, data=data: c.raw(data) or False)
            _, err = self.oro("get", "a.b", status=1)
            self.assertIn("fake", err)
            fake.close()

    def test_control_characters_do_not_reach_the_terminal(self):
        self.fake(lambda c, r: c.answer(r, {"text": "a\033[2Jb\u009bc"}))
        self.assertEqual("a?[2Jb?c\n", self.oro("get", "a.b")[0])

    def test_silence_is_an_error_in_time(self):
        self.fake(lambda c, r: None)
        begin = time.monotonic()
        _, err = self.oro("get", "a.b", "--timeout", "0.3", status=1)
        self.assertLess(time.monotonic() - begin, 3)
        self.assertIn(f"deployment 'fake' (pid {os.getpid()}) does not answer within 0.3 s; --timeout gives it more time", err)

    def test_another_program_is_no_deployment(self):
        self.fake(lambda c, r: None, protocol="chat")
        _, err = self.oro("get", "a.b", status=1)
        self.assertIn("is no deployment: it does not speak 'oro.v1'", err)

    def test_list_shows_who_answers_beside_who_does_not(self):
        hello = {"name": "fake", "pid": 1, "started": 1_700_000_000_000_000_000}
        tree = {"components": [{"name": "fake", "state": "Stopped"}, {"name": "a", "state": "Running"},
                               {"name": "b", "state": "Running"}, {"name": "c", "state": "Exception"}]}
        self.fake(lambda c, r: c.answer(r, hello if r["op"] == "oro.hello" else tree), name="fake")
        self.fake(lambda c, r: None, name="mute")
        out, _ = self.oro("list", TZ="UTC")
        lines = out.splitlines()
        self.assertRegex(lines[1], rf"fake  {os.getpid()}  2023-11-14 22:13:20  3 +2 Running, 1 Exception")
        self.assertRegex(lines[2], rf"mute  {os.getpid()} +does not answer")
        found = json.loads(self.oro("list", "--format=json")[0])
        self.assertEqual(["fake", "mute"], [one["name"] for one in found])
        self.assertEqual({"name": "c", "state": "Exception"}, found[0]["components"][2])
        self.assertEqual("does not answer", found[1]["problem"])
        chosen = json.loads(self.oro("list", "--format=json", "-d", "fake")[0])
        self.assertEqual(["fake"], [one["name"] for one in chosen])
        self.assertIn("this deployment is not running", self.oro("list", "-d", "nobody")[1])

    def test_sockets_of_dead_processes_are_removed(self):
        dead = subprocess.Popen([sys.executable, "-c", ""])
        dead.wait()
        folder = self.directory / "oroforge"
        folder.mkdir(mode=0o700)
        left = folder / f"{dead.pid}-old.sock"
        with socket.socket(socket.AF_UNIX) as one:
            one.bind(str(left))
        other = folder / f"{dead.pid}-file.sock"
        other.write_text("no socket")
        self.assertIn("no deployment of this user is running", self.oro("list")[1])
        self.assertFalse(left.exists())
        self.assertTrue(other.exists())

    def test_a_socket_that_was_left_does_not_count_if_its_number_is_that_of_another_process(self):
        self.fake(lambda c, r: c.answer(r, {"components": []}), name="arm")
        with socket.socket(socket.AF_UNIX) as one:
            one.bind(str(self.directory / "oroforge" / f"{os.getppid()}-old.sock"))
        self.oro("tree")
        self.assertNotIn("old", self.oro("list")[0])

    def test_a_path_that_is_too_long_for_a_socket_leads_through_its_folder(self):
        fake = self.fake(lambda c, r: c.answer(r, {"components": []}), name="arm")
        runtime = self.directory / ("x" * 120)
        runtime.mkdir(mode=0o700)
        fake.folder.rename(runtime / "oroforge")
        self.oro("tree", XDG_RUNTIME_DIR=str(runtime))
        self.oro("tree", "-d", str(runtime / "oroforge" / fake.path.name))
        self.assertIn("arm", self.oro("list", XDG_RUNTIME_DIR=str(runtime))[0])
        with socket.socket(socket.AF_UNIX) as one:
            folder = os.open(runtime / "oroforge", os.O_PATH)
            self.addCleanup(os.close, folder)
            one.bind(f"/proc/self/fd/{folder}/99999999-old.sock")
        self.oro("list", XDG_RUNTIME_DIR=str(runtime))
        self.assertFalse((runtime / "oroforge" / "99999999-old.sock").exists())

    def test_a_request_that_is_too_long_is_not_sent(self):
        fake = self.fake(lambda c, r: c.answer(r, {}))
        _, err = self.oro("get", "a" * 70000, status=1)
        self.assertRegex(err, "the request 'get' has 70[0-9]{3} bytes, more than the 65536 that a deployment takes")
        self.assertEqual([], fake.requests)

    def test_an_empty_name_is_not_the_whole_deployment(self):
        fake = self.fake(lambda c, r: c.answer(r, {}))
        for command in "stop", "start", "cleanup", "configure", "recover", "tree":
            self.assertIn("COMPONENT is an empty text", self.oro(command, "", status=2)[1])
        for words in ("show", ""), ("get", ""), ("echo", ""), ("call", ""), ("set", "", "1"):
            self.assertIn("is an empty text", self.oro(*words, status=2)[1])
        self.assertIn("the value of --deployment is an empty text", self.oro("-d", "", "stop", status=2)[1])
        self.assertEqual([], fake.requests)
        self.oro("set", "a.b", "")

    def test_a_folder_that_others_can_write_to_is_not_used(self):
        fake = self.fake(lambda c, r: c.answer(r, {}))
        fake.folder.chmod(0o777)
        self.oro("tree", status=3)

    def test_a_command_line_that_is_wrong_has_status_2(self):
        for words, text in (((), "no command was given"), (("frob",), "unknown command 'frob'"),
                            (("ech", "x"), "did you mean 'echo'?"), (("echo",), "PORT is required"),
                            (("echo", "a.b", "--cvs"), "unknown option '--cvs'; did you mean '--csv'?"),
                            (("tree", "a", "b"), "'oro tree' has no use for 'b'"),
                            (("echo", "a.b", "--count", "-1"), "--count: '-1' is no number between 1 and"),
                            (("get", "a", "--timeout", "soon"), "--timeout: 'soon' is no number"),
                            (("tree", "--url", "wss://x"), "a protocol that oro does not speak"),
                            (("tree", "--url", "ws://x:99999"), "has no port between 1 and 65535"),
                            (("get", "a", "--format", "xml"), "--format"), (("completion", "csh"), "expected bash, zsh or fish"),
                            (("man", "frob"), "there is no command 'frob'")):
            self.assertIn(text, self.oro(*words, status=2)[1], words)

    def test_values_that_look_like_options_are_values(self):
        fake = self.fake(lambda c, r: c.answer(r, {"text": ""}))
        self.oro("set", "a.b", "-0.5")
        self.oro("set", "a.b", "[1, 2]")
        self.oro("call", "a.b", "-1", "[1, 2]", "text", '"5"', "--timeout", "3")
        self.assertEqual(["-0.5", "[1, 2]"], [r["text"] for r in fake.requests[:2]])
        self.oro("set", "a.b", "\x01x")
        self.assertEqual("\x01x", fake.requests.pop()["text"])
        self.assertEqual(["-1", "[1, 2]", "text", "5"], fake.requests[2]["arguments"])


class Samples(OroCase):
    def test_forms_of_samples(self):
        values = [{"value": {"x": 1.5, "name": "a\"b", "list": [1, 2]}}, {"value": {"x": -2.0, "name": "c", "list": [3, 4]},
                                                                         "time": 1_500_000_001, "dropped": 3},
                  {"value": {}, "dropped": 3}]
        self.fake(lambda c, r: port(c, r, values))
        out, err = self.oro("echo", "tank.level", "--count", "3")
        self.assertEqual('{x = 1.5, name = "a\\"b", list = [1, 2]}\n{x = -2, name = "c", list = [3, 4]}\n{}\n', out)
        self.assertEqual(1, err.count("3 samples were dropped here"))
        out, _ = self.oro("echo", "tank.level", "--count", "2", "--csv")
        self.assertEqual('time,x,name,list[0],list[1]\n1.000000000,1.5,"a""b",1,2\n1.500000001,-2,c,3,4\n', out)
        out, _ = self.oro("echo", "tank.level", "--once", "--json")
        self.assertEqual({"time": 1_000_000_000, "value": values[0]["value"], "dropped": 0}, json.loads(out))
        self.assertEqual("1.5\n", self.oro("echo", "tank.level", "--once", "--field", "x")[0])
        self.assertEqual("2\n", self.oro("echo", "tank.level.list[1]", "--once")[0])
        _, err = self.oro("echo", "tank.level", "--once", "--field", "nam", status=1)
        self.assertIn("samples of port 'tank.level' have no field 'nam'; did you mean 'name'?; they have x, name, list[0]", err)

    def test_samples_whose_sequence_is_shorter_are_left_out(self):
        self.fake(lambda c, r: port(c, r, [{"value": {"list": list(range(n))}} for n in (0, 3, 1, 4)]))
        out, err = self.oro("echo", "tank.level.list[2]", "--count", "2")
        self.assertEqual("2\n2\n", out)
        self.assertEqual(1, err.count("samples without 'list[2]'"))

    def test_the_reader_of_a_pipe_that_goes_ends_it(self):
        self.fake(lambda c, r: port(c, r, [{}]))
        shell = subprocess.run(["bash", "-c", f"set -o pipefail; {ORO} echo tank.level | head -1"], env=self.own(), text=True,
                               capture_output=True, timeout=10, check=False)
        self.assertEqual((0, "0.5\n", ""), (shell.returncode, shell.stdout, shell.stderr))

    def test_a_full_disk_is_an_error(self):
        self.fake(lambda c, r: port(c, r, [{}]))
        shell = subprocess.run(["bash", "-c", f"{ORO} echo tank.level > /dev/full"], env=self.own(), text=True,
                               capture_output=True, timeout=10, check=False)
        self.assertEqual(1, shell.returncode)
        self.assertIn("cannot write the output: No space left on device", shell.stderr)

    def test_a_deployment_that_ends_is_an_error(self):
        for then in (lambda c: False, lambda c: c.raw(frame(b"\x03\xe9the deployment ends", CLOSE))):
            fake = self.fake(lambda c, r, then=then: port(c, r, [{}], then))
            process = self.start_oro("echo", "tank.level")
            self.assertEqual(1, process.wait(10))
            self.assertIn("deployment 'fake'", process.stderr.read())
            fake.close()

    def test_ctrl_c_ends_with_status_0_and_a_summary(self):
        samples = [{"time": 1_000_000_000 + i * 100_000_000} for i in range(101)]
        self.fake(lambda c, r: port(c, r, samples))
        process = self.start_oro("hz", "tank.level", "--interval", "0.1")
        self.assertIn("10 Hz", process.stdout.readline() + process.stdout.readline())
        process.send_signal(signal.SIGINT)
        out, err = process.communicate(timeout=10)
        self.assertEqual((0, ""), (process.returncode, err))
        self.assertRegex(out.splitlines()[-1], r"^in all: 10 Hz  interval min 100 ms  max 100 ms  deviation \S+ us  101 samples$")

    def test_samples_that_were_dropped_count(self):
        self.fake(lambda c, r: port(c, r, [{"time": 1_000_000_000 + i * 1_000_000, "dropped": i} for i in range(101)]))
        out, _ = self.oro("hz", "tank.level", "--count", "1", "--interval", "0.2")
        self.assertRegex(out, r"^2000 Hz  interval min 1\S* \S+  max 1 ms  deviation \S+ us  101 samples, 100 dropped\n$")

    def test_delay_finds_time_stamps(self):
        def delay(value, *words):
            fake = self.fake(lambda c, r: port(c, r, [{"value": value}]))
            out, _ = self.oro("delay", "tank.level", "--count", "1", "--interval", "0.2", "--format=json", *words)
            fake.close()
            return json.loads(out)["mean"]
        real, steady = time.time(), time.monotonic()
        self.assertAlmostEqual(2, delay(real - 2), delta=1)
        self.assertAlmostEqual(2, delay({"header": {"stamp": int((real - 2) * 1e9)}}), delta=1.5)
        self.assertAlmostEqual(2, delay({"stamp": {"sec": int(real) - 2, "nanosec": 0}}), delta=2)
        self.assertAlmostEqual(2, delay({"a": {"b": int((steady - 2) * 1e9)}}, "--field", "a.b"), delta=2)
        self.fake(lambda c, r: port(c, r, [{"value": {"x": "y"}}]))
        self.assertIn("no time stamp that is known", self.oro("delay", "tank.level", status=1)[1])

    def test_a_curve_is_drawn_without_a_terminal(self):
        samples = [{"time": 1_000_000_000 + i * 100_000_000, "value": v} for i, v in enumerate([0, 1, "NaN", 4, 2])]
        self.fake(lambda c, r: port(c, r, samples))
        out, _ = self.oro("plot", "tank.level", "--count", "5", "--seconds", "1", "--height", "6")
        lines = out.splitlines()
        self.assertEqual("tank.level  = 2", lines[0])
        self.assertTrue(lines[1].startswith("         4 ┤"), out)
        self.assertTrue(lines[5].startswith("         0 ┤"), out)
        self.assertRegex(lines[6], r"-1 s .* now$")
        self.assertRegex(out, "[\u2801-\u28ff]")
        points = json.loads(self.oro("plot", "tank.level", "--count", "2", "--format=json")[0])["points"]
        self.assertEqual([[0, 0], [0.1, 1]], points)

    def test_a_table_for_a_terminal_has_no_control_characters(self):
        text = "\x1b[31mred\x9b\x07"
        self.fake(lambda c, r: port(c, r, [{"value": text}]))
        self.assertIn(text, self.oro("echo", "tank.level", "--csv", "--once")[0])
        program = self.open_oro("echo", "tank.level", "--csv", "--once")
        program.wait_for("?[31mred??")
        self.assertEqual(0, program.end())

    def test_a_curve_is_drawn_on_a_terminal_until_ctrl_c(self):
        self.fake(lambda c, r: port(c, r, [{}, {"time": 2_000_000_000, "value": 1.5}]))
        program = self.open_oro("plot", "tank.level", "--height", "6")
        program.wait_for("tank.level  = 1.5")
        program.wait(lambda: program.written.count("tank.level") > 2, "the next picture")
        program.send("\x03")
        self.assertEqual(0, program.end())
        self.assertEqual(1, program.screen().count("tank.level"))


main()
